import { signal } from "@preact/signals";
import { isOffered } from "../allowed";
import { language } from "../language";
import type { LibraryEntry, Timeline } from "../protocol";
import { ask, notify, request, state } from "../studio";
import { texts } from "../texts";
import { brain, holders, shownRecording } from "./derived_signals";
import { toImitate } from "./page";

const { record: words } = texts;

/** Newest first; null until they are there. */
export const recordings = signal<LibraryEntry[] | null>(null);
/** The one whose timeline is seen. */
export const opened = signal<{ id: string; timeline: Timeline } | null>(null);
/** The segment of it that is chosen. */
export const chosenSegment = signal<number | null>(null);
/** Pictures of a recording change when it is continued: this makes the browser load them again. */
export const pictureAge = signal(0);

export async function refreshRecordings(): Promise<void> {
  try {
    const reply = await request("library");
    recordings.value = reply.recordings;
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), true);
  }
}

export function recordingOf(id: string): LibraryEntry | undefined {
  return recordings.value?.find((recording) => recording.id === id);
}

/** The set and the seed of a recording that belongs to a generated set; null for others. */
export function attemptOf(id: string): { set: string; seed: number } | null {
  const match = /^(.+):seed-(\d+)$/.exec(id);
  return match === null ? null : { set: match[1]!, seed: Number(match[2]) };
}

/** Without one, what it is called; in the bin it was called otherwise before. */
export function titleOf(id: string): string {
  const attempt = attemptOf(id);
  if (attempt !== null) return texts.attempts.recording(attempt.set, attempt.seed);
  const recording = recordingOf(id);
  const title = recording?.title ?? "";
  if (title !== "") return title;
  return recording?.binned ? id.replace(/~\d+$/, "") : id;
}

/** When it was made, as readers of the language write it, but short; whatever cannot be read as a time stays as it is. */
export function whenMade(made: string): string {
  const time = new Date(made);
  if (Number.isNaN(time.getTime())) return made;
  const fields = { month: "short", day: "numeric", hour: "2-digit", minute: "2-digit", hourCycle: "h23" } as const;
  return time.toLocaleString(language, fields);
}

/** As many letters as a title may have. */
export const MAX_TITLE_LENGTH = 200;

/** Returns whether the program took the new title or notes; if not, it shows why. */
export async function renameRecording(id: string, to: { title?: string; notes?: string }): Promise<boolean> {
  if ((await ask("rename", { recording: id, ...to })) === null) return false;
  await refreshRecordings();
  return true;
}

/** Null if it cannot be opened. */
export async function openRecording(id: string): Promise<Timeline | null> {
  const reply = await ask("open", { recording: id });
  if (reply === null) return null;
  const timeline = reply.timeline;
  opened.value = { id, timeline };
  chosenSegment.value = null;
  // What was shown last is to be imitated, unless it is the run of a robot, in which no hand did anything.
  if (timeline.segments.length > 1) toImitate.value = id;
  return timeline;
}

/** Who comes while a recording is shown, or watches who shows one, sees its timeline. */
export async function onRecordingShown(id: string): Promise<void> {
  if (opened.value !== null) return;
  const reply = await request("open", { recording: id }).catch(() => null);
  if (reply !== null && opened.value === null && shownRecording.value === id) {
    opened.value = { id, timeline: reply.timeline };
    chosenSegment.value = null;
  }
}

/** Time that the state may take to report why a recording ended by itself [ms]. */
const FAILURE_MS = 500;

/** What ended the recording by itself stays on the page: it is not reported twice. */
export async function finishRecording(): Promise<void> {
  const recording = state.value?.recording?.id;
  const refusal = await request("command", { command: { do: "finish" } }).then(
    () => null,
    (error: Error) => error.message,
  );
  if (refusal === null) return;
  await new Promise((resolve) => setTimeout(resolve, FAILURE_MS));
  if (state.value?.failure?.recording !== recording) notify(refusal, true);
}

/** Called when a recording is complete: for each client, not only the one that finished it. */
export async function onRecordingFinished(id: string): Promise<void> {
  if (!isOffered("open")) {
    notify(words.saved(id));
    return;
  }
  pictureAge.value += 1;
  await refreshRecordings();
  const failure = state.value?.failure ?? null;
  if (failure?.recording === id) {
    // A banner reports it, and stays.
    if (failure.kept) await openRecording(id);
    return;
  }
  await openRecording(id);
  const held = Object.keys(holders.value)[0];
  const title = titleOf(id);
  // What a robot did is no action of a hand.
  const isRun = (brain.value?.name ?? "") !== "";
  if (recordingOf(id)?.segments === 1 && !isRun) notify(words.keptEmpty(title));
  else notify(held === undefined ? words.kept(title) : words.keptHeld(title, held));
}

export function pictureOfRecording(id: string): string {
  return `/recordings/${encodeURIComponent(id)}/picture.png?age=${pictureAge.value}`;
}

/** The end of a recording through the robot's eye. */
export function eyePictureOf(id: string): string {
  return `/recordings/${encodeURIComponent(id)}/eye.png`;
}

export function pictureOfSegment(id: string, number: number): string {
  return `/recordings/${encodeURIComponent(id)}/segments/${number}.png?age=${pictureAge.value}`;
}
