import { Group, type Object3D, type PerspectiveCamera, Vector3 } from "three";
import { heldObject } from "../studio";
import { PlumbLine } from "./plumb_line";
import { Ghost, type Rest } from "./ghost";
import type { Hands } from "./hands";
import { Models } from "./models";
import type { DropShadow } from "./drop_shadow";
import type { Picker } from "./pick";
import type { Rings } from "./rings";
import { DragPlane } from "./drag_plane";
import { guides, hasRings, isOnRail } from "./signals";

const FLOOR_DEPTH = 0.9; // [m]

/** Drag guides: show where a held object is and how it can be moved. Not visible to the robot. */
export class DragGuides {
  readonly root = new Group();
  private readonly dragPlane = new DragPlane();
  private readonly plumbLine = new PlumbLine();
  private readonly ghost: Ghost;
  private unitsPerMeter = 10;
  private shown: string | null = null;
  private isGuided = guides.value;

  constructor(
    private readonly models: Models,
    private readonly picker: Picker,
    private readonly rings: Rings,
    private readonly hands: Hands,
    private readonly dropShadow: DropShadow,
    onChange: () => void,
  ) {
    this.ghost = new Ghost((object) => models.piecesOf(object), picker, onChange);
    this.root.add(...this.dragPlane.parts, ...this.plumbLine.parts, this.ghost.root, rings.root);
  }

  get ghostRoot(): Object3D {
    return this.ghost.root;
  }

  /** What the held object would rest on, if that is known. */
  get rest(): Rest | null {
    return this.ghost.rest;
  }

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
    this.dragPlane.setScale(unitsPerMeter);
    this.plumbLine.setScale(unitsPerMeter);
    this.dropShadow.setScale(unitsPerMeter);
    this.ghost.setScale(unitsPerMeter);
  }

  setSize(width: number, height: number): void {
    this.dragPlane.setSize(width, height);
    this.plumbLine.setSize(width, height);
    this.ghost.setSize(width, height);
  }

  /** @param isNew whether what is there, and how it looks, may be another than the last time */
  update(camera: PerspectiveCamera, isNew: boolean): void {
    const held = this.hands.canAct ? heldObject.value : null;
    const group = held === null ? null : this.models.groupOf(held);
    const pieces = held === null ? [] : this.models.piecesOf(held);
    const ball = Models.ballAbout(pieces);
    const isOther = held !== this.shown || guides.value !== this.isGuided;
    if (isNew || this.models.moved.size > 0 || isOther) this.ghost.update();
    this.shown = held;
    this.isGuided = guides.value;
    // What follows a rail is not turned, and needs no plane.
    if (held === null || group === null || ball === null || isOnRail.value) {
      this.dragPlane.hide();
      this.plumbLine.hide();
      this.dropShadow.hide();
      this.rings.hide();
      return;
    }
    const others = this.models.pieces.filter(
      (piece) => piece.object !== held && !this.models.isOfRobot(piece),
    );
    const isCutNew = isNew || others.some(({ mesh }) => mesh.parent && this.models.moved.has(mesh.parent));
    this.dragPlane.show(this.hands.planeNormal, this.hands.goal ?? group.position, others, isCutNew);
    const floor = new Vector3(ball.center.x, ball.center.y, -FLOOR_DEPTH * this.unitsPerMeter);
    this.plumbLine.show(ball.center, this.picker.below(ball.center, held)?.point ?? floor);
    this.dropShadow.show(pieces, ball.center, ball.radius);
    if (this.hands.isCarrying.value || !hasRings.value) this.rings.hide();
    else {
      const radius = ball.radius + ball.center.distanceTo(group.position);
      this.rings.show(group.position, radius, this.hands.turning.value?.axis ?? null, camera);
    }
  }
}
