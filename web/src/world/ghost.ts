import { Group, Mesh, MeshBasicMaterial, MeshLambertMaterial } from "three";
import { guideColors } from "../colors";
import type { Pose, Reply } from "../protocol";
import { isOffered } from "../allowed";
import { currentHand, heldObject, request } from "../studio";
import type { Piece } from "./models";
import { MARK, Outline } from "./outline";
import type { Picker } from "./pick";
import { guides } from "./signals";
import { type Supports, supportsOf } from "./supports";

/** The program tries out how things fall: it is not asked more often [ms]. */
const PAUSE_MS = 300;

/** Nearer than this to where it is it need not be shown [m, rad]. */
const NEAR = 0.008;
const NEAR_ANGLE = 0.05;
const OUTLINE_PIXELS = 2;

/** What the held object would rest on; null: it would fall off the table. */
export type Rest = { object: string; supports: Supports | null };

/** Where the held object would come to rest if it were let go now. */
export class Ghost {
  readonly root = new Group();
  private readonly material = new MeshLambertMaterial({
    color: guideColors.ghost,
    transparent: true,
    opacity: 0.4,
    depthWrite: false,
  });
  /** Its faces behind one another are drawn once: the nearest. */
  private readonly nearest = new MeshBasicMaterial({ colorWrite: false, transparent: true });
  /** Also seen through the held object and the robot. */
  private readonly outline = new Outline(OUTLINE_PIXELS, guideColors.ghost, MARK + 1);
  /** What was found last, also while the object is there already. */
  rest: Rest | null = null;
  private object: string | null = null;
  private isWaiting = false;
  private isOutdated = false;
  private unitsPerMeter = 10;

  constructor(
    private readonly piecesOf: (object: string) => Piece[],
    private readonly picker: Picker,
    private readonly onChange: () => void,
  ) {
    this.root.visible = false;
  }

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
  }

  setSize(width: number, height: number): void {
    this.outline.setSize(width, height);
  }

  /** To be called when the held object, or what is below it, has moved. */
  update(): void {
    const object = guides.value && isOffered("resting_place") ? heldObject.value : null;
    if (object === null) {
      this.root.visible = false;
      this.object = this.rest = null;
    } else if (this.isWaiting) {
      this.isOutdated = true;
    } else {
      if (this.rest?.object !== object) this.rest = null;
      void this.requestPlace(object);
    }
  }

  private async requestPlace(object: string): Promise<void> {
    this.isWaiting = true;
    this.isOutdated = false;
    const reply = await request("resting_place", { hand: currentHand.value }).catch(() => null);
    if (heldObject.value === object) this.show(object, reply);
    // What was found before all came to rest is shown, but not for long.
    if (reply?.["stale"] === true) this.isOutdated = true;
    await new Promise((resolve) => setTimeout(resolve, PAUSE_MS));
    this.isWaiting = false;
    if (this.isOutdated) this.update();
  }

  private show(object: string, reply: Reply | null): void {
    const pose = poseOf(reply);
    this.rest = reply === null ? null : { object, supports: null };
    this.root.visible = pose !== null && guides.value;
    if (pose !== null) {
      const [x, y, z, qx, qy, qz, qw] = pose;
      if (this.object !== object) this.copy(object);
      this.root.position.set(x, y, z);
      this.root.quaternion.set(qx, qy, qz, qw);
      this.root.updateMatrixWorld();
      this.rest = { object, supports: supportsOf(this.faces, object, this.picker, this.unitsPerMeter) };
      if (this.isThereAlready(object)) this.root.visible = false;
    }
    this.onChange();
  }

  /** One mesh for each piece. */
  private get faces(): Mesh[] {
    return this.root.children.filter((child): child is Mesh => child instanceof Mesh && child.material === this.material);
  }

  private isThereAlready(object: string): boolean {
    const held = this.piecesOf(object)[0]?.mesh.parent;
    if (!held || held.quaternion.angleTo(this.root.quaternion) > NEAR_ANGLE) return false;
    return held.position.distanceTo(this.root.position) < NEAR * this.unitsPerMeter;
  }

  private copy(object: string): void {
    this.object = object;
    this.root.clear();
    for (const { mesh } of this.piecesOf(object)) {
      for (const [material, order] of [[this.nearest, 2], [this.material, 3]] as const) {
        const piece = new Mesh(mesh.geometry, material);
        piece.position.copy(mesh.position);
        piece.quaternion.copy(mesh.quaternion);
        piece.scale.copy(mesh.scale);
        piece.renderOrder = order;
        this.root.add(piece);
      }
    }
    this.outline.show(this.faces);
  }
}

function poseOf(reply: Reply | null): Pose | null {
  const pose = reply?.["pose"];
  return Array.isArray(pose) && pose.length === 7 ? (pose as Pose) : null;
}
