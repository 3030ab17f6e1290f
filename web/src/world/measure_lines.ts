import { Group, type PerspectiveCamera, type Sprite, Vector3 } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { guideColors } from "../colors";
import type { Point } from "../protocol";
import { disc } from "./disc";

const ORDER = 34;
/** Of a disc's height to the distance from the eye. */
const SIZE = 0.022;

/** The points that are measured, with their letters, and the lines between them; seen through everything. */
export class MeasureLines {
  readonly root = new Group();
  private readonly discs: Sprite[] = ["A", "B", "C"].map((letter) => disc(letter, guideColors.measure, ORDER));
  private readonly lines = new LineSegments2(
    new LineSegmentsGeometry().setPositions([0, 0, 0, 0, 0, 1]),
    new LineMaterial({ color: guideColors.measure, linewidth: 2.5, depthTest: false, transparent: true }),
  );
  private points: Point[] = [];

  constructor() {
    this.lines.renderOrder = ORDER - 1;
    this.lines.frustumCulled = false;
    this.root.add(this.lines, ...this.discs);
    this.show([]);
  }

  setSize(width: number, height: number): void {
    this.lines.material.resolution.set(width, height);
  }

  show(points: Point[]): void {
    this.points = points;
    const ways = points.slice(1).flatMap((point, k) => [...points[k]!, ...point]);
    this.lines.visible = ways.length > 0;
    if (this.lines.visible) this.lines.geometry = new LineSegmentsGeometry().setPositions(ways);
  }

  update(camera: PerspectiveCamera): void {
    for (const [k, sprite] of this.discs.entries()) {
      const point = this.points[k];
      sprite.visible = point !== undefined;
      if (point === undefined) continue;
      sprite.position.set(...point);
      sprite.scale.setScalar(SIZE * camera.position.distanceTo(new Vector3(...point)));
    }
  }
}
