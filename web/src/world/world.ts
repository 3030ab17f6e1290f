import { effect } from "@preact/signals";
import { type Sphere, Vector3 } from "three";
import { handColors } from "../colors";
import { listenToKeys } from "../keys";
import type { Point, Poses, SceneMessage } from "../protocol";
import { currentHand, heldObject, isController, poseListeners, scene, state, variants } from "../studio";
import { bringToWork } from "./bring_tool";
import { cuboidsOf } from "./cuboids";
import { DragGuides } from "./drag_guides";
import { DetailController } from "./detail";
import { GroupDrag } from "./group_drag";
import { Hands } from "./hands";
import { actionsOf } from "./key_actions";
import { Markers } from "./markers";
import { Marks } from "./marks";
import { MeasureLines } from "./measure_lines";
import { measured } from "./measured";
import { Models } from "./models";
import { DropShadow } from "./drop_shadow";
import { Picker, type PointerAt } from "./pick";
import { PlacementLabel } from "./placement_label";
import { Pointers } from "./pointers";
import { nameOf, Rings } from "./rings";
import { areAidsFixed, cameraKind, canDraw, chosenView, contextMenu, guides, hovered, isBringing, isLowDetail, type Preset } from "./signals";
import { selected } from "./selection";
import { Stage } from "./stage";
import { straighteningTurn } from "./straighten";
import { provideTestHook } from "./test_hook";
import { ToolHint } from "./tool_hint";
import { ViewCamera } from "./view_camera";

export * from "./signals";

/** The world as the rest of the page has it. */
export interface World {
  showPreset(name: Preset): void;
  /** The view that was chosen last, or the one that suits the scene. */
  showFirstView(): void;
  /** The view with which the scene begins. */
  showScenesView(): void;
  /** The id of an object, or "robot". */
  focus(objectId: string): void;
  setLowDetail(mode: "auto" | "low" | "high"): void;
  /** Of the current hand. */
  turnPlane(deltaDegrees: number): void;
  /** What the held object would have to be turned by to be straight [degrees]; null if none is held. */
  straighteningTurn(): Point | null;
  /** Brings the tool in the current hand to where it can work. */
  bringToWork(): void;
  /** The origin of an object, as it is drawn [units]; null where it is not. */
  placeOf(objectId: string): [x: number, y: number, z: number] | null;
  /** The highest point of what is under a place of the page, from which on there is room; null beside all [units]. */
  roomAt(at: { x: number; y: number }): [x: number, y: number, z: number] | null;
  /** What lies to the right in the picture: a horizontal direction of length 1. */
  readonly right: readonly [x: number, y: number];
  /** Where the camera is and what it looks at: two points, one after the other [units]. */
  readonly cameraPlace: readonly number[];
  dispose(): void;
}

/** Draws the world in there, and lets people reach into it; `canDraw` is whether that works. */
export function mountWorld(host: HTMLElement): World {
  canDraw.value = document.createElement("canvas").getContext("webgl2") !== null;
  if (canDraw.value) return new DrawnWorld(host);
  return { showPreset() {}, showFirstView() {}, showScenesView() {}, focus() {}, setLowDetail() {}, turnPlane() {}, straighteningTurn: () => null, bringToWork() {}, placeOf: () => null, roomAt: () => null, right: [1, 0], cameraPlace: [], dispose() {} };
}

/** Above everything on the table [units]. */
const HIGH = 1000;

class DrawnWorld implements World {
  private readonly stage: Stage;
  private readonly dropShadow = new DropShadow();
  private readonly models = new Models(
    (material) => this.dropShadow.addTo(material),
    () => this.redraw(true),
  );
  private readonly camera: ViewCamera;
  private readonly picker: Picker;
  private readonly rings = new Rings();
  private readonly marks = new Marks();
  private readonly markers = new Markers();
  private readonly measureLines = new MeasureLines();
  private readonly groupDrag: GroupDrag;
  private readonly hands: Hands;
  private readonly dragGuides: DragGuides;
  private readonly toolHint: ToolHint;
  private readonly placementLabel: PlacementLabel;
  private readonly pointers: Pointers;
  private readonly detail = new DetailController(
    (isLow) => this.setDetail(isLow),
    (isCoarse) => this.setCoarse(isCoarse),
  );
  private readonly tag = document.createElement("output");
  private readonly quit: (() => void)[] = [];
  private frame = 0;
  private askedAt = 0;
  private lastDrawn = 0;
  private hasMoved = true;
  private hoverAt: PointerAt | null = null;
  /** Null before the first scene. */
  private sceneName: string | null = null;
  /** What of the last state is to be seen, beside what moves. */
  private seenState = "";

  constructor(private readonly host: HTMLElement) {
    this.stage = new Stage(host, () => this.resized());
    isLowDetail.value = this.stage.isLow;
    this.models.setDetail(this.stage.isLow);
    this.camera = new ViewCamera(this.stage.camera, () => this.redraw());
    this.picker = new Picker(this.stage, this.models);
    this.groupDrag = new GroupDrag(this.models, this.picker, () => this.redraw());
    this.hands = new Hands(
      this.picker,
      this.rings,
      this.camera,
      (object) => this.models.groupOf(object)?.position.clone() ?? null,
      this.groupDrag,
      () => this.redraw(),
    );
    this.dragGuides = new DragGuides(this.models, this.picker, this.rings, this.hands, this.dropShadow, () => this.redraw());
    this.placementLabel = new PlacementLabel(host, this.models, this.picker);
    this.toolHint = new ToolHint(host, this.models, this.picker, this.placementLabel.output);
    this.pointers = new Pointers(host, this.picker, this.hands, this.camera, (at) => this.hover(at));
    const parts = [this.models, this.groupDrag, this.dragGuides, this.marks, this.markers, this.measureLines, this.toolHint];
    for (const { root } of parts) this.stage.scene.add(root);
    this.styleTag();
    this.listen();
    this.resized();
    const { stage, models, picker, rings, hands } = this;
    provideTestHook({ stage, models, picker, rings, hands, ghost: this.dragGuides.ghostRoot, toolMark: this.toolHint.root });
  }

  showPreset(name: Preset): void {
    chosenView.value = name;
    this.camera.show(name, false, this.ballsOnTable());
  }

  showFirstView(isSudden = false): void {
    // In a study, all participants begin with the same view.
    const chosen = areAidsFixed.peek() ? "default" : chosenView.peek();
    const message = scene.peek();
    if (chosen === "default" && message?.view) return this.camera.showScenes(message.view, isSudden);
    const usual = message?.robotFrame === null ? "robot" : "front";
    // The view from above depends on the one before.
    if (isSudden) this.camera.show(usual, true);
    this.camera.show(chosen === "default" ? usual : chosen, isSudden);
  }

  showScenesView(): void {
    chosenView.value = "default";
    this.showFirstView();
  }

  /** Those of all objects that did not fall. */
  private ballsOnTable(): Sphere[] {
    const { fallen = [], gone = [] } = state.peek() ?? {};
    const objects = (scene.peek()?.objects ?? []).map(({ id }) => id).filter((id) => !fallen.includes(id) && !gone.includes(id));
    return objects.flatMap((id) => Models.ballAbout(this.models.piecesOf(id)) ?? []);
  }

  focus(objectId: string): void {
    const isRobot = objectId === "robot" && this.models.groupOf(objectId) === null;
    const pieces = isRobot
      ? this.models.pieces.filter((piece) => this.models.isOfRobot(piece))
      : this.models.piecesOf(objectId);
    const ball = Models.ballAbout(pieces);
    if (ball) this.camera.focus(ball.center, ball.radius);
  }

  setLowDetail(mode: "auto" | "low" | "high"): void {
    this.detail.setMode(mode);
  }

  turnPlane(deltaDegrees: number): void {
    this.hands.turnPlane(deltaDegrees);
  }

  straighteningTurn(): Point | null {
    const cuboids = scene.value ? cuboidsOf(this.models, scene.value, new Map()) : null;
    const own = cuboids?.get(heldObject.value ?? "none");
    if (cuboids === null || own === undefined) return null;
    cuboids.delete(own.object);
    return straighteningTurn(own, [...cuboids.values()], this.placementLabel.turnedFrom);
  }

  bringToWork(): void {
    if (!this.hands.canAct || isBringing.value) return;
    isBringing.value = true;
    void bringToWork(this.models).finally(() => (isBringing.value = false));
  }

  roomAt(at: { x: number; y: number }): [x: number, y: number, z: number] | null {
    const element = document.elementFromPoint(at.x, at.y);
    if (!(element instanceof HTMLCanvasElement) && element !== this.host) return null;
    const point = this.picker.pick(at)?.point;
    if (point === undefined) return null;
    return this.picker.below(point.clone().setZ(HIGH), null)?.point.toArray() ?? null;
  }

  placeOf(objectId: string): [x: number, y: number, z: number] | null {
    return this.models.groupOf(objectId)?.position.toArray() ?? null;
  }

  get right(): [x: number, y: number] {
    const { x, y } = this.camera.right;
    return [x, y];
  }

  get cameraPlace(): number[] {
    return this.camera.points;
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    for (const end of this.quit) end();
    this.detail.dispose();
    this.pointers.dispose();
    this.tag.remove();
    this.toolHint.dispose();
    this.placementLabel.dispose();
    this.stage.dispose();
  }

  private listen(): void {
    const takePoses = (poses: Poses) => {
      const held = heldObject.value;
      this.hands.latency.take(poses, held === null ? null : this.models.frameNumberOf(held));
      this.models.take(poses);
    };
    poseListeners.add(takePoses);
    this.quit.push(
      () => poseListeners.delete(takePoses),
      effect(() => this.load()),
      effect(() => this.models.setVariants(variants.value)),
      effect(() => this.takeState()),
      effect(() => void [currentHand.value, hovered.value, guides.value, selected.value, isController.value, this.redraw()]),
      effect(() => this.writeTag()),
      effect(() => {
        this.measureLines.show(measured.value ?? []);
        this.redraw();
      }),
      listenToKeys(
        actionsOf(
          this.hands,
          this.camera,
          this.pointers,
          (object) => this.focus(object),
          (preset) => this.showPreset(preset),
        ),
      ),
      listenToControl((isDown) => this.hands.setControl(isDown)),
    );
  }

  private load(): void {
    const message = scene.value;
    if (message === null) return;
    const unitsPerMeter = 1 / message.metersPerUnit;
    const center = new Vector3(...(message.center ?? [0, 0, 0]));
    for (const part of [this.stage, this.dragGuides, this.hands, this.markers]) part.setScale(unitsPerMeter, center);
    this.camera.setTable(unitsPerMeter, message.table.size[1], message.robotFrame !== null, center);
    this.models.load(message);
    this.placementLabel.forget();
    hovered.value = null;
    contextMenu.value = null;
    if (measured.peek() !== null) measured.value = [];
    this.takeView(message);
  }

  /** Another scene is looked at as it wants, or else from the chosen side; a close view would miss it. */
  private takeView({ name, view = null }: SceneMessage): void {
    const isOther = name !== this.sceneName;
    if (this.sceneName === null) this.showFirstView(true);
    else if (isOther && view !== null) this.camera.showScenes(view);
    else if (isOther && cameraKind.value === "free") this.showFirstView();
    this.sceneName = name;
  }

  private takeState(): void {
    const message = state.value;
    if (message === null) return;
    this.models.setGone(message.gone);
    this.models.setRobotShown(message.robot?.shown ?? true);
    const seen = JSON.stringify([message.hands, message.uses, message.mode, message.markers, message.still]);
    if (seen === this.seenState) return;
    this.seenState = seen;
    this.markers.show(message.markers);
    this.redraw();
  }

  private hover(at: PointerAt | null): void {
    this.hoverAt = at;
    if (at === null) hovered.value = null;
    this.redraw();
  }

  /** What the mouse is on, once a picture. */
  private lookUnderMouse(): void {
    if (this.hoverAt === null || this.pointers.isBusy) return;
    const picked = this.picker.pick(this.hoverAt);
    const ring = this.hands.ringUnder(this.hoverAt, picked);
    this.rings.hovered = ring?.axis ?? null;
    hovered.value = (ring === null && picked?.object) || null;
    const isGrip = ring !== null || (hovered.value !== null && hovered.value === heldObject.value);
    this.host.style.cursor = isGrip ? "grab" : hovered.value !== null ? "pointer" : "";
    this.hoverAt = null;
  }

  private setDetail(isLow: boolean): void {
    this.stage.setDetail(isLow);
    this.models.setDetail(isLow);
  }

  private setCoarse(isCoarse: boolean): void {
    this.stage.setCoarse(isCoarse);
    if (!isCoarse) this.redraw();
  }

  private resized(): void {
    const { width, height } = this.stage;
    for (const part of [this.marks, this.dragGuides, this.measureLines]) part.setSize(width, height);
    this.redraw();
  }

  /** Draws once more, when it is time: nothing is drawn while nothing changes. */
  private redraw(hasMoved = false): void {
    this.hasMoved ||= hasMoved;
    if (this.frame !== 0) return;
    this.askedAt = performance.now();
    this.frame = requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    this.frame = 0;
    const now = performance.now();
    const seconds = Math.min(0.1, (now - this.lastDrawn) / 1000);
    this.lastDrawn = now;
    this.detail.note(this.askedAt, now);
    const isCameraMoving = this.camera.update(seconds);
    this.models.follow(seconds);
    const hasMoved = this.hasMoved || this.models.moved.size > 0;
    this.models.root.updateMatrixWorld();
    this.lookUnderMouse();
    this.marks.update(this.models, this.stage.camera);
    this.measureLines.update(this.stage.camera);
    this.dragGuides.update(this.stage.camera, this.hasMoved);
    this.updatePlacementLabel(hasMoved);
    this.toolHint.update(this.stage.camera);
    this.hasMoved = false;
    if (hasMoved) this.stage.shadowsMoved();
    this.dropShadow.draw(this.stage);
    this.stage.draw();
    if (isCameraMoving || this.models.isMoving) this.redraw();
  }

  private updatePlacementLabel(isNew: boolean): void {
    const { ghostRoot, rest } = this.dragGuides;
    const held = this.hands.canAct ? heldObject.value : null;
    if (!this.hands.canAct) this.placementLabel.forget();
    const ghost = held !== null && ghostRoot.visible ? ghostRoot : null;
    this.placementLabel.update(this.stage.camera, held, rest, ghost, isNew);
  }

  /** How far a ring is turned. */
  private styleTag(): void {
    this.tag.style.cssText =
      "position:absolute;transform:translate(18px,-34px);padding:2px 8px;border-radius:6px;" +
      "background:#151a22e0;color:#fff;font:600 14px system-ui,sans-serif;pointer-events:none;" +
      `border-left:4px solid ${handColors.any}`;
    this.host.append(this.tag);
  }

  private writeTag(): void {
    const turning = this.hands.turning.value;
    this.tag.hidden = turning === null;
    if (turning === null) return;
    const box = this.host.getBoundingClientRect();
    const { x, y } = this.picker.toPage(this.rings.root.position);
    this.tag.textContent = `${nameOf(turning.axis)} ${turning.degrees > 0 ? "+" : ""}${turning.degrees}°`;
    this.tag.style.left = `${x - box.left}px`;
    this.tag.style.top = `${y - box.top}px`;
  }
}

function listenToControl(set: (isDown: boolean) => void): () => void {
  const listener = (event: KeyboardEvent) => {
    if (event.key === "Control") set(event.type === "keydown");
  };
  window.addEventListener("keydown", listener);
  window.addEventListener("keyup", listener);
  return () => {
    window.removeEventListener("keydown", listener);
    window.removeEventListener("keyup", listener);
  };
}
