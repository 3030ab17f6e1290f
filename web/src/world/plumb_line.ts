import { Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { guideColors } from "../colors";

/** Plumb line: a line straight down from a held object, with a mark where it ends. */
export class PlumbLine {
  private readonly line = new LineSegments2(
    new LineSegmentsGeometry().setPositions([0, 0, 0, 0, 0, -1]),
    new LineMaterial({
      color: guideColors.plumbLine,
      linewidth: 2,
      dashed: true,
      dashSize: 0.12,
      gapSize: 0.08,
      transparent: true,
      opacity: 0.8,
    }),
  );
  private readonly aim = new Mesh(
    new RingGeometry(0.1, 0.15, 40),
    new MeshBasicMaterial({ color: guideColors.plumbLine, transparent: true, opacity: 0.8, depthWrite: false }),
  );
  readonly parts = [this.line, this.aim];
  private unitsPerMeter = 10;

  constructor() {
    this.line.renderOrder = 7;
    this.line.frustumCulled = false;
    this.aim.renderOrder = 7;
    this.hide();
  }

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
    this.line.material.dashScale = 10 / unitsPerMeter;
  }

  setSize(width: number, height: number): void {
    this.line.material.resolution.set(width, height);
  }

  hide(): void {
    for (const part of this.parts) part.visible = false;
  }

  /** From a point in the object to the one below it. */
  show(from: Vector3, to: Vector3): void {
    const lift = 0.0008 * this.unitsPerMeter; // above what it lies on
    this.line.geometry.setPositions([...from.toArray(), ...to.toArray()]);
    this.line.computeLineDistances();
    this.aim.position.set(to.x, to.y, to.z + lift);
    this.aim.scale.setScalar(0.1 * this.unitsPerMeter);
    for (const part of this.parts) part.visible = true;
  }
}
