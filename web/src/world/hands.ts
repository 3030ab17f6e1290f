import { signal } from "@preact/signals";
import { Vector3 } from "three";
import { isCommandOffered, may } from "../allowed";
import type { Command } from "../commands";
import { HANDS, type HandName, type Point } from "../protocol";
import { command, currentHand, heldObject, scene, state } from "../studio";
import type { GroupDrag } from "./group_drag";
import { Latency } from "./latency";
import { meet, type Picked, type Picker, type PointerAt } from "./pick";
import { type Axis, directionOf, type Rings } from "./rings";
import { moveSelected, selected, toggleSelected } from "./selection";
import { Sender } from "./sender";
import { areAidsFixed, contextMenu, isOnRail } from "./signals";
import type { ViewCamera } from "./view_camera";

const DEGREES = 180 / Math.PI;
const STEEP = 70 / DEGREES; // from here on the camera looks at the table rather than along it
const BIG_STEP = 45; // [degrees]
const REACH = 3; // from the middle of the table [m]
/** Time for which the last sent value is newer than the state of the program [ms]. */
const FRESH_MS = 250;
const NUDGE = 0.1;
const BIG_NUDGE = 1; // [units]

/** What a pressed pointer does until it is released. */
export interface Drag {
  move(at: PointerAt): void;
  end(): void;
}

/** The demonstrator's hands, as a mouse or a finger has them: what presses, drags and clicks command. */
export class Hands {
  readonly latency = new Latency();
  /** The ring that is being turned, and how far [degrees]. */
  readonly turning = signal<{ axis: Axis; degrees: number } | null>(null);
  readonly isCarrying = signal(false);
  private readonly moves = new Sender((seq) => this.latency.note(seq));
  private readonly turns = new Sender((seq) => this.latency.note(seq));
  private readonly planes = new Sender();
  private sentGoal: { point: Vector3; hand: HandName; when: number } | null = null;
  private sentPlane: { angle: number; hand: HandName; when: number } | null = null;
  private isControlDown = false;
  private unitsPerMeter = 10;
  private center = new Vector3();

  constructor(
    private readonly picker: Picker,
    private readonly rings: Rings,
    private readonly camera: ViewCamera,
    private readonly placeOf: (object: string) => Vector3 | null,
    private readonly group: GroupDrag,
    private readonly onChange: () => void,
  ) {}

  setScale(unitsPerMeter: number, center: Vector3): void {
    this.unitsPerMeter = unitsPerMeter;
    this.center = center;
  }

  get canAct(): boolean {
    return may("command") === true;
  }

  /** Whether every command of a drag was sent and answered. */
  get isIdle(): boolean {
    return [this.moves, this.turns, this.planes].every((sender) => sender.isIdle);
  }

  /** What dragging would do from here; null: nothing. */
  press(at: PointerAt, picked: Picked | null): Drag | null {
    if (!this.canAct) return null;
    const held = heldObject.value;
    if (held === null) {
      if (picked && this.isOfGroup(picked)) return this.group.begin(at, picked.point, this.groupNormal);
      return this.grabOnceMoved(at, picked);
    }
    const ring = this.ringUnder(at, picked);
    if (ring !== null) return this.turn(at, ring);
    if (picked?.object === held) return this.carry(at, Promise.resolve(true));
    const other = this.otherHandWith(picked);
    if (other !== null) return this.carryOnceMoved(at, () => this.become(other));
    return this.grabOnceMoved(at, picked);
  }

  /** A ring is gripped by its letter first. Before the held object itself, only the letters can be gripped. */
  ringUnder(at: PointerAt, picked: Picked | null): { axis: Axis; point: Vector3 } | null {
    const held = heldObject.value;
    if (!this.canAct || held === null) return null;
    const ray = this.picker.rayOf(at);
    return this.rings.pickLetter(ray) ?? (picked?.object === held ? null : this.rings.pick(ray));
  }

  click(at: PointerAt, picked: Picked | null): void {
    if (!this.canAct) return;
    const held = heldObject.value;
    const maySelect = !areAidsFixed.value && isCommandOffered("displace");
    if (held === null && at.isShift && picked?.object && maySelect) toggleSelected(picked.object);
    else if (held === null && picked && isControl(picked)) this.menu(at, picked);
    else if (held === null && picked?.object && !isFixed(picked.object)) void this.grasp(picked.object, picked.point);
    else if (held !== null && picked?.object !== held && this.ringUnder(at, picked) === null) this.changeOrRelease(picked);
  }

  menu({ x, y }: PointerAt, picked: Picked | null): void {
    if (!this.canAct || !picked?.object) return;
    const { object, part, button, point } = picked;
    contextMenu.value = { x, y, object, part, button, point: point.toArray() };
  }

  /** At a point, or its origin; then its plane faces the camera. */
  async grasp(object: string, point: Vector3 | null): Promise<boolean> {
    if (!this.canAct) return false;
    const hand = currentHand.value;
    const where = point === null ? {} : { point: rounded(point) };
    if ((await command({ hand, do: "grasp", object, ...where })) === null) return false;
    const { x, y } = this.camera.right;
    this.sentGoal = point && { point: point.clone(), hand, when: performance.now() };
    this.setPlane(Math.round(Math.atan2(y, x) * DEGREES));
    return true;
  }

  release(): void {
    if (this.canAct && heldObject.value) void command({ hand: currentHand.value, do: "release" });
  }

  destroy(): void {
    if (this.canAct && heldObject.value) void command({ hand: currentHand.value, do: "destroy" });
  }

  takeNext(): void {
    const next = HANDS[(HANDS.indexOf(currentHand.value) + 1) % HANDS.length];
    if (next) currentHand.value = next;
  }

  /** Small turns take the camera along, so that the plane faces it still. */
  turnPlane(degrees: number): void {
    if (!this.canAct) return;
    this.setPlane(this.planeAngle + degrees);
    const held = heldObject.value;
    const place = held && this.placeOf(held);
    if (place && Math.abs(degrees) < BIG_STEP) this.camera.turnAbout(place, degrees / DEGREES);
  }

  /** Moves the held object by keys: to the right of the picture, away, up; each -1, 0 or 1. */
  nudge(right: number, away: number, up: number, isBig: boolean): void {
    const goal = this.goal;
    if (!this.canAct) return;
    const sideways = this.camera.right;
    const ahead = new Vector3(-sideways.y, sideways.x, 0);
    const step = isBig ? BIG_NUDGE : NUDGE;
    const way = new Vector3(0, 0, up * step).addScaledVector(sideways, right * step).addScaledVector(ahead, away * step);
    if (goal !== null) this.moveTo(goal.add(way));
    else moveSelected(rounded(way));
  }

  /** Several objects are selected, and this is one of them. */
  private isOfGroup({ object }: Picked): boolean {
    return selected.value.length > 1 && selected.value.includes(object);
  }

  /** A group is moved level; upright with Ctrl, facing the camera. */
  private get groupNormal(): Vector3 {
    if (!this.isControlDown) return new Vector3(0, 0, 1);
    const { x, y } = this.camera.right;
    return new Vector3(-y, x, 0);
  }

  /** Pressed, it lets drag level where one would drag upright, and the other way round. */
  setControl(isDown: boolean): void {
    if (isDown === this.isControlDown) return;
    this.isControlDown = isDown;
    this.onChange();
  }

  /** Of the plane that is dragged in: the hand's, or a level one where the camera looks down on it. */
  get planeNormal(): Vector3 {
    if (this.isLevel) return new Vector3(0, 0, 1);
    const angle = this.planeAngle / DEGREES;
    return new Vector3(-Math.sin(angle), Math.cos(angle), 0);
  }

  /** Where the current hand wants the point at which it holds its object. */
  get goal(): Vector3 | null {
    const sent = this.sentGoal;
    const hand = currentHand.value;
    if (sent?.hand === hand && performance.now() - sent.when < FRESH_MS) return sent.point.clone();
    const goal = state.value?.hands[hand].goal;
    return goal ? new Vector3(...goal) : null;
  }

  private get planeAngle(): number {
    const sent = this.sentPlane;
    const hand = currentHand.value;
    if (sent?.hand === hand && performance.now() - sent.when < FRESH_MS) return sent.angle;
    return state.value?.hands[hand].plane ?? 0;
  }

  private get isLevel(): boolean {
    return this.camera.elevation > STEEP !== this.isControlDown;
  }

  private setPlane(degrees: number): void {
    const angle = wrapped(degrees);
    const hand = currentHand.value;
    this.sentPlane = { angle, hand, when: performance.now() };
    this.planes.want(() => ({ hand, do: "plane", angle }));
    this.onChange();
  }

  private moveTo(point: Vector3): void {
    const hand = currentHand.value;
    this.sentGoal = { point, hand, when: performance.now() };
    this.moves.want(() => ({ hand, do: "move_to", position: rounded(point) }));
  }

  /** A user who reaches for an object in another of their hands changes to that hand. */
  private changeOrRelease(picked: Picked | null): void {
    const other = this.otherHandWith(picked);
    if (other !== null) void this.become(other);
    else this.release();
  }

  private otherHandWith(picked: Picked | null): HandName | null {
    if (!picked?.object) return null;
    const others = HANDS.filter((hand) => hand !== currentHand.value);
    return others.find((hand) => state.value?.hands[hand].object === picked.object) ?? null;
  }

  private async become(hand: HandName): Promise<boolean> {
    currentHand.value = hand;
    return true;
  }

  /** A hand that is full is told by the program to release first. */
  private grabOnceMoved(at: PointerAt, picked: Picked | null): Drag | null {
    return picked?.object && !isFixed(picked.object) ? this.carryOnceMoved(at, () => this.grasp(picked.object, picked.point)) : null;
  }

  /** @param takeHold before it is carried; whether that worked */
  private carryOnceMoved(at: PointerAt, takeHold: () => Promise<boolean>): Drag {
    let carrying: Drag | null = null;
    return {
      move: (to) => {
        carrying ??= this.carry(at, takeHold());
        carrying.move(to);
      },
      end: () => carrying?.end(),
    };
  }

  /** The point by which the pointer took the object stays under it. */
  private carry(from: PointerAt, whenHeld: Promise<boolean>): Drag {
    const hand = currentHand.value;
    let [last, latest] = [from, from];
    let isHeld = false;
    let place: Vector3 | null = null;
    const offset = new Vector3();
    const normal = new Vector3();
    const step = (): Command | null => {
      place ??= this.goal;
      if (place === null) return null;
      if (!normal.equals(this.planeNormal)) {
        normal.copy(this.planeNormal);
        const hit = meet(this.picker.rayOf(last), normal, place);
        offset.copy(hit ? place.clone().sub(hit) : new Vector3());
      }
      last = latest;
      const ray = this.picker.rayOf(latest);
      const point = meet(ray, normal, place)?.add(offset);
      const isInReach = point && point.distanceTo(this.center) <= REACH * this.unitsPerMeter;
      // A rail is followed wherever the plane is met.
      if (!isInReach && !isOnRail.value) return null;
      if (isInReach) {
        place = point;
        this.sentGoal = { point, hand, when: performance.now() };
      }
      const origin = ray.origin.add(offset);
      const level = normal.z > 0.5;
      return { hand, do: "drag", origin: rounded(origin), direction: rounded(ray.direction, 9), level };
    };
    const move = () => {
      if (isHeld && latest !== last) this.moves.want(step);
    };
    void whenHeld.then((isIt) => {
      isHeld = isIt;
      move();
    });
    this.isCarrying.value = true;
    return {
      move: (at) => {
        latest = at;
        move();
      },
      end: () => {
        this.isCarrying.value = false;
        this.onChange();
      },
    };
  }

  private turn(from: PointerAt, { axis, point }: { axis: Axis; point: Vector3 }): Drag {
    const hand = currentHand.value;
    const angleAt = this.angles(from, axis, point);
    let sent = 0;
    this.turning.value = { axis, degrees: 0 };
    return {
      move: (at) => {
        const step = at.isShift ? BIG_STEP : 1;
        const wanted = Math.round(angleAt(at) / step) * step;
        this.turning.value = { axis, degrees: wanted };
        this.turns.want(() => {
          const angles: Point = [0, 0, 0];
          angles[axis] = wanted - sent;
          sent = wanted;
          return angles[axis] === 0 ? null : { hand, do: "rotate", angles };
        });
        this.onChange();
      },
      end: () => {
        this.turning.value = null;
        this.onChange();
      },
    };
  }

  /** How far the pointer has turned a ring since `from` [degrees], over any number of turns. */
  private angles(from: PointerAt, axis: Axis, point: Vector3): (at: PointerAt) => number {
    const direction = directionOf(axis);
    const center = this.rings.root.position.clone();
    const ray = this.picker.rayOf(from);
    if (Math.abs(ray.direction.dot(direction)) < 0.3) return this.anglesAlong(from, direction, center, point);
    const start = meet(ray, direction, center)?.sub(center) ?? new Vector3(1, 0, 0);
    let total = 0;
    return (at) => {
      const arm = meet(this.picker.rayOf(at), direction, center)?.sub(center);
      if (!arm) return total;
      const angle = Math.atan2(start.clone().cross(arm).dot(direction), start.dot(arm)) * DEGREES;
      total += wrapped(angle - total);
      return total;
    };
  }

  /** Of a ring seen from its edge: by how far the pointer goes along it. */
  private anglesAlong(from: PointerAt, direction: Vector3, center: Vector3, point: Vector3) {
    const tangent = direction.clone().cross(point.clone().sub(center));
    const start = this.picker.toPage(point);
    const end = this.picker.toPage(point.clone().addScaledVector(tangent, 0.1));
    const [dx, dy] = [(end.x - start.x) / 0.1, (end.y - start.y) / 0.1]; // [px/rad]
    return (at: PointerAt) =>
      (((at.x - from.x) * dx + (at.y - from.y) * dy) / (dx * dx + dy * dy)) * DEGREES;
  }
}

/** Whether a press of this is meant: a switch or a button, but not an object that is one as a whole. */
function isControl({ object, part, button }: Picked): boolean {
  if (part === null || part === object || !isCommandOffered("trigger")) return false;
  const controls = scene.value?.objects.find(({ id }) => id === object)?.controls ?? [];
  const isMeant = (id: string, parts: string[]) => parts.includes(part) || part === id || parts.includes(button ?? "");
  return controls.some(({ id, kind, parts }) => kind !== "indicatorLights" && isMeant(id, parts));
}

/** Whether no hand can take the object. */
export function isFixed(object: string): boolean {
  return scene.value?.objects.find(({ id }) => id === object)?.fixed ?? false;
}

/** A direction needs more digits: the eye may be far away. */
export function rounded(point: Vector3, digits = 5): Point {
  return point.toArray().map((value) => Number(value.toFixed(digits))) as Point;
}

/** Between -180 and 180 [degrees]. */
function wrapped(degrees: number): number {
  return degrees - 360 * Math.round(degrees / 360);
}
