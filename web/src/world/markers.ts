import { Group, Mesh, MeshBasicMaterial, OctahedronGeometry } from "three";
import { guideColors } from "../colors";
import type { Point } from "../protocol";

const RADIUS = 0.012; // [m]

/** The points that are marked for people; seen through everything, since one looks for them. */
export class Markers {
  readonly root = new Group();
  private readonly shape = new OctahedronGeometry(1);
  private readonly material = new MeshBasicMaterial({
    color: guideColors.marker,
    transparent: true,
    opacity: 0.85,
    depthTest: false,
    toneMapped: false,
  });
  private unitsPerMeter = 10;
  private points: Point[] = [];

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
    this.show(this.points);
  }

  show(points: Point[]): void {
    this.points = points;
    this.root.clear();
    for (const point of points) {
      const marker = new Mesh(this.shape, this.material);
      marker.position.set(...point);
      marker.scale.setScalar(RADIUS * this.unitsPerMeter);
      marker.renderOrder = 25;
      this.root.add(marker);
    }
  }
}
