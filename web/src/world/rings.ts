import {
  Group,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  type PerspectiveCamera,
  type Ray,
  Raycaster,
  type Sprite,
  TorusGeometry,
  Vector3,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { axisColors } from "../colors";
import { disc } from "./disc";
import { MARK } from "./outline";
import { apparentDistance } from "./view_camera";

export type Axis = 0 | 1 | 2;
const AXES: Axis[] = [0, 1, 2];
const NAMES = ["x", "y", "z"];
const DIRECTIONS = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)] as const;
const THICKNESS = 0.016;
const GRIP_THICKNESS = 0.07;
/** Their share of the circle, and into how many pieces it is cut: whole, dashed, dotted. */
const PATTERNS = [
  { pieces: 1, share: 1 },
  { pieces: 14, share: 0.68 },
  { pieces: 44, share: 0.42 },
] as const;
/** Diameter of a letter's disc. */
const LETTER_SIZE = 0.2;
/** Where on the rings the letters are, as pointOn() has it: far from one another [degrees]. */
const LETTER_PLACES = [50, 40, 230] as const;
const DIM_ORDER = 30;
const SOLID_ORDER = 31;
const LETTER_ORDER = 32;
/** Of a ring's radius to the distance from the eye, at least. */
const SMALLEST = 0.085;

/** Three rings about a held object, by which it is turned about the world's axes. */
export class Rings {
  readonly root = new Group();
  private readonly rings = AXES.map((axis) => new RingParts(axis));
  private readonly caster = new Raycaster();
  /** The one under the mouse. */
  hovered: Axis | null = null;

  constructor() {
    for (const ring of this.rings) this.root.add(ring.root);
    this.root.visible = false;
  }

  /** About an object of this radius; the one that is turned stands out. */
  show(center: Vector3, radius: number, turned: Axis | null, camera: PerspectiveCamera): void {
    const lit = turned ?? this.hovered;
    this.rings.forEach((ring, axis) => ring.setStrength(axis === lit ? 1 : lit === null ? 0.85 : 0.4));
    this.root.visible = true;
    this.root.position.copy(center);
    const distance = apparentDistance(camera, center);
    this.root.scale.setScalar(Math.max(1.22 * radius, SMALLEST * distance));
    this.root.updateMatrixWorld(true);
  }

  hide(): void {
    this.root.visible = false;
  }

  pick(ray: Ray): { axis: Axis; point: Vector3 } | null {
    if (!this.root.visible) return null;
    this.caster.ray.copy(ray);
    const grips = this.rings.map(({ grip }) => grip);
    const hit = this.caster.intersectObjects(grips, false)[0];
    const axis = AXES.find((k) => this.rings[k]?.grip === hit?.object);
    return hit === undefined || axis === undefined ? null : { axis, point: hit.point };
  }

  /** The letter under the pointer: it is drawn before everything, so it is gripped before everything. */
  pickLetter(ray: Ray): { axis: Axis; point: Vector3 } | null {
    if (!this.root.visible) return null;
    const letters = AXES.map((axis) => {
      const point = this.pointOn(axis, LETTER_PLACES[axis]);
      return { axis, point, distance: ray.distanceToPoint(point) };
    });
    const [nearest] = letters.sort((a, b) => a.distance - b.distance);
    return nearest && nearest.distance < (LETTER_SIZE / 2) * this.root.scale.x ? nearest : null;
  }

  /** On a ring, turned from the axis that follows it in the order x y z x [degrees]. */
  pointOn(axis: Axis, degrees: number): Vector3 {
    const from = DIRECTIONS[((axis + 1) % 3) as Axis].clone();
    from.applyAxisAngle(DIRECTIONS[axis], (degrees * Math.PI) / 180);
    return from.multiplyScalar(this.root.scale.x).add(this.root.position);
  }
}

export function directionOf(axis: Axis): Vector3 {
  return DIRECTIONS[axis].clone();
}

export function nameOf(axis: Axis): string {
  return NAMES[axis] ?? "";
}

/** A ring of radius 1: seen dimly before and behind everything, a wide one to grip it by, and its letter. */
class RingParts {
  readonly root = new Group();
  readonly grip: Mesh;
  private readonly solid: MeshBasicMaterial;
  private readonly dim: MeshBasicMaterial;

  constructor(axis: Axis) {
    const color = axisColors[axis];
    // Not before what is held, which is what a drag there carries.
    this.solid = new MeshBasicMaterial({
      color,
      transparent: true,
      toneMapped: false,
      stencilWrite: true,
      stencilRef: MARK,
      stencilFuncMask: MARK,
      stencilFunc: NotEqualStencilFunc,
    });
    this.dim = new MeshBasicMaterial({
      color,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    const shape = ringShape(PATTERNS[axis]);
    const [dim, solid] = [new Mesh(shape, this.dim), new Mesh(shape, this.solid)];
    dim.renderOrder = DIM_ORDER;
    solid.renderOrder = SOLID_ORDER;
    this.grip = new Mesh(new TorusGeometry(1, GRIP_THICKNESS, 6, 64), new MeshBasicMaterial());
    this.grip.visible = false;
    const turning = new Group();
    turning.add(dim, solid, this.grip);
    turning.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), DIRECTIONS[axis]);
    this.root.add(turning, letter(axis));
  }

  /** 1: it stands out. */
  setStrength(strength: number): void {
    this.solid.opacity = strength;
    this.dim.opacity = strength === 1 ? 1 : 0.4 * strength;
  }
}

function ringShape({ pieces, share }: { pieces: number; share: number }) {
  const arc = (2 * Math.PI) / pieces;
  const arcs = Array.from({ length: pieces }, (_, k) =>
    new TorusGeometry(1, THICKNESS, 8, Math.ceil(96 / pieces), arc * share).rotateZ(arc * k),
  );
  return mergeGeometries(arcs);
}

function letter(axis: Axis): Sprite {
  const sprite = disc(nameOf(axis), axisColors[axis], LETTER_ORDER);
  sprite.scale.setScalar(LETTER_SIZE);
  sprite.position.copy(DIRECTIONS[((axis + 1) % 3) as Axis]);
  sprite.position.applyAxisAngle(DIRECTIONS[axis], (LETTER_PLACES[axis] * Math.PI) / 180);
  return sprite;
}
