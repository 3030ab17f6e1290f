import { type PerspectiveCamera, type Sphere, Vector3 } from "three";
import type { SceneMessage } from "../protocol";
import { cameraKind, type Preset } from "./signals";

const FIELD_OF_VIEW = 45;
const ROBOTS_FIELD_OF_VIEW = 60; // [degrees]
const WIDEST = 85; // [degrees]
/** From above, through a lens so long that what is held high is drawn over the place that it is above [degrees]. */
const FIELD_OF_VIEW_FROM_ABOVE = 5;
const EASE_SECONDS = 0.11;
/** From the camera to what it draws, through the usual lens [m]. */
const NEAR = 0.02;
const LOWEST = -0.1;
const HIGHEST = Math.PI / 2 - 0.002; // [rad]
const FLY_SPEED = 1; // [m/s]
const LOOK_SPEED = 1; // [rad/s]
const ORBIT_PER_PIXEL = 0.006; // [rad]

/** Where the camera is: on a ball about what it looks at. */
class View {
  target = new Vector3();
  distance = 10;
  /** Of the camera seen from the target, from the x axis [rad]. */
  azimuth = 0;
  elevation = 0.5;
  /** From top to bottom [degrees]. */
  angle = FIELD_OF_VIEW;

  copy(other: View): void {
    this.target.copy(other.target);
    this.distance = other.distance;
    this.azimuth = other.azimuth;
    this.elevation = other.elevation;
    this.angle = other.angle;
  }

  get away(): Vector3 {
    const level = Math.cos(this.elevation);
    return new Vector3(
      level * Math.cos(this.azimuth),
      level * Math.sin(this.azimuth),
      Math.sin(this.elevation),
    );
  }

  get eye(): Vector3 {
    return this.away.multiplyScalar(this.distance).add(this.target);
  }

  /** Half of what is seen at the target's depth, from top to bottom [units]. */
  get halfHeight(): number {
    return this.distance * slopeOf(this.angle);
  }

  /** Sees as much at the target's depth as before, through another lens. */
  changeLens(angle: number, halfHeight = this.halfHeight): void {
    this.angle = angle;
    this.distance = halfHeight / slopeOf(angle);
  }

  lookFrom(eye: Vector3, target: Vector3): void {
    const away = eye.clone().sub(target);
    this.target.copy(target);
    this.distance = away.length();
    this.azimuth = Math.atan2(away.y, away.x);
    this.elevation = Math.asin(away.z / this.distance);
  }
}

const stillness = matchMedia("(prefers-reduced-motion: reduce)");

/** People's camera: goes around, along and nearer; moves to places gently. */
export class ViewCamera {
  private readonly wanted = new View();
  private readonly shown = new View();
  private unitsPerMeter = 10;
  private tableDepth = 12;
  private hasRobot = false;
  private center = new Vector3();
  private readonly flying = new Vector3();
  private readonly looking = { yaw: 0, pitch: 0 };

  constructor(
    private readonly camera: PerspectiveCamera,
    private readonly onChange: () => void,
  ) {}

  /** @param center of the table top */
  setTable(unitsPerMeter: number, tableDepth: number, hasRobot: boolean, center: Vector3): void {
    this.center = center;
    this.unitsPerMeter = unitsPerMeter;
    this.tableDepth = tableDepth;
    this.hasRobot = hasRobot;
  }

  /** Goes where the scene wants to be looked at from. */
  showScenes({ eye, target, angle }: NonNullable<SceneMessage["view"]>, isSudden = false): void {
    this.wanted.lookFrom(new Vector3(...eye), new Vector3(...target));
    this.wanted.elevation = clamp(this.wanted.elevation, LOWEST, HIGHEST);
    this.wanted.angle = angle;
    cameraKind.value = "free";
    this.goThere(isSudden);
  }

  /**
   * The robot stands where y is low, its head before the table's edge; the front is opposite.
   * @param balls  to be in the picture, as far as twice the distance, or an angle of WIDEST, allows
   */
  show(preset: Preset, isSudden = false, balls: readonly Sphere[] = []): void {
    const m = this.unitsPerMeter;
    const half = this.tableDepth / 2;
    const middle = new Vector3(0, -0.12 * m, 0.12 * m);
    const beforeHead = new Vector3(0, -half + 0.04 * m, 0.96 * m);
    const besideTable = new Vector3(0, -half - 0.6 * m, 1.4 * m);
    // From above, the table lies as from the front, or as the robot sees it if one looks from its side.
    const side = this.camera.position.y > this.center.y - half / 2 ? 1 : -1;
    const places: Record<Preset, [Vector3, Vector3]> = {
      front: [new Vector3(0.55 * m, half + 1.15 * m, 1.05 * m), new Vector3(0, -0.3 * m, 0.22 * m)],
      robot: [this.hasRobot ? beforeHead : besideTable, new Vector3(0, 0.09 * m, 0)],
      top: [new Vector3(0, side * 0.001 * m, 2.3 * m), new Vector3(0, 0, 0)],
      left: [new Vector3(-2.1 * m, -0.12 * m, 0.8 * m), middle],
      right: [new Vector3(2.1 * m, -0.12 * m, 0.8 * m), middle],
    };
    const [eye, target] = places[preset];
    this.wanted.lookFrom(eye.add(this.center), target.add(this.center));
    this.wanted.elevation = Math.min(this.wanted.elevation, HIGHEST);
    this.wanted.angle = preset === "robot" ? ROBOTS_FIELD_OF_VIEW : FIELD_OF_VIEW;
    if (preset === "top") this.wanted.changeLens(FIELD_OF_VIEW_FROM_ABOVE);
    this.include(balls, preset === "robot");
    cameraKind.value = preset;
    this.goThere(isSudden);
  }

  /** The robot's head is behind its eye: there, the angle grows instead of the distance. */
  private include(balls: readonly Sphere[], isOfRobot: boolean): void {
    const { wanted } = this;
    const nearest = wanted.distance;
    if (isOfRobot) {
      const isIn = (angle: number) => balls.every((ball) => distanceFor(ball, wanted, angle, this.camera.aspect) <= nearest);
      while (wanted.angle < WIDEST && !isIn(wanted.angle)) wanted.angle += 1;
      return;
    }
    const needed = balls.map((ball) => distanceFor(ball, wanted, wanted.angle, this.camera.aspect));
    wanted.distance = clamp(Math.max(nearest, ...needed), nearest, 2 * nearest);
  }

  /** Looks at a ball, as near as shows it well. */
  focus(center: Vector3, radius: number): void {
    this.wanted.target.copy(center);
    this.wanted.changeLens(FIELD_OF_VIEW);
    this.wanted.distance = Math.max(6 * radius, 0.4 * this.unitsPerMeter);
    this.moveFreely();
    this.goThere(false);
  }

  orbit(right: number, down: number): void {
    this.leaveLongLens();
    this.wanted.azimuth -= right * ORBIT_PER_PIXEL;
    this.wanted.elevation = clamp(this.wanted.elevation + down * ORBIT_PER_PIXEL, LOWEST, HIGHEST);
    this.moveFreely();
    this.goThere(true);
  }

  /** What is seen at the target's depth follows the pointer. */
  pan(right: number, down: number, height: number): void {
    const perPixel = (2 * this.wanted.halfHeight) / height;
    const sideways = new Vector3().setFromMatrixColumn(this.camera.matrix, 0);
    const upwards = new Vector3().setFromMatrixColumn(this.camera.matrix, 1);
    this.wanted.target.addScaledVector(sideways, -right * perPixel);
    this.wanted.target.addScaledVector(upwards, down * perPixel);
    this.moveFreely();
    this.goThere(true);
  }

  /** Towards a point, or what is looked at. */
  zoom(factor: number, point: Vector3 | null, isSudden = false): void {
    const before = this.wanted.distance;
    const usual = this.unitsPerMeter * Math.max(1, lengthOf(this.wanted.angle));
    this.wanted.distance = clamp(before * factor, 0.08 * usual, 12 * usual);
    if (point) this.wanted.target.sub(point).multiplyScalar(this.wanted.distance / before).add(point);
    this.moveFreely();
    this.goThere(isSudden);
  }

  /** Around a vertical axis through a point: what faced the camera still does. */
  turnAbout(point: Vector3, angle: number): void {
    this.wanted.target.sub(point).applyAxisAngle(new Vector3(0, 0, 1), angle).add(point);
    this.wanted.azimuth += angle;
    this.moveFreely();
    this.goThere(false);
  }

  /** Forward, to the left, up: each -1, 0 or 1, until the next call. */
  fly(axis: "x" | "y" | "z", way: number): void {
    this.flying[axis] = way;
    this.onChange();
  }

  look(axis: "yaw" | "pitch", way: number): void {
    this.looking[axis] = way;
    this.onChange();
  }

  /** From 0, level, to a right angle, straight down [rad]. */
  get elevation(): number {
    return this.shown.elevation;
  }

  /** The camera and its target: x, y, z each. */
  get points(): number[] {
    return [...this.shown.eye, ...this.shown.target];
  }

  /** Horizontal, to the right of the picture. */
  get right(): Vector3 {
    return new Vector3(-Math.sin(this.shown.azimuth), Math.cos(this.shown.azimuth), 0);
  }

  /** @returns whether it moves on. */
  update(seconds: number): boolean {
    this.drive(seconds);
    const share = stillness.matches ? 1 : 1 - Math.exp(-seconds / EASE_SECONDS);
    const { shown, wanted } = this;
    shown.target.lerp(wanted.target, share);
    // What is seen grows or shrinks evenly, also while the lens changes.
    const halfHeight = shown.halfHeight + (wanted.halfHeight - shown.halfHeight) * share;
    shown.changeLens(shown.angle + (wanted.angle - shown.angle) * share, halfHeight);
    shown.azimuth += turnBetween(shown.azimuth, wanted.azimuth) * share;
    shown.elevation += (wanted.elevation - shown.elevation) * share;
    const isThere =
      shown.target.distanceTo(wanted.target) < 1e-3 * wanted.halfHeight &&
      Math.abs(shown.distance - wanted.distance) < 1e-3 * wanted.distance &&
      Math.abs(turnBetween(shown.azimuth, wanted.azimuth)) < 1e-3 &&
      Math.abs(shown.elevation - wanted.elevation) < 1e-3;
    if (isThere) shown.copy(wanted);
    this.place();
    return !isThere || this.isDriven;
  }

  private get isDriven(): boolean {
    return this.flying.lengthSq() > 0 || this.looking.yaw !== 0 || this.looking.pitch !== 0;
  }

  /** A view that goes around, or through the scene, has the usual lens; one that goes along or nearer keeps its own. */
  private leaveLongLens(): void {
    if (this.wanted.angle === FIELD_OF_VIEW_FROM_ABOVE) this.wanted.changeLens(FIELD_OF_VIEW);
  }

  private drive(seconds: number): void {
    if (!this.isDriven) return;
    this.leaveLongLens();
    const { wanted } = this;
    const eye = wanted.eye;
    wanted.azimuth += this.looking.yaw * LOOK_SPEED * seconds;
    wanted.elevation = clamp(
      wanted.elevation - this.looking.pitch * LOOK_SPEED * seconds,
      LOWEST,
      HIGHEST,
    );
    wanted.target.copy(eye).addScaledVector(wanted.away, -wanted.distance);
    const step = FLY_SPEED * this.unitsPerMeter * seconds;
    const ahead = new Vector3(-Math.cos(wanted.azimuth), -Math.sin(wanted.azimuth), 0);
    const left = new Vector3(-ahead.y, ahead.x, 0);
    wanted.target.addScaledVector(ahead, this.flying.x * step);
    wanted.target.addScaledVector(left, this.flying.y * step);
    wanted.target.z += this.flying.z * step;
    this.moveFreely();
    this.shown.copy(wanted);
  }

  private moveFreely(): void {
    const farthest = 6 * this.unitsPerMeter;
    this.wanted.target.sub(this.center).clampLength(0, farthest).add(this.center);
    cameraKind.value = "free";
  }

  private goThere(isSudden: boolean): void {
    if (isSudden) this.shown.copy(this.wanted);
    this.place();
    this.onChange();
  }

  private place(): void {
    this.camera.position.copy(this.shown.eye);
    this.camera.lookAt(this.shown.target);
    // From far away, depths are told apart by as much.
    const near = NEAR * this.unitsPerMeter * Math.max(1, lengthOf(this.shown.angle));
    if (this.camera.fov !== this.shown.angle || this.camera.near !== near) {
      this.camera.fov = this.shown.angle;
      this.camera.near = near;
      this.camera.updateProjectionMatrix();
    }
    this.camera.updateMatrixWorld();
  }
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}

/** Of the upper edge of a picture against its middle. */
function slopeOf(angle: number): number {
  return Math.tan((angle * Math.PI) / 360);
}

/** Of a lens, in lengths of the usual one: from there, it shows as much. */
function lengthOf(angle: number): number {
  return slopeOf(FIELD_OF_VIEW) / slopeOf(angle);
}

/** Distance at which the usual lens would show a point as large as a camera does: for what has one size in the picture. */
export function apparentDistance(camera: PerspectiveCamera, point: Vector3): number {
  return camera.position.distanceTo(point) / lengthOf(camera.fov);
}

/** How far from its target a view must be, in its direction, for a ball to be in its picture. */
function distanceFor(ball: Sphere, view: View, angle: number, aspect: number): number {
  const from = ball.center.clone().sub(view.target);
  const sideways = new Vector3(-Math.sin(view.azimuth), Math.cos(view.azimuth), 0);
  const upwards = view.away.cross(sideways);
  const half = (angle * Math.PI) / 360;
  const halfAcross = Math.atan(Math.tan(half) * aspect);
  // A ball touches a side of the picture's pyramid where its center is radius / cos before it.
  const along = (direction: Vector3, slope: number) => (Math.abs(from.dot(direction)) + ball.radius / Math.cos(slope)) / Math.tan(slope);
  return from.dot(view.away) + Math.max(along(sideways, halfAcross), along(upwards, half));
}

/** The short way round [rad]. */
function turnBetween(from: number, to: number): number {
  const turn = (to - from) % (2 * Math.PI);
  return turn > Math.PI ? turn - 2 * Math.PI : turn < -Math.PI ? turn + 2 * Math.PI : turn;
}
