// Made by tools/generate.py from the tables in src/page: change those instead.

import type { Command } from "./commands";

export type HandName = "left" | "right" | "both" | "any";

export type FaceExpression = "idle" | "watching" | "working" | "puzzled" | "done";

export type SnapName = "faces" | "edges" | "grid" | "angles";

export type Point = [number, number, number];

/** x, y, z, then the quaternion x, y, z, w. */
export type Pose = [number, number, number, number, number, number, number];

export interface Visual {
  /** 0 is the world */
  frame: number;
  object: number;
  /** id of the innermost part it is of that has one */
  part?: string;
  /** of a switch: its name in commands */
  button?: string;
  pose: Pose;
  /** #rrggbb */
  color: string;
  /** -1: it is always seen */
  choice: number;
  /** it is seen when `looks[choice]` is this */
  look: number;
  glows?: boolean;
  /** full lengths */
  block?: Point;
  /** radius, height, sides; its axis is y */
  cylinder?: [number, number, number];
  /** its radius */
  sphere?: number;
  /** its number, with `scale` */
  mesh?: number;
  scale?: number;
}

export interface SceneObject {
  id: string;
  frame: number;
  shape: string;
  /** it cannot be taken */
  fixed: boolean;
  /** outer ones first; `within` is the id of the part, or the object, around it */
  parts: { id: string; pointable: boolean; within: string }[];
  controls: { id: string; kind: string; parts: string[] }[];
  /** it can be fastened to others */
  bonds: boolean;
  /** that may matter */
  properties: string[];
}

export interface RobotDescription {
  name: string;
  joints: { name: string; arm: string; is_head: boolean; lower: number; upper: number; speed: number; is_length: boolean }[];
  grippers: { arm: string; stroke: number }[];
  poses: string[];
  cameras: string[];
}

export interface Hand {
  /** null: it holds nothing */
  object: string | null;
  /** where it wants the grasped point */
  goal?: Point;
  /** where the object's origin is then */
  place?: Point;
  plane: number;
  /** how it wants the object turned */
  angles?: Point;
}

/** An action; `on` and `into` tell what is beneath what was put or dropped. */
export interface ActionSummary {
  do: "take" | "put" | "drop" | "release" | "destroy" | "point" | "trigger" | "fasten" | "loosen" | "add" | "remove" | "clear" | "load";
  /** null of what no hand did */
  hand: HandName | null;
  /** an id, `5 objects`, or the name of a scene */
  what: string;
  /** id of what is beneath, empty for the table */
  on?: string;
  into?: string;
  /** all of it, for people */
  words: string;
}

export interface Segment {
  number: number;
  /** what began it; null of the first */
  deed: ActionSummary | null;
  seconds: number;
}

/** All times from the start [s]. */
export interface Timeline {
  segments: ({ number: number; deed: ActionSummary | null; begin: number; end: number })[];
  steps: ({ step: number; parent: number | null; deed: ActionSummary | null; begin: number; end: number; on_way: boolean })[];
  seconds: number;
}

export interface LibraryEntry {
  id: string;
  title?: string;
  notes?: string;
  scene?: string;
  /** to its last frame */
  seconds?: number;
  segments?: number;
  /** in place of all these: it cannot be read */
  error?: string;
  /** when it was last recorded into */
  made: string;
  binned: boolean;
}

/** True, or the reason why not. */
export type Allowed = string | true;

export interface Diagnostic {
  file: string;
  line: number;
  element: string;
  message: string;
}

export interface ConsoleLine {
  text: string;
  file?: string;
  line?: number;
}

export interface SceneMessage {
  t: "scene";
  /** counts up */
  scene: number;
  name: string;
  metersPerUnit: number;
  /** its top is z = 0 */
  table: { size: Point };
  numFrames: number;
  /** first of the robot's */
  robotFrame: number | null;
  visuals: Visual[];
  looks: number[];
  objects: SceneObject[];
  robot: RobotDescription | null;
}

export interface LooksMessage {
  t: "looks";
  looks: number[];
}

export interface StateMessage {
  t: "state";
  tick: number;
  mode: "live" | "playback" | "rage";
  /** what may be asked for now, else why not */
  allowed: { requests: Record<string, Allowed>; commands: Record<string, Allowed> };
  paused: boolean;
  /** simulated per real second, over the last one */
  speed: number;
  hands: { left: Hand; right: Hand; both: Hand; any: Hand };
  still: boolean;
  recording: { id: string; title: string; seconds: number; segments: Segment[] } | null;
  playback: { recording: string; seconds: number; length: number; rate: number } | null;
  /** the recording to a moment of which the world goes back */
  restoring: string | null;
  /** the last recording ended by itself */
  failure: { recording: string; title: string; error: string; kept: boolean } | null;
  /** states as recordings have them; of a switch its position */
  controls: Record<string, string>;
  gone: string[];
  /** on the floor, out of play */
  fallen: string[];
  attention: Record<string, string[]>;
  robot: { shown: boolean; mood: FaceExpression; following: boolean; joints: Record<string, number>; grippers: number[]; head: number } | null;
  brain: { name: string; status: "none" | "starting" | "running" | "exited" | "failed" | "stopped"; message: string; file: string; line: number };
  snap: SnapName[];
  markers: Point[];
}

export interface EventMessage {
  t: "event";
  kind: string;
  tick: number;
  hand?: HandName;
  arm?: string;
  object?: string;
  reason?: string;
  part?: string;
  control?: string;
  state?: string;
  guest?: string;
  host?: string;
  tightness?: number;
  properties?: string[];
  /** that were added or removed */
  objects?: string[];
}

export interface ConsoleMessage {
  t: "console";
  all?: boolean;
  lines: ConsoleLine[];
}

export interface ClientsMessage {
  t: "clients";
  controller: number | null;
  clients: number[];
  you: number;
}

export interface ScoreMessage {
  t: "score";
  result: Record<string, unknown>;
}

export interface ProgressMessage {
  t: "progress";
  what: string;
  done: number;
  total: number;
}

export interface ControlWantedMessage {
  t: "control_wanted";
  by: number;
}

export interface ControlKeptMessage {
  t: "control_kept";
  by: number;
}

export interface LibraryMessage {
  t: "library";
}

export interface ErrorMessage {
  t: "error";
  error: string;
}

/** Messages that are not replies. */
export type Update =
  | SceneMessage
  | LooksMessage
  | StateMessage
  | EventMessage
  | ConsoleMessage
  | ClientsMessage
  | ScoreMessage
  | ProgressMessage
  | ControlWantedMessage
  | ControlKeptMessage
  | LibraryMessage
  | ErrorMessage;

/** What may be asked for, and what is answered beside `ok`. */
export interface Requests {
  hello: { fields: { version: number }; answer: { client: number; controller: number | null; program: string } };
  ping: { fields: object; answer: object };
  take_control: { fields: { by_force?: boolean }; answer: { granted: boolean } };
  keep_control: { fields: { from: number }; answer: object };
  give_control: { fields: { to?: number | null }; answer: object };
  command: { fields: { command: Command; exact?: boolean }; answer: { recording?: string; deed?: ActionSummary } };
  allowed: { fields: { requests: Record<string, unknown>[] }; answer: { allowed: Allowed[] } };
  pause: { fields: object; answer: object };
  resume: { fields: object; answer: object };
  speed: { fields: { factor: number }; answer: object };
  snap: { fields: { to: SnapName[] }; answer: object };
  support: { fields: { object: string }; answer: { on?: string; into?: string } };
  resting_place: { fields: { hand: HandName }; answer: { hand: HandName; pose: Pose | null; stale?: boolean } };
  load: { fields: { scene?: string; xml?: string; name?: string }; answer: object };
  reload: { fields: object; answer: object };
  check: { fields: { xml: string; name: string }; answer: { diagnostics: Diagnostic[] } };
  spawn: { fields: { preset: string; seed: number }; answer: { objects: string[] } };
  clear: { fields: { rage?: boolean }; answer: object };
  library: { fields: object; answer: { recordings: LibraryEntry[] } };
  rename: { fields: { recording: string; title?: string | null; notes?: string | null }; answer: object };
  bin: { fields: { recording: string }; answer: { recording: string } };
  unbin: { fields: { recording: string }; answer: { recording: string } };
  open: { fields: { recording: string }; answer: { timeline: Timeline } };
  try_edit: { fields: { recording: string; edits: unknown[] }; answer: { report: unknown } };
  edit: { fields: { recording: string; edits: unknown[]; name: string }; answer: { recording: string; report: unknown } };
  cancel: { fields: { request: number }; answer: object };
  show: { fields: { recording: string; seconds?: number }; answer: { length: number } };
  play: { fields: { rate?: number }; answer: object };
  live: { fields: object; answer: object };
  branch: { fields: { recording: string; step: number; after?: number }; answer: { recording: string } };
  brains: { fields: object; answer: { brains: ({ name: string; kind: "octave" | "python" | "program"; imitates: boolean })[] } };
  start_brain: { fields: { brain: string; demonstration?: string; scene?: string }; answer: object };
  stop_brain: { fields: object; answer: object };
  imitate: { fields: { recording: string; brain: string; scene: string }; answer: { recording: string } };
}
