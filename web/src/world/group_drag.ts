import { Group, Mesh, MeshLambertMaterial, type Vector3 } from "three";
import { guideColors } from "../colors";
import type { Point } from "../protocol";
import type { Drag } from "./hands";
import type { Models } from "./models";
import { meet, type Picker, type PointerAt } from "./pick";
import { moveSelected, selected } from "./selection";

/** Drags the selected objects together: shadows of them go along, and they follow when they are let go. */
export class GroupDrag {
  readonly root = new Group();
  private readonly material = new MeshLambertMaterial({ color: guideColors.ghost, transparent: true, opacity: 0.5 });

  constructor(
    private readonly models: Models,
    private readonly picker: Picker,
    private readonly onChange: () => void,
  ) {
    this.root.visible = false;
  }

  /** @param normal of the plane that is dragged in */
  begin(from: PointerAt, point: Vector3, normal: Vector3): Drag {
    const start = meet(this.picker.rayOf(from), normal, point) ?? point.clone();
    let isMoved = false;
    return {
      move: (at) => {
        if (!isMoved) this.copy();
        isMoved = true;
        const now = meet(this.picker.rayOf(at), normal, start);
        if (now !== null) this.root.position.copy(now.sub(start));
        this.root.visible = true;
        this.onChange();
      },
      end: () => {
        const by = this.root.position.toArray().map((value) => Math.round(value * 1000) / 1000) as Point;
        this.root.visible = false;
        this.root.clear();
        this.root.position.set(0, 0, 0);
        this.onChange();
        if (isMoved) moveSelected(by);
      },
    };
  }

  private copy(): void {
    this.root.clear();
    for (const object of selected.value) {
      for (const { mesh } of this.models.piecesOf(object)) {
        const piece = new Mesh(mesh.geometry, this.material);
        mesh.matrixWorld.decompose(piece.position, piece.quaternion, piece.scale);
        piece.renderOrder = 3;
        this.root.add(piece);
      }
    }
    this.root.position.set(0, 0, 0);
  }
}
