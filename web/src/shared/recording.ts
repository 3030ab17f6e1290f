import type { Pose, SceneMessage, Timeline } from "../protocol";
import { parse } from "../said";

/** Steps per unit of positions, and of the numbers of quaternions; docs/studio-protocol.md specifies the file. */
const POSITION_STEPS = 1e4;
const ROTATION_STEPS = 3e4;
export const NUMBERS_PER_POSE = 7;
export const TICKS_PER_SECOND = 60;

/** What happened without an action. */
export interface SharedEvent {
  kind: string;
  seconds: number;
  words?: string;
  object?: string;
  arm?: string;
  state?: string;
}

/** What the file says besides the poses; ticks count from the beginning. */
export interface Description {
  title: string;
  scene: SceneMessage;
  segments: Timeline["segments"];
  /** Of the choices and of the objects that are not there, from a tick on. */
  changes: { tick: number; looks?: number[]; gone?: string[] }[];
  events: SharedEvent[];
  /** Ticks of the pictures of the robot's eye. */
  eye: number[];
}

/** The poses of a frame: each from its tick on. */
export interface FrameTrack {
  ticks: Uint32Array;
  /** As in `Pose`, one after the other. */
  numbers: Float32Array;
}

export interface Recording {
  description: Description;
  numTicks: number;
  tracks: FrameTrack[];
}

/** Reads numbers in groups of seven bits, the lowest first. */
class NumberReader {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  next(): number {
    let number = 0;
    let factor = 1;
    for (;;) {
      const byte = this.bytes[this.at++];
      if (byte === undefined) throw new Error("the recording is cut off");
      number += (byte & 127) * factor;
      if (byte < 128) return number;
      factor *= 128;
    }
  }

  /** A difference: 0, -1, 1, -2, … */
  nextSigned(): number {
    const folded = this.next();
    return folded % 2 === 0 ? folded / 2 : -(folded + 1) / 2;
  }
}

/** Goes through the poses: for each one frame, tick and seven steps, which are valid until the next one. */
function forEachPose(
  bytes: Uint8Array,
  numTicks: number,
  numFrames: number,
  visit: (frame: number, tick: number, steps: number[]) => void,
): void {
  const reader = new NumberReader(bytes);
  const all = Array.from({ length: numFrames }, () => new Array<number>(NUMBERS_PER_POSE).fill(0));
  for (let tick = 0; tick < numTicks; ++tick) {
    let frame = 0;
    for (let left = reader.next(); left > 0; --left) {
      frame += reader.next();
      const steps = all[frame];
      if (steps === undefined) throw new Error(`the recording has no frame ${frame}`);
      for (let k = 0; k < NUMBERS_PER_POSE; ++k) steps[k]! += reader.nextSigned();
      visit(frame, tick, steps);
    }
  }
}

function decodeTracks(bytes: Uint8Array, numTicks: number, numFrames: number): FrameTrack[] {
  // Counted first: so each track is as long as it has to be.
  const counts = new Array<number>(numFrames).fill(0);
  forEachPose(bytes, numTicks, numFrames, (frame) => counts[frame]!++);
  const tracks = counts.map((count) => ({
    ticks: new Uint32Array(count),
    numbers: new Float32Array(count * NUMBERS_PER_POSE),
  }));
  counts.fill(0);
  forEachPose(bytes, numTicks, numFrames, (frame, tick, steps) => {
    const place = counts[frame]!++;
    const { ticks, numbers } = tracks[frame]!;
    ticks[place] = tick;
    steps.forEach((step, k) => (numbers[place * NUMBERS_PER_POSE + k] = step / (k < 3 ? POSITION_STEPS : ROTATION_STEPS)));
  });
  return tracks;
}

export function decodeRecording(file: ArrayBuffer): Recording {
  const data = new DataView(file);
  const length = data.getUint32(0, true);
  const description = parse(new TextDecoder().decode(new Uint8Array(file, 4, length))) as Description;
  const numTicks = data.getUint32(4 + length, true);
  const tracks = decodeTracks(new Uint8Array(file, 8 + length), numTicks, description.scene.numFrames);
  return { description, numTicks, tracks };
}

/** Which pose of a track is that of a tick; -1 before its first. */
export function placeAt({ ticks }: FrameTrack, tick: number): number {
  let [low, high] = [0, ticks.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ticks[middle]! <= tick) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export function poseAt({ numbers }: FrameTrack, place: number): Pose {
  return [...numbers.subarray(place * NUMBERS_PER_POSE, (place + 1) * NUMBERS_PER_POSE)] as Pose;
}
