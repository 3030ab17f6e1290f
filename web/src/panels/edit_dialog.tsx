import { useEffect } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import { cancelableRequest } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { Slider } from "../ui/slider";
import { titleOf } from "./recordings";
import { type Edits, useSaving, Waiting } from "./simulated";

const { edit: words } = texts;
export type EditKind = "drop" | "trim" | "shift";

/** The segment that is edited. */
export interface EditedSegment {
  number: number;
  title: string;
  seconds: number;
  /** The last segment that is shifted with it. */
  last: number;
}

/** What becomes of a recording by an edit, as docs/editing.md has it. */
interface Report {
  ends_the_same: boolean;
  seconds_before: number;
  seconds_after: number;
  left_out: { line: number; reason: string }[];
  displaced: { id: string; distance_mm: number; rotation_deg: number }[];
  gone: string[];
  there_again: string[];
  controls: { id: string; before: string; after: string }[];
  host_points: { id: string }[];
  joints: (string | { id: string })[];
}

/** Longer lists are cut: they are too long to read. */
const MAX_SENTENCES = 8;
const PAUSE_MS = 300;
const TRIM_STEPS = 200;
/** [s]; a longer way takes several edits. */
const MAX_SHIFT = 5;

function sentencesOf(report: Report): string[] {
  const sentences = [
    ...report.left_out.map(({ reason }) => words.leftOut(reason)),
    ...report.gone.map(words.gone),
    ...report.there_again.map(words.thereAgain),
    ...report.displaced.map((one) => words.displaced(one.id, one.distance_mm, one.rotation_deg)),
    ...report.controls.map((one) => words.control(one.id, one.before, one.after)),
    ...report.host_points.map(({ id }) => words.hostPoint(id)),
    ...report.joints.map((joint) => words.joint(typeof joint === "string" ? joint : joint.id)),
  ];
  if (sentences.length <= MAX_SENTENCES) return sentences;
  return [...sentences.slice(0, MAX_SENTENCES), words.andMore(sentences.length - MAX_SENTENCES)];
}

type Trial = { state: "trying" } | { state: "refused"; error: string } | { state: "simulated"; report: Report };

function Effect({ trial }: { trial: Trial }) {
  if (trial.state === "trying") {
    return <Waiting what="try_edit" label={words.trying} />;
  }
  if (trial.state === "refused") return <p class="trouble">{trial.error}</p>;
  const { report } = trial;
  return (
    <>
      <p>{words.lasts(report.seconds_after, report.seconds_before)}</p>
      {report.ends_the_same && <p class="hint right">{words.same}</p>}
      <ul class="effects">
        {sentencesOf(report).map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </>
  );
}

/** The effect of an edit, as soon as it is simulated; simulated again whenever one of its numbers changes. */
function useTrial(recording: string, edits: Edits, numbers: number[]) {
  const trial = useSignal<Trial>({ state: "trying" });
  useEffect(() => {
    let isLatest = true;
    trial.value = { state: "trying" };
    let cancel = () => {};
    const timer = setTimeout(() => {
      const trying = cancelableRequest("try_edit", { recording, edits });
      cancel = trying.cancel;
      trying.answer.then(
        (reply) => isLatest && (trial.value = { state: "simulated", report: reply.report as Report }),
        (error: Error) => isLatest && (trial.value = { state: "refused", error: error.message }),
      );
    }, PAUSE_MS);
    return () => {
      isLatest = false;
      clearTimeout(timer);
      cancel();
    };
  }, numbers);
  return trial;
}

/** Where a trimmed segment begins and ends [s]. */
function Ends({ from, to, seconds }: { from: Signal<number>; to: Signal<number>; seconds: number }) {
  // So that both ends can be reached.
  const common = { step: seconds / TRIM_STEPS, digits: 2, unit: "s" };
  return (
    <>
      <Slider
        {...common}
        label={words.from}
        value={from.value}
        min={0}
        max={to.value}
        onInput={(value) => (from.value = value)}
      />
      <Slider
        {...common}
        label={words.to}
        value={to.value}
        min={from.value}
        max={seconds}
        onInput={(value) => (to.value = value)}
      />
    </>
  );
}

/** Shows the effect of an edit first; on request saves the edit as a new recording. */
export function EditDialog(props: {
  kind: EditKind;
  recording: string;
  segment: EditedSegment;
  onClose: () => void;
}) {
  const { kind, recording, segment } = props;
  const from = useSignal(0);
  const to = useSignal(segment.seconds);
  const later = useSignal(0);
  const name = useSignal(words.nameOf(titleOf(recording)));
  const edits: Edits = {
    drop: [{ do: "drop", first: segment.number, last: segment.number }],
    trim: [{ do: "trim", segment: segment.number, from: from.value, to: to.value }],
    shift: [{ do: "shift", first: segment.number, last: segment.last, seconds: later.value }],
  }[kind];
  const trial = useTrial(recording, edits, [from.value, to.value, later.value]);
  const { isSaving, save, cancel } = useSaving(props.onClose);
  const close = () => {
    cancel();
    props.onClose();
  };
  return (
    <Dialog
      title={words.titles[kind](segment.title)}
      onClose={close}
      actions={
        <>
          <Button label={texts.cancel} onClick={close} />
          <Button
            label={words.save}
            kind="accent"
            isBusy={isSaving.value}
            disabled={trial.value.state !== "simulated" || name.value === ""}
            onClick={() => void save(recording, edits, name.value)}
          />
        </>
      }
    >
      <p class="hint">{words.original}</p>
      {kind === "trim" && <Ends from={from} to={to} seconds={segment.seconds} />}
      {kind === "shift" && (
        <Slider
          label={words.later}
          value={later.value}
          min={-MAX_SHIFT}
          max={MAX_SHIFT}
          step={0.05}
          digits={2}
          unit="s"
          onInput={(value) => (later.value = value)}
        />
      )}
      <section class="effect" aria-label={words.effect} role="status">
        <h3>{words.effect}</h3>
        <Effect trial={trial.value} />
      </section>
      {isSaving.value && <Waiting what="edit" label={words.saving} />}
      <label class="field">
        <span class="field-label">{words.name}</span>
        <input type="text" value={name.value} maxLength={200} onInput={(event) => (name.value = event.currentTarget.value)} />
      </label>
    </Dialog>
  );
}
