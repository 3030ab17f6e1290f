// What page and program say to each other; docs/studio-protocol.md explains it. Lengths are in
// units of the scene file, angles in degrees, of joints in radians; world frame, z up.

export const VERSION = 1;

export type Point = [number, number, number];
/** x, y, z, then the quaternion x, y, z, w. */
export type Pose = [number, number, number, number, number, number, number];
export type HandName = "left" | "right" | "both" | "any";
export const HANDS: HandName[] = ["left", "right", "both", "any"];

export interface Visual {
  frame: number;
  object: number;
  /** Id of the innermost part it is of that has one. */
  part?: string;
  pose: Pose;
  color: string;
  choice: number;
  look: number;
  glows?: boolean;
  block?: Point;
  cylinder?: [radius: number, height: number, sides: number];
  sphere?: number;
  mesh?: number;
  scale?: number;
}

export interface SceneObject {
  id: string;
  frame: number;
  shape: string;
  /** It cannot be taken. */
  fixed: boolean;
  /** Outer ones first; `within` is the id of the part, or the object, around it. */
  parts: { id: string; pointable: boolean; within: string }[];
  controls: { id: string; kind: string; parts: string[] }[];
  bonds: boolean;
  properties: string[];
}

export interface RobotDescription {
  name: string;
  joints: {
    name: string;
    arm: string;
    lower: number;
    upper: number;
    speed: number;
    is_length: boolean;
  }[];
  grippers: { arm: string; stroke: number }[];
  poses: string[];
  cameras: string[];
}

export interface SceneMessage {
  t: "scene";
  scene: number;
  name: string;
  metersPerUnit: number;
  table: { size: Point };
  numFrames: number;
  robotFrame: number | null;
  visuals: Visual[];
  looks: number[];
  objects: SceneObject[];
  robot: RobotDescription | null;
}

export interface Hand {
  object: string | null;
  /** Where the hand wants the grasped point, and where the object's origin is then. */
  goal?: Point;
  place?: Point;
  plane: number;
  angles?: Point;
}

/** What a hand did; `on` and `into` name what is beneath, "" for the table. */
export interface Deed {
  do: "take" | "put" | "drop" | "release" | "destroy" | "point" | "trigger" | "fasten" | "loosen";
  hand: HandName;
  what: string;
  on?: string;
  into?: string;
  /** All of it, for people. */
  words: string;
}

export interface Segment {
  number: number;
  /** What began it; null of the first. */
  deed: Deed | null;
  seconds: number;
}

export interface StateMessage {
  t: "state";
  tick: number;
  mode: "live" | "playback" | "rage";
  paused: boolean;
  speed: number;
  hands: Record<HandName, Hand>;
  undo: boolean;
  redo: boolean;
  still: boolean;
  recording: { id: string; title: string; seconds: number; segments: Segment[] } | null;
  /** The last recording ended by itself; `kept`: it is in the library up to then. */
  failure: { recording: string; title: string; error: string; kept: boolean } | null;
  playback: { recording: string; seconds: number; length: number; rate: number } | null;
  controls: Record<string, string>;
  gone: string[];
  /** On the floor, out of play. */
  fallen: string[];
  attention: Record<string, string[]>;
  robot: {
    shown: boolean;
    mood: string;
    following: boolean;
    joints: Record<string, number>;
    grippers: number[];
    head: number;
  } | null;
  /** Its status is one of those in `texts.brain.statuses`. */
  brain: { name: string; status: string; message: string; file: string; line: number };
  snap: string[];
  markers: Point[];
}

export interface EventMessage {
  t: "event";
  kind: string;
  hand?: HandName;
  object?: string;
  reason?: string;
  [more: string]: unknown;
}

export interface Diagnostic {
  file: string;
  line: number;
  element: string;
  message: string;
}

export interface Reply {
  t: "reply";
  seq: number;
  ok: boolean;
  error?: string;
  diagnostics?: Diagnostic[];
  [more: string]: unknown;
}

export interface ClientsMessage {
  t: "clients";
  controller: number | null;
  clients: number[];
  you: number;
}

export interface ConsoleLine {
  text: string;
  file?: string;
  line?: number;
}

export type News =
  | SceneMessage
  | StateMessage
  | EventMessage
  | ClientsMessage
  | Reply
  | { t: "looks"; looks: number[] }
  | { t: "console"; lines: ConsoleLine[]; all?: boolean }
  | { t: "score"; result: Record<string, unknown> }
  | { t: "progress"; what: string; done: number; total: number }
  | { t: "control_wanted"; by: number }
  | { t: "control_kept"; by: number }
  | { t: "library" }
  | { t: "error"; error: string };

/** A binary message: where frames are now. */
export interface Poses {
  scene: number;
  tick: number;
  ack: number;
  isKey: boolean;
  frames: { frame: number; pose: Pose }[];
}

/** A binary message: what the robot's eye saw last. */
export interface EyeView {
  tick: number;
  png: Blob;
}

const HEADER_BYTES = 16;
const POSE_BYTES = 32;

export function decodeBinary(bytes: ArrayBuffer): Poses | EyeView | null {
  if (bytes.byteLength < HEADER_BYTES) return null;
  const data = new DataView(bytes);
  const kind = data.getUint8(0);
  const isKey = (data.getUint8(1) & 1) === 1;
  const count = data.getUint16(2, true);
  const scene = data.getUint32(4, true);
  const tick = data.getUint32(8, true);
  const ack = data.getUint32(12, true);
  if (kind === 2) {
    return { tick, png: new Blob([bytes.slice(HEADER_BYTES)], { type: "image/png" }) };
  }
  if (kind !== 1 || bytes.byteLength < HEADER_BYTES + count * POSE_BYTES) return null;
  const frames = [];
  for (let k = 0; k < count; ++k) {
    const at = HEADER_BYTES + k * POSE_BYTES;
    const number = (place: number) => data.getFloat32(at + 4 + 4 * place, true);
    const pose: Pose = [number(0), number(1), number(2), number(3), number(4), number(5), number(6)];
    frames.push({ frame: data.getUint32(at, true), pose });
  }
  return { scene, tick, ack, isKey, frames };
}
