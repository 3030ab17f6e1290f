import { Box3, type Mesh, Vector3 } from "three";
import type { Picker } from "./pick";

/** Points no higher than this above the lowest one are part of the lower face, and no farther above a surface touch it [m]. */
const NEAR = 0.003;
/** Of the lower face: more would take too long. */
const MOST_CORNERS = 8;
/** From the middle of the lower face to its corners; at the corners it may touch what stands beside it. */
const SHARES = [0.25, 0.5, 0.75, 0.95];
/** How high above the lower face the sides of a slot or a box are looked for, as a share of the height. */
const WITHIN = 0.3;
/** A slot leaves no more room on both sides together, as a share of what stands in it. */
const SLACK = 0.5;

/** What an object rests on, and whether the sides of one thing among it are around the object: it is a box or a slot. */
export interface Supports {
  on: string[];
  isInside: boolean;
}

/**
 * Returns the objects below the lower face of meshes, "" for the table: those that it touches, or else the one below
 * its middle. Their world matrices must be current.
 * @param except object that the meshes show
 */
export function supportsOf(meshes: Mesh[], except: string, picker: Picker, unitsPerMeter: number): Supports {
  const corners = lowestPoints(meshes, NEAR * unitsPerMeter);
  if (corners.length === 0) return { on: [], isInside: false };
  const middle = corners.reduce((sum, corner) => sum.add(corner), new Vector3()).divideScalar(corners.length);
  const points = corners.flatMap((corner) => SHARES.map((share) => middle.clone().lerp(corner, share)));
  const found = new Set<string>();
  for (const point of [middle, ...points]) {
    const from = point.clone().setZ(point.z + NEAR * unitsPerMeter);
    const below = picker.below(from, except);
    if (below && from.z - below.point.z < 2 * NEAR * unitsPerMeter) found.add(below.object);
  }
  const below = found.size > 0 ? null : picker.below(middle, except);
  const on = below ? [below.object] : [...found];
  return { on, isInside: on.some((object) => object !== "" && surrounds(object, meshes, middle, picker)) };
}

/** Whether an object is near on both sides of meshes, as a slot is, or on all four of them, as a box is. */
function surrounds(object: string, meshes: Mesh[], middle: Vector3, picker: Picker): boolean {
  const box = new Box3();
  for (const mesh of meshes) box.expandByObject(mesh);
  const size = box.getSize(new Vector3());
  const from = middle.clone().setZ(middle.z + WITHIN * size.z);
  const room = [new Vector3(1, 0, 0), new Vector3(0, 1, 0)].map((axis) => {
    return picker.distanceTo(object, from, axis) + picker.distanceTo(object, from, axis.clone().negate());
  });
  const isSlot = room[0]! < (1 + SLACK) * size.x || room[1]! < (1 + SLACK) * size.y;
  return isSlot || room.every(Number.isFinite);
}

/** The vertices of the lower face, or some of them. */
function lowestPoints(meshes: Mesh[], height: number): Vector3[] {
  const vertices = meshes.flatMap((mesh) => {
    const positions = mesh.geometry.getAttribute("position");
    const [, , a = 0, , , , b = 0, , , , c = 0, , , , d = 0] = mesh.matrixWorld.elements;
    return Array.from({ length: positions.count }, (_, k) => {
      const z = a * positions.getX(k) + b * positions.getY(k) + c * positions.getZ(k) + d;
      return { mesh, positions, k, z };
    });
  });
  const lowest = vertices.reduce((least, { z }) => Math.min(least, z), Infinity);
  const corners = vertices.flatMap(({ mesh, positions, k, z }) =>
    z < lowest + height ? [new Vector3().fromBufferAttribute(positions, k).applyMatrix4(mesh.matrixWorld)] : [],
  );
  const different = [...new Map(corners.map((point) => [point.toArray().map((x) => x.toFixed(3)).join(), point])).values()];
  const step = Math.ceil(different.length / MOST_CORNERS);
  return different.filter((_, k) => k % step === 0);
}
