import {
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  RingGeometry,
  Vector3,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { guideColors } from "../colors";
import type { Piece } from "./models";

/** Of the stencil: where it is dark already, it gets no darker. */
const MARK = 2;

/** What lies straight below a held object: a line down, and its shadow as if the sun stood overhead. */
export class Drop {
  private readonly line = new LineSegments2(
    new LineSegmentsGeometry().setPositions([0, 0, 0, 0, 0, -1]),
    new LineMaterial({
      color: guideColors.drop,
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
    new MeshBasicMaterial({ color: guideColors.drop, transparent: true, opacity: 0.8, depthWrite: false }),
  );
  private readonly shadow = new Group();
  private readonly dark = new MeshBasicMaterial({
    color: "#10141c",
    opacity: 0.3,
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    stencilWrite: true,
    stencilRef: MARK,
    stencilFuncMask: MARK,
    stencilWriteMask: MARK,
    stencilFunc: NotEqualStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });
  readonly parts = [this.line, this.aim, this.shadow];
  private shown: Piece[] = [];
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

  /** From a point in the object to the one below it; `pieces` are the object's. */
  show(from: Vector3, to: Vector3, pieces: Piece[]): void {
    const lift = 0.0008 * this.unitsPerMeter; // above what it lies on
    this.line.geometry.setPositions([...from.toArray(), ...to.toArray()]);
    this.line.computeLineDistances();
    this.aim.position.set(to.x, to.y, to.z + lift);
    this.aim.scale.setScalar(0.1 * this.unitsPerMeter);
    this.flatten(pieces, to.z + lift);
    for (const part of this.parts) part.visible = true;
  }

  private flatten(pieces: Piece[], height: number): void {
    if (pieces.length !== this.shown.length || pieces.some((piece, k) => piece !== this.shown[k])) {
      this.shown = pieces;
      this.shadow.clear();
      for (const { mesh } of pieces) {
        const flat = new Mesh(mesh.geometry, this.dark);
        flat.matrixAutoUpdate = false;
        flat.frustumCulled = false;
        flat.renderOrder = 4;
        this.shadow.add(flat);
      }
    }
    const press = new Matrix4().makeScale(1, 1, 0).setPosition(0, 0, height);
    this.shadow.children.forEach((flat, k) => flat.matrix.multiplyMatrices(press, pieces[k]!.mesh.matrixWorld));
  }
}
