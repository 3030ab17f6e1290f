// What comes of an edit, while it is chosen.

import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import type { Conflict } from "../protocol";
import { cancelableRequest } from "../studio";
import { texts } from "../texts";
import { type Edits, Waiting } from "./simulated";

const { edit: words } = texts;

/** What becomes of a recording by an edit, as docs/editing.md has it. */
export interface Report {
  ends_the_same: boolean;
  seconds_before: number;
  seconds_after: number;
  left_out: { line: number; reason: string }[];
  conflicts: Conflict[];
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

export function sentencesOf(report: Report): string[] {
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

export type Trial = { state: "trying" } | { state: "refused"; error: string } | { state: "simulated"; report: Report };

export function Effect({ trial }: { trial: Trial }) {
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

/** The effect of an edit, as soon as it is simulated; simulated again whenever one of its numbers
 * changes. Without edits, nothing is simulated. */
export function useTrial(recording: string, edits: Edits, numbers: (number | string)[]) {
  const trial = useSignal<Trial>({ state: "trying" });
  useEffect(() => {
    let isLatest = true;
    trial.value = { state: "trying" };
    if (edits.length === 0) return;
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
