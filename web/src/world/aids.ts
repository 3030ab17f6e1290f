import { Group, type Object3D, type PerspectiveCamera, Vector3 } from "three";
import { heldObject } from "../studio";
import { Drop } from "./drop";
import { Ghost } from "./ghost";
import type { Hands } from "./hands";
import { Models } from "./models";
import type { Overhead } from "./overhead";
import type { Picker } from "./pick";
import type { Rings } from "./rings";
import { Sheet } from "./sheet";
import { guides } from "./signals";

const FLOOR_DEPTH = 0.9; // [m]

/** What helps to see where a held object is and how it may be moved. The robot never sees it. */
export class Aids {
  readonly root = new Group();
  private readonly sheet = new Sheet();
  private readonly drop = new Drop();
  private readonly ghost: Ghost;
  private unitsPerMeter = 10;
  private shown: string | null = null;
  private isGuided = guides.value;

  constructor(
    private readonly models: Models,
    private readonly picker: Picker,
    private readonly rings: Rings,
    private readonly hands: Hands,
    private readonly overhead: Overhead,
    onChange: () => void,
  ) {
    this.ghost = new Ghost((object) => models.piecesOf(object), onChange);
    this.root.add(...this.sheet.parts, ...this.drop.parts, this.ghost.root, rings.root);
  }

  get ghostRoot(): Object3D {
    return this.ghost.root;
  }

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
    this.sheet.setScale(unitsPerMeter);
    this.drop.setScale(unitsPerMeter);
    this.overhead.setScale(unitsPerMeter);
    this.ghost.setScale(unitsPerMeter);
  }

  setSize(width: number, height: number): void {
    this.sheet.setSize(width, height);
    this.drop.setSize(width, height);
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
    if (held === null || group === null || ball === null) {
      this.sheet.hide();
      this.drop.hide();
      this.overhead.hide();
      this.rings.hide();
      return;
    }
    const others = this.models.pieces.filter(
      (piece) => piece.object !== held && !this.models.isOfRobot(piece),
    );
    const isCutNew = isNew || others.some(({ mesh }) => mesh.parent && this.models.moved.has(mesh.parent));
    this.sheet.show(this.hands.planeNormal, this.hands.goal ?? group.position, others, isCutNew);
    const floor = new Vector3(ball.center.x, ball.center.y, -FLOOR_DEPTH * this.unitsPerMeter);
    this.drop.show(ball.center, this.picker.below(ball.center, held)?.point ?? floor);
    this.overhead.show(pieces, ball.center, ball.radius);
    if (this.hands.isCarrying.value) this.rings.hide();
    else {
      const radius = ball.radius + ball.center.distanceTo(group.position);
      this.rings.show(group.position, radius, this.hands.turning.value?.axis ?? null, camera);
    }
  }
}
