import { useSignal, type Signal } from "@preact/signals";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { Slider } from "../ui/slider";
import { Switch } from "../ui/switch";
import { Effect, useTrial } from "./effect";
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
  /** The segment in which its hand leaves what it takes in this one, or takes what it leaves. */
  otherEnd: { number: number; title: string } | null;
}

const TRIM_STEPS = 200;
/** [s]; a longer way takes several edits. */
const MAX_SHIFT = 5;

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
  const withOtherEnd = useSignal(true);
  const dropped = [segment.number, ...(withOtherEnd.value && segment.otherEnd ? [segment.otherEnd.number] : [])];
  const edits: Edits = {
    drop: dropped.sort((a, b) => b - a).map((number) => ({ do: "drop", first: number, last: number })),
    trim: [{ do: "trim", segment: segment.number, from: from.value, to: to.value }],
    shift: [{ do: "shift", first: segment.number, last: segment.last, seconds: later.value }],
  }[kind];
  const trial = useTrial(recording, edits, [from.value, to.value, later.value, dropped.length]);
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
      {kind === "drop" && segment.otherEnd && (
        <Switch
          label={words.dropToo(segment.otherEnd.title)}
          isOn={withOtherEnd.value}
          onChange={(isOn) => (withOtherEnd.value = isOn)}
        />
      )}
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
