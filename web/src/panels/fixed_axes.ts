import type { Point } from "../protocol";

// Turns about the world's x, then y, then z axis, as scene files and commands have them [degrees].

type Rotation = [row0: Point, row1: Point, row2: Point];

const DEGREE = Math.PI / 180;

function rotationOf([x, y, z]: Point): Rotation {
  const [cx, sx] = [Math.cos(x * DEGREE), Math.sin(x * DEGREE)];
  const [cy, sy] = [Math.cos(y * DEGREE), Math.sin(y * DEGREE)];
  const [cz, sz] = [Math.cos(z * DEGREE), Math.sin(z * DEGREE)];
  return [
    [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
    [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
    [-sy, cy * sx, cy * cx],
  ];
}

function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The turn that leads from one orientation to another. */
export function turnFromTo(from: Point, to: Point): Point {
  const [before, after] = [rotationOf(from), rotationOf(to)];
  // An inverse rotation is its transpose: rows times rows.
  const entry = (row: 0 | 1 | 2, column: 0 | 1 | 2) => dot(after[row], before[column]);
  const y = -Math.asin(Math.min(1, Math.max(-1, entry(2, 0))));
  return [
    Math.atan2(entry(2, 1), entry(2, 2)) / DEGREE,
    y / DEGREE,
    Math.atan2(entry(1, 0), entry(0, 0)) / DEGREE,
  ];
}
