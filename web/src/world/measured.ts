// What is measured: up to three points, in units of the scene.

import { signal } from "@preact/signals";
import type { Point } from "../protocol";

export interface MeasuredPoint {
  kind: "corner" | "edge" | "surface" | "origin";
  /** Id of the object; "" for table and robot. */
  object: string;
  place: Point;
}

/** Null unless the user measures. */
export const measured = signal<MeasuredPoint[] | null>(null);
const MAX_POINTS = 3;
const DEGREES = 180 / Math.PI;

export function switchMeasuring(): void {
  measured.value = measured.value === null ? [] : null;
}

/** After three points it begins again. */
export function addMeasured(point: MeasuredPoint): void {
  const points = measured.value ?? [];
  measured.value = [...(points.length === MAX_POINTS ? [] : points), point];
}

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Point, b: Point) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const lengthOf = (a: Point) => Math.sqrt(dot(a, a));

/** The way from one point to another, along x, y and z, and its length [units]. */
export function wayBetween(from: Point, to: Point): { along: Point; length: number } {
  const along = minus(to, from);
  return { along, length: lengthOf(along) };
}

/** The angle at the second of three points [degrees]; null where two of them are one. */
export function angleAt([first, corner, last]: [Point, Point, Point]): number | null {
  const [a, b] = [minus(first, corner), minus(last, corner)];
  const lengths = lengthOf(a) * lengthOf(b);
  if (lengths < 1e-12) return null;
  return Math.acos(Math.min(1, Math.max(-1, dot(a, b) / lengths))) * DEGREES;
}
