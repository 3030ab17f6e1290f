import type { Poses } from "../protocol";

const MOST = 500;
const FORGOTTEN_MS = 2000;

/** How long it takes from a command until the pose it caused is here [ms]. */
export class Latency {
  private readonly sent = new Map<number, number>();
  /** The last ones, oldest first. */
  readonly recent: number[] = [];

  note(seq: number): void {
    this.sent.set(seq, performance.now());
  }

  /** @param frame that of the commanded object: only its poses count. */
  take(poses: Poses, frame: number | null): void {
    const now = performance.now();
    const isAnswer = !poses.isKey && poses.frames.some((moved) => moved.frame === frame);
    for (const [seq, when] of this.sent) {
      if (seq > poses.ack && now - when < FORGOTTEN_MS) continue;
      this.sent.delete(seq);
      if (isAnswer && seq <= poses.ack) this.recent.push(now - when);
    }
    this.recent.splice(0, this.recent.length - MOST);
  }
}
