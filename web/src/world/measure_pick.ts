import { Vector3 } from "three";
import type { Point } from "../protocol";
import type { MeasuredPoint } from "./measured";
import type { Picker } from "./pick";

/** A click no farther from a corner or an edge measures that [px]. */
const REACH = 10;
/** Of the distance from the eye: a point this far behind a surface is hidden. */
const HIDDEN = 0.003;

/** The point that a click measures: a corner or an edge of a block near it, or else what is under it. */
export function measuredAt(at: { x: number; y: number }, picker: Picker): MeasuredPoint | null {
  // A click beside a block, but near its edge, is for the block.
  const around = [-1, 0, 1].flatMap((right) => [-1, 0, 1].map((down) => [0.7 * REACH * right, 0.7 * REACH * down]));
  const picks = around.map(([right = 0, down = 0]) => picker.pick({ x: at.x + right, y: at.y + down }));
  const pieces = new Set(picks.flatMap((picked) => (picked?.object && picked.piece.visual.block ? [picked.piece] : [])));
  const near = (kind: "corner" | "edge", object: string, points: Vector3[]) =>
    points.flatMap((point) => {
      const { x, y } = picker.toPage(point);
      const away = Math.hypot(x - at.x, y - at.y);
      return away <= REACH && isSeen(point, picker) ? [{ away, point: { kind, object, place: point.toArray() as Point } }] : [];
    });
  const ray = picker.rayOf(at);
  const found = [...pieces].map(({ mesh, object }) => {
    const corners = CORNERS.map((corner) => mesh.localToWorld(new Vector3(...corner)));
    const edges = EDGES.map(([from, to]) => {
      const nearest = new Vector3();
      ray.distanceSqToSegment(corners[from]!, corners[to]!, undefined, nearest);
      return nearest;
    });
    return { corners: near("corner", object, corners), edges: near("edge", object, edges) };
  });
  for (const points of [found.flatMap(({ corners }) => corners), found.flatMap(({ edges }) => edges)]) {
    const [best] = points.sort((one, other) => one.away - other.away);
    if (best !== undefined) return best.point;
  }
  const under = picker.pick(at);
  return under && { kind: "surface", object: under.object, place: under.point.toArray() as Point };
}

/** Of a block with edges of length 1. */
const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map((bits): Point => [(bits & 1) - 0.5, ((bits >> 1) & 1) - 0.5, (bits >> 2) - 0.5]);
/** Corners that differ in one coordinate. */
const EDGES = CORNERS.flatMap((_, from) => [1, 2, 4].flatMap((bit) => (from & bit ? [] : [[from, from | bit] as const])));

/** Whether nothing is before a point. */
function isSeen(point: Vector3, picker: Picker): boolean {
  const place = picker.toPage(point);
  const eye = picker.rayOf(place).origin;
  const before = picker.pick(place);
  return before === null || eye.distanceTo(before.point) > (1 - HIDDEN) * eye.distanceTo(point);
}
