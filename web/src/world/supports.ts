import { type Mesh, Vector3 } from "three";
import type { Picker } from "./pick";

/** Points no higher than this above the lowest one are part of the lower face, and no farther above a surface touch it [m]. */
const NEAR = 0.003;
/** Points of the lower face, of which more would take too long. */
const MOST_POINTS = 16;
/** From the middle of the lower face to its corners; at the corners it may touch what stands beside it. */
const SHARES = [0, 0.2, 0.4, 0.6, 0.8, 0.95];

/**
 * Returns the objects below the lower face of meshes, "" for the table: those that it touches, or else the one below
 * its middle. Their world matrices must be current.
 * @param except object that the meshes show
 */
export function supportsOf(meshes: Mesh[], except: string, picker: Picker, unitsPerMeter: number): string[] {
  const corners = lowestPoints(meshes, NEAR * unitsPerMeter);
  if (corners.length === 0) return [];
  const middle = corners.reduce((sum, corner) => sum.add(corner), new Vector3()).divideScalar(corners.length);
  const found = new Set<string>();
  for (const corner of corners) {
    for (const share of SHARES) {
      const from = middle.clone().lerp(corner, share);
      from.z += NEAR * unitsPerMeter;
      const below = picker.below(from, except);
      if (below && from.z - below.point.z < 2 * NEAR * unitsPerMeter) found.add(below.object);
    }
  }
  const below = found.size > 0 ? null : picker.below(middle, except);
  return below ? [below.object] : [...found];
}

/** The vertices of the lower face, or some of them. */
function lowestPoints(meshes: Mesh[], height: number): Vector3[] {
  const points = meshes.flatMap((mesh) => {
    const positions = mesh.geometry.getAttribute("position");
    return Array.from({ length: positions.count }, (_, k) =>
      new Vector3().fromBufferAttribute(positions, k).applyMatrix4(mesh.matrixWorld),
    );
  });
  const lowest = points.reduce((least, { z }) => Math.min(least, z), Infinity);
  const corners = points.filter(({ z }) => z < lowest + height);
  const different = [...new Map(corners.map((point) => [point.toArray().map((x) => x.toFixed(3)).join(), point])).values()];
  const step = Math.ceil(different.length / MOST_POINTS);
  return different.filter((_, k) => k % step === 0);
}
