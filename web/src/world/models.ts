import {
  Box3,
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshStandardMaterial,
  type Object3D,
  Quaternion,
  Sphere,
  SphereGeometry,
  Vector3,
} from "three";
import { notify } from "../studio";
import type { Pose, Poses, SceneMessage, Visual } from "../protocol";
import { texts } from "../texts";
import { fetchMesh } from "./meshes";

/** In this time most of the way to where things are now is shown: less than a picture lasts. */
const FOLLOW_SECONDS = 0.007;
const NEAR = 2e-4; // [units]
const NEAR_ANGLE = 2e-4; // [rad]
/** Prisms have edges, cylinders none. */
const MOST_SIDES_WITH_EDGES = 12;

interface Frame {
  group: Group;
  position: Vector3;
  rotation: Quaternion;
}

/** A visual in the picture. */
export interface Piece {
  mesh: Mesh<BufferGeometry>;
  visual: Visual;
  /** Id of the object it is of; "" for table and robot. */
  object: string;
}

/** What is to be seen: a group for each frame, which follows the poses, with its pieces. */
export class Models {
  readonly root = new Group();
  pieces: Piece[] = [];
  private frames: Frame[] = [];
  private moving = new Set<Frame>();
  /** Frames that moved in the last step. */
  readonly moved = new Set<Object3D>();
  private frameOfObject = new Map<string, number>();
  private variants: number[] = [];
  private gone = new Set<string>();
  private isRobotShown = true;
  private isLow = false;
  private scene: SceneMessage | null = null;
  private readonly materials = new Map<string, Material>();
  private readonly shapes = new Map<string, BufferGeometry>();

  /** @param prepare called with each new material */
  constructor(
    private readonly prepare: (material: Material) => void,
    private readonly onChange: () => void,
  ) {
    this.root.visible = false;
  }

  /** Replaces everything. Nothing is shown until the poses are known. */
  load(scene: SceneMessage): void {
    this.clear();
    this.scene = scene;
    this.root.visible = false;
    this.frames = Array.from({ length: scene.numFrames }, () => newFrame());
    for (const { group } of this.frames) this.root.add(group);
    for (const { id, frame } of scene.objects) this.frameOfObject.set(id, frame);
    const objects = new Map(scene.objects.map(({ id, frame }) => [frame, id]));
    const meshes = new Map<number, Visual[]>();
    for (const visual of scene.visuals) {
      const shape = this.shapeOf(visual);
      if (shape) this.add(visual, shape, objects.get(visual.frame) ?? "");
      else if (visual.mesh !== undefined) append(meshes, visual.mesh, visual);
    }
    for (const [mesh, visuals] of meshes) void this.fetch(scene, mesh, visuals, objects);
  }

  setVariants(variants: number[]): void {
    this.variants = variants;
    this.updateVisibility();
  }

  setGone(gone: string[]): void {
    if (gone.length === this.gone.size && gone.every((id) => this.gone.has(id))) return;
    this.gone = new Set(gone);
    this.updateVisibility();
  }

  setRobotShown(isShown: boolean): void {
    if (isShown === this.isRobotShown) return;
    this.isRobotShown = isShown;
    this.updateVisibility();
  }

  /** Without gloss, or with. */
  setDetail(isLow: boolean): void {
    this.isLow = isLow;
    for (const { mesh, visual } of this.pieces) mesh.material = this.materialOf(visual);
    this.onChange();
  }

  /** Where frames are now; they go there within the next picture or two. */
  take(poses: Poses): void {
    if (poses.scene !== this.scene?.scene) return;
    const isFirst = !this.root.visible && poses.isKey;
    for (const { frame: number, pose } of poses.frames) {
      const frame = this.frames[number];
      if (frame) this.send(frame, pose, isFirst);
    }
    if (isFirst) this.root.visible = true;
    if (isFirst || this.moving.size > 0) this.onChange();
  }

  /** A step towards where things are. */
  follow(seconds: number): void {
    const share = 1 - Math.exp(-seconds / FOLLOW_SECONDS);
    this.moved.clear();
    for (const frame of this.moving) {
      const { group, position, rotation } = frame;
      this.moved.add(group);
      group.position.lerp(position, share);
      group.quaternion.slerp(rotation, share);
      if (!isThere(frame)) continue;
      group.position.copy(position);
      group.quaternion.copy(rotation);
      this.moving.delete(frame);
    }
  }

  get isMoving(): boolean {
    return this.moving.size > 0;
  }

  /** Frame 0, table and all, does not move, nor does the robot count as an object. */
  groupOf(object: string): Group | null {
    const frame = this.frameOfObject.get(object);
    return (frame !== undefined && this.frames[frame]?.group) || null;
  }

  frameNumberOf(object: string): number | null {
    return this.frameOfObject.get(object) ?? null;
  }

  /** Of an object that are to be seen. */
  piecesOf(object: string): Piece[] {
    return this.pieces.filter((piece) => piece.object === object && piece.mesh.visible);
  }

  isOfRobot({ visual }: Piece): boolean {
    return visual.frame >= (this.scene?.robotFrame ?? Infinity);
  }

  /** A ball about pieces, in the world; null about none. */
  static ballAbout(pieces: Piece[]): Sphere | null {
    const box = new Box3();
    for (const { mesh } of pieces) box.expandByObject(mesh);
    return box.isEmpty() ? null : box.getBoundingSphere(new Sphere());
  }

  private clear(): void {
    this.root.clear();
    this.pieces.forEach(({ mesh }) => mesh.geometry.dispose());
    this.shapes.clear();
    this.materials.forEach((material) => material.dispose());
    this.materials.clear();
    this.pieces = [];
    this.moving.clear();
    this.frameOfObject.clear();
    this.gone.clear();
  }

  private send(frame: Frame, pose: Pose, isSudden: boolean): void {
    const [x, y, z, qx, qy, qz, qw] = pose;
    frame.position.set(x, y, z);
    frame.rotation.set(qx, qy, qz, qw).normalize();
    const { group, position, rotation } = frame;
    if (group.quaternion.dot(rotation) < 0) negate(rotation);
    if (isSudden) {
      group.position.copy(position);
      group.quaternion.copy(rotation);
    }
    if (isSudden || !isThere(frame)) this.moving.add(frame);
  }

  private async fetch(
    scene: SceneMessage,
    mesh: number,
    visuals: Visual[],
    objects: Map<number, string>,
  ): Promise<void> {
    try {
      const shape = await fetchMesh(scene.scene, mesh);
      if (scene !== this.scene) return;
      for (const visual of visuals) this.add(visual, shape, objects.get(visual.frame) ?? "");
      this.onChange();
    } catch {
      if (scene === this.scene) notify(texts.views.shapeMissing, true);
    }
  }

  private add(visual: Visual, shape: BufferGeometry, object: string): void {
    const mesh = new Mesh(shape, this.materialOf(visual));
    const [x, y, z, qx, qy, qz, qw] = visual.pose;
    mesh.position.set(x, y, z);
    mesh.quaternion.set(qx, qy, qz, qw);
    stretch(mesh, visual);
    mesh.castShadow = !visual.glows;
    mesh.receiveShadow = !visual.glows;
    mesh.visible = this.isVisible(visual, object);
    this.frames[visual.frame]?.group.add(mesh);
    this.pieces.push({ mesh, visual, object });
  }

  /** Blocks, cylinders and spheres of size 1 are shared; null for meshes. */
  private shapeOf({ block, cylinder, sphere }: Visual): BufferGeometry | null {
    const shared = (name: string, make: () => BufferGeometry) => {
      const shape = this.shapes.get(name) ?? make();
      this.shapes.set(name, shape);
      return shape;
    };
    if (block) return shared("block", () => new BoxGeometry(1, 1, 1));
    if (sphere !== undefined) return shared("sphere", () => new SphereGeometry(1, 40, 24));
    if (!cylinder) return null;
    const sides = Math.min(Math.max(3, cylinder[2]), 64);
    return shared(`cylinder ${sides}`, () => new CylinderGeometry(1, 1, 1, sides));
  }

  private materialOf({ color, glows, cylinder }: Visual): Material {
    const flatShading = cylinder !== undefined && cylinder[2] <= MOST_SIDES_WITH_EDGES;
    const name = `${color} ${glows} ${flatShading} ${this.isLow}`;
    const make = () => {
      if (glows) return new MeshBasicMaterial({ color, toneMapped: false });
      if (this.isLow) return new MeshLambertMaterial({ color, flatShading });
      return new MeshStandardMaterial({ color, flatShading, roughness: 0.6 });
    };
    const known = this.materials.get(name);
    if (known) return known;
    const material = make();
    this.prepare(material);
    this.materials.set(name, material);
    return material;
  }

  private isVisible({ choice, look, frame }: Visual, object: string): boolean {
    if (choice >= 0 && this.variants[choice] !== look) return false;
    if (!this.isRobotShown && frame >= (this.scene?.robotFrame ?? Infinity)) return false;
    return !this.gone.has(object);
  }

  private updateVisibility(): void {
    for (const { mesh, visual, object } of this.pieces) mesh.visible = this.isVisible(visual, object);
    this.onChange();
  }
}

function newFrame(): Frame {
  return { group: new Group(), position: new Vector3(), rotation: new Quaternion() };
}

/** The same rotation as the opposite quaternion. */
function negate(rotation: Quaternion): void {
  rotation.set(-rotation.x, -rotation.y, -rotation.z, -rotation.w);
}

/** As far as one can see: what is held trembles a little. */
function isThere({ group, position, rotation }: Frame): boolean {
  const { x, y, z, w } = group.quaternion;
  const halfAngle = Math.hypot(x - rotation.x, y - rotation.y, z - rotation.z, w - rotation.w);
  return group.position.distanceTo(position) < NEAR && halfAngle < NEAR_ANGLE / 2;
}

function append(lists: Map<number, Visual[]>, key: number, visual: Visual): void {
  lists.set(key, [...(lists.get(key) ?? []), visual]);
}

function stretch(mesh: Object3D, { block, cylinder, sphere, scale }: Visual): void {
  if (block) mesh.scale.set(...block);
  else if (cylinder) mesh.scale.set(cylinder[0], cylinder[1], cylinder[0]);
  else mesh.scale.setScalar(sphere ?? scale ?? 1);
}
