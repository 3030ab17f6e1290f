import type { SnapName } from "../protocol";

// The messages between this page and `smile study`: docs/studies.md.

export interface Question {
  prompt: string;
  name: string;
  labels: string[];
  scale: boolean;
  required: boolean;
}

export interface InstructionContent {
  title: string;
  text: string;
  picture: string;
  film: string;
}

export interface TrialContent {
  title: string;
  text: string;
  film: string;
  /** [s] */
  limit: number;
  aids: { snap: SnapName[]; ghost: boolean; rings: boolean };
  /** Complete trials of this step so far. */
  completed: number;
  /** Whether the last trial was interrupted, and is to be done again. */
  interrupted: boolean;
  /** Of the practice: trials until the study goes on in any case. */
  attempts?: number;
}

export type Content =
  | { kind: "consent"; content: { text: string; declined: boolean } }
  | { kind: "instruction"; content: InstructionContent }
  | { kind: "practice" | "task"; content: TrialContent }
  | { kind: "questions"; content: { type: string; name: string; preamble: string; questions: Question[] } }
  | { kind: "break"; content: { seconds: number } }
  | { kind: "thanks"; content: { text: string; code: string; url: string } };

export type StepMessage = { t: "step"; study: string; step: string; index: number; count: number } & Content;

export type ServerMessage =
  | StepMessage
  /** The session of the trial serves; time left [s]. */
  | { t: "session"; left: number }
  | { t: "replaced" }
  | { t: "unknown" }
  | { t: "error"; error: string };

/** A line of the log of mouse, keys, camera and focus; `ms` since the trial began on this page. */
export interface InputLine {
  ms: number;
  kind: string;
  [detail: string]: string | number | readonly number[];
}

export type Answers = Record<string, string | number>;

export type PageMessage =
  | { do: "hello"; token: string }
  | { do: "consent"; step: string; agreed: boolean }
  | { do: "done"; step: string }
  | { do: "answers"; step: string; answers: Answers }
  | { do: "trial_begin"; step: string }
  | { do: "trial_end"; step: string; reason: "done" | "limit" }
  | { do: "log"; lines: InputLine[] };
