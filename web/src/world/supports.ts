import { type Mesh, Vector3 } from "three";
import type { Picker } from "./pick";

/** Points no higher than this above the lowest one are part of the lower face, and no farther above a surface touch it [m]. */
const NEAR = 0.003;
/** Of the lower face: more would take too long. */
const MOST_CORNERS = 8;
/** From the middle of the lower face to its corners; at the corners it may touch what stands beside it. */
const SHARES = [0.25, 0.5, 0.75, 0.95];

/**
 * Returns the objects below the lower face of meshes, "" for the table: those that it touches, or else the one below
 * its middle. Their world matrices must be current.
 * @param except object that the meshes show
 */
export function supportsOf(meshes: Mesh[], except: string, picker: Picker, unitsPerMeter: number): string[] {
  const corners = lowestPoints(meshes, NEAR * unitsPerMeter);
  if (corners.length === 0) return [];
  const middle = corners.reduce((sum, corner) => sum.add(corner), new Vector3()).divideScalar(corners.length);
  const points = corners.flatMap((corner) => SHARES.map((share) => middle.clone().lerp(corner, share)));
  const found = new Set<string>();
  for (const point of [middle, ...points]) {
    const from = point.clone().setZ(point.z + NEAR * unitsPerMeter);
    const below = picker.below(from, except);
    if (below && from.z - below.point.z < 2 * NEAR * unitsPerMeter) found.add(below.object);
  }
  const below = found.size > 0 ? null : picker.below(middle, except);
  return below ? [below.object] : [...found];
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
