// Which turn makes an object straight: to the next right angle to an upright object beside it, or to the table.

import { Euler, MathUtils, Matrix4, Vector3 } from "three";
import type { Point } from "../protocol";
import { type Cuboid, nearestUpright } from "./alignment";

/** What is farther away than this does not count, but the table does [m]. */
const FAR = 0.2;

/**
 * Returns the turn about the world's x, then y, then z axis, as commands have it [degrees].
 * @param named  the object that people were told it is turned from; null: none, so the nearest one counts
 */
export function straighteningTurn(cuboid: Cuboid, others: readonly Cuboid[], named: string | null): Point {
  const other = others.find(({ object }) => object === named) ?? nearestUpright(cuboid, others, FAR);
  const frame: Cuboid["axes"] = other?.axes ?? [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const R_WF = matrixOf(frame);
  const R_WB = matrixOf(cuboid.axes);
  const R_FB = R_WF.clone().transpose().multiply(R_WB);
  const turn = R_WF.multiply(nearestRightAngle(R_FB)).multiply(R_WB.transpose());
  const { x, y, z } = new Euler().setFromRotationMatrix(turn, "ZYX");
  return [x, y, z].map(MathUtils.radToDeg) as Point;
}

function matrixOf([x, y, z]: Cuboid["axes"]): Matrix4 {
  return new Matrix4().makeBasis(new Vector3(...x), new Vector3(...y), new Vector3(...z));
}

/** The axes of the frame that the object's x and, of the others, its y axis are nearest to. */
function nearestRightAngle(rotation: Matrix4): Matrix4 {
  const [x, y] = [0, 1].map((axis) => new Vector3().setFromMatrixColumn(rotation, axis)) as [Vector3, Vector3];
  const first = dominant(x);
  const second = dominant(y.addScaledVector(first, -y.dot(first)));
  return new Matrix4().makeBasis(first, second, first.clone().cross(second));
}

function dominant(direction: Vector3): Vector3 {
  const parts = direction.toArray();
  const largest = Math.max(...parts.map(Math.abs));
  const axis = parts.findIndex((part) => Math.abs(part) === largest);
  return new Vector3().setComponent(axis, Math.sign(parts[axis]!));
}
