// How a cuboid stands to others: which of their faces lie in one plane. Lengths are in meters.

import type { Point } from "../protocol";

/** Cuboid around an object, along the axes of the object's frame. */
export interface Cuboid {
  /** Id of the object; "" for the table. */
  object: string;
  center: Point;
  /** Directions of length 1 in the world. */
  axes: [Point, Point, Point];
  /** Half of its size along each axis. */
  half: Point;
}

/** What a cuboid has in common with another one. */
export interface Alignment {
  object: string;
  /** Their faces touch sideways. */
  touches: boolean;
  /** Number of upright faces that lie in one plane with the same faces of the other: short sides of a long cuboid are ends. */
  ends: number;
  sides: number;
  isTopLevel: boolean;
  isBottomLevel: boolean;
  /** Their middles lie in one upright plane, but their sides do not. */
  isCentered: boolean;
  /** What is missing to one more of these along each level axis, if it is little: a person cannot see it in the picture. */
  missing: Missing[];
}

export interface Missing {
  distance: number;
  /** Direction in which the cuboid would have to move: of length 1, in the world. */
  toward: Point;
  to: "flush" | "touching";
}

/** How a cuboid is turned from another one, about a vertical axis. */
export interface Turned {
  object: string;
  /** To the nearest right angle: at most 45. */
  degrees: number;
}

/** Faces no farther apart lie in one plane. */
const SAME = 0.0005;
/** Cuboids farther apart have nothing to do with each other: the largest change of a drag by snapping. */
const NEAR = 0.015;
/** What is missing to being flush or touching is not mentioned from here on. */
const FAR = 0.03;
/** Sine of one degree: a held object is level only nearly. */
const LEVEL = Math.sin(Math.PI / 180);
/** Less is not mentioned [degrees]. */
const LEAST_TURN = 0.5;
/** Cosine of half a degree. */
const PARALLEL = Math.cos(Math.PI / 360);
/** A cuboid that is longer than wide by this factor has ends. */
const LONG = 1.5;

const dot = (a: Point, b: Point) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const isSame = (a: number, b: number) => Math.abs(a - b) < SAME;

/**
 * Returns the others that a cuboid is aligned with. A level top or bottom counts only while the cuboid lies on none of
 * them: what stands on one table has level bottoms.
 */
export function alignmentsOf(cuboid: Cuboid, others: readonly Cuboid[]): Alignment[] {
  const pairs = others.flatMap((other) => pairOf(cuboid, other) ?? []);
  const isLying = pairs.some(({ isLyingOn }) => isLyingOn);
  return pairs.flatMap(({ alignment }) => {
    if (isLying) alignment.isTopLevel = alignment.isBottomLevel = false;
    const { touches, ends, sides, isTopLevel, isBottomLevel, isCentered, missing } = alignment;
    return touches || ends + sides > 0 || isTopLevel || isBottomLevel || isCentered || missing.length > 0 ? [alignment] : [];
  });
}

/** Returns the upright one of the others that is nearest to the middle of a cuboid, if it is within a distance; the table is none. */
export function nearestUpright(cuboid: Cuboid, others: readonly Cuboid[], most: number): Cuboid | null {
  let [nearest, least]: [Cuboid | null, number] = [null, most];
  for (const other of others) {
    if (other.object === "" || levelAxesOf(other).length !== 2) continue;
    const apart = minus(cuboid.center, other.center);
    const outside = other.axes.map((axis, k) => Math.max(0, Math.abs(dot(axis, apart)) - other.half[k]!));
    const distance = Math.hypot(...outside);
    if (distance < least) [nearest, least] = [other, distance];
  }
  return nearest;
}

/** Returns how an upright cuboid is turned from the nearest upright other one, if that is close enough for it to matter. */
export function turnedFrom(cuboid: Cuboid, others: readonly Cuboid[]): Turned | null {
  const other = nearestUpright(cuboid, others, Math.hypot(...cuboid.half) + FAR);
  const level = levelAxesOf(cuboid);
  if (other === null || level.length !== 2) return null;
  const angles = levelAxesOf(other).map((axis) => (Math.acos(Math.min(1, Math.abs(dot(level[0]!, axis)))) * 180) / Math.PI);
  const degrees = Math.min(...angles);
  return degrees < LEAST_TURN ? null : { object: other.object, degrees };
}

function levelAxesOf({ axes }: Cuboid): Point[] {
  return axes.filter((axis) => Math.abs(axis[2]) < LEVEL);
}

/** Null unless both are near each other and their axes are parallel, in any order. */
function pairOf(cuboid: Cuboid, other: Cuboid): { alignment: Alignment; isLyingOn: boolean } | null {
  const indices = other.axes.map((axis) => cuboid.axes.findIndex((own) => Math.abs(dot(own, axis)) > PARALLEL));
  if (indices.includes(-1)) return null;
  const half = indices.map((k) => cuboid.half[k]!);
  const apart = other.axes.map((axis) => dot(axis, minus(cuboid.center, other.center)));
  const gaps = apart.map((distance, k) => Math.abs(distance) - half[k]! - other.half[k]!);
  if (gaps.some((gap) => gap > FAR)) return null;

  const alignment: Alignment = {
    object: other.object, touches: false, ends: 0, sides: 0, isTopLevel: false, isBottomLevel: false, isCentered: false,
    missing: [],
  };
  const isNear = gaps.every((gap) => gap <= NEAR);
  let isLyingOn = false;
  for (const k of isNear ? [0, 1, 2] : []) {
    const isBeside = gaps.every((gap, other_axis) => other_axis === k || gap < -SAME);
    const isTouching = isBeside && isSame(gaps[k]!, 0);
    const isUpright = Math.abs(other.axes[k]![2]) > PARALLEL;
    const [high, low] = [1, -1].map((side) => isSame(apart[k]! + side * half[k]!, side * other.half[k]!));
    if (isUpright) {
      const isUp = other.axes[k]![2] > 0;
      isLyingOn ||= isTouching && apart[k]! > 0 === isUp;
      alignment.isTopLevel = (isUp ? high : low)!;
      alignment.isBottomLevel = (isUp ? low : high)!;
    } else {
      const level = [0, 1, 2].filter((m) => m !== k && Math.abs(other.axes[m]![2]) <= PARALLEL);
      const isLong = level.length === 1 && other.half[k]! > LONG * other.half[level[0]!]!;
      alignment[isLong ? "ends" : "sides"] += Number(high) + Number(low);
      alignment.touches ||= isTouching;
      alignment.isCentered ||= isSame(apart[k]!, 0) && !high;
    }
  }
  alignment.missing = missingTo(other, half, apart, gaps);
  return { alignment, isLyingOn };
}

/** What is missing along the axes in which no faces are flush or touch; the table's edges do not count. */
function missingTo(other: Cuboid, half: number[], apart: number[], gaps: number[]): Missing[] {
  if (other.object === "") return [];
  return [0, 1, 2].flatMap((k) => {
    if (Math.abs(other.axes[k]![2]) > PARALLEL) return [];
    const isBeside = gaps.every((gap, axis) => axis === k || gap < -SAME);
    // Displacements along the axis.
    const flush = [1, -1].map((side) => side * (other.half[k]! - half[k]!) - apart[k]!);
    const steps = [
      ...flush.map((shift) => ({ shift, to: "flush" as const })),
      ...(isBeside ? [{ shift: -Math.sign(apart[k]!) * gaps[k]!, to: "touching" as const }] : []),
    ];
    const { shift, to } = steps.reduce((one, another) => (Math.abs(another.shift) < Math.abs(one.shift) ? another : one));
    const distance = Math.abs(shift);
    if (distance < SAME || distance >= FAR) return [];
    const toward = other.axes[k]!.map((part) => Math.sign(shift) * part) as Point;
    return [{ distance, toward, to }];
  });
}
