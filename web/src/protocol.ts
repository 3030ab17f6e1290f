// What page and program say to each other; docs/studio-protocol.md explains it, and the types of
// messages are made from the program's tables. Lengths are in
// units of the scene file, angles in degrees, of joints in radians; world frame, z up.

import type { Diagnostic, HandName, Pose, Requests, Update } from "./messages";

export const VERSION = 1;

export type * from "./messages";

export const HANDS: HandName[] = ["left", "right", "both", "any"];

export interface Reply {
  t: "reply";
  seq: number;
  ok: boolean;
  error?: string;
  diagnostics?: Diagnostic[];
  [more: string]: unknown;
}

/** Something that one can ask for, and what the program then says. */
export type Wanted = keyof Requests;
export type AnswerTo<What extends Wanted> = Reply & Requests[What]["answer"];
/** Its fields may be left out where none has to be there. */
export type FieldsOf<What extends Wanted> = object extends Requests[What]["fields"]
  ? [fields?: Requests[What]["fields"]]
  : [fields: Requests[What]["fields"]];

/** A request as it is sent. */
export type RequestWithFields = { [What in Wanted]: { do: What } & Requests[What]["fields"] }[Wanted];

/** A text message of the program. */
export type TextMessage = Update | Reply;

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
