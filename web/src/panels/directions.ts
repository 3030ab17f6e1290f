import type { Point } from "../protocol";
import { texts } from "../texts";
import type { IconName } from "../ui/icons";
import { choicePreference } from "../ui/preference";
import { world } from "./page";

export const STEPS = ["0.1", "1"] as const;
/** How far a press of a button moves things [units]. */
export const stepSize = choicePreference<(typeof STEPS)[number]>("step", "0.1", STEPS);

export type Direction = keyof typeof texts.hands.directions;
/** `key`: on a pad; `what`: of the key that works everywhere; `along`: to the right of the picture, away, up. */
export const DIRECTIONS: Record<Direction, { icon: IconName; key: string; what: string; along: Point }> = {
  left: { icon: "left", key: "ArrowLeft", what: "move.left", along: [-1, 0, 0] },
  right: { icon: "right", key: "ArrowRight", what: "move.right", along: [1, 0, 0] },
  away: { icon: "up", key: "ArrowUp", what: "move.away", along: [0, 1, 0] },
  nearer: { icon: "down", key: "ArrowDown", what: "move.nearer", along: [0, -1, 0] },
  higher: { icon: "higher", key: "PageUp", what: "move.up", along: [0, 0, 1] },
  lower: { icon: "lower", key: "PageDown", what: "move.down", along: [0, 0, -1] },
};

/** Along the axis of the world that goes most nearly this way in the picture: as keys and drags do, but by round numbers. */
export function stepAlong(direction: Direction, length: number): Point {
  const [right, away, up] = DIRECTIONS[direction].along;
  const [x, y] = axisNearest(world.value?.right ?? [1, 0]);
  return [(right * x - away * y) * length, (right * y + away * x) * length, up * length];
}

/** Of the world's horizontal axes, either way, the one that is nearest to a direction. */
function axisNearest([x, y]: readonly [number, number]): [x: number, y: number] {
  return Math.abs(x) >= Math.abs(y) ? [Math.sign(x), 0] : [0, Math.sign(y)];
}
