import { Group, type PerspectiveCamera } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { guideColors } from "../colors";
import { disc } from "./disc";
import type { MeasuredPoint } from "./measured";
import { apparentDistance } from "./view_camera";

const ORDER = 34;
/** Of a disc's height to the distance from the eye. */
const SIZE = 0.022;

/**
 * The points that are measured, with their letters, and the lines between them; seen through everything. Points
 * on corners and edges, which are exact, have square marks.
 */
export class MeasureLines {
  readonly root = new Group();
  private readonly marks = ["A", "B", "C"].map((letter) => ({
    disc: disc(letter, guideColors.measure, ORDER),
    square: disc(letter, guideColors.measure, ORDER, true),
  }));
  private readonly lines = new LineSegments2(
    new LineSegmentsGeometry().setPositions([0, 0, 0, 0, 0, 1]),
    new LineMaterial({ color: guideColors.measure, linewidth: 2.5, depthTest: false, transparent: true }),
  );
  private points: MeasuredPoint[] = [];

  constructor() {
    this.lines.renderOrder = ORDER - 1;
    this.lines.frustumCulled = false;
    this.root.add(this.lines, ...this.marks.flatMap(({ disc, square }) => [disc, square]));
    this.show([]);
  }

  setSize(width: number, height: number): void {
    this.lines.material.resolution.set(width, height);
  }

  show(points: MeasuredPoint[]): void {
    this.points = points;
    const ways = points.slice(1).flatMap(({ place }, k) => [...points[k]!.place, ...place]);
    this.lines.visible = ways.length > 0;
    if (this.lines.visible) this.lines.geometry = new LineSegmentsGeometry().setPositions(ways);
  }

  update(camera: PerspectiveCamera): void {
    for (const [k, { disc: round, square }] of this.marks.entries()) {
      const point = this.points[k];
      const isExact = point?.kind === "corner" || point?.kind === "edge";
      round.visible = point !== undefined && !isExact;
      square.visible = isExact;
      if (point === undefined) continue;
      for (const sprite of [round, square]) {
        sprite.position.set(...point.place);
        sprite.scale.setScalar(SIZE * apparentDistance(camera, sprite.position));
      }
    }
  }
}
