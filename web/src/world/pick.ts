import { type Intersection, Plane, Ray, Raycaster, Vector2, Vector3 } from "three";
import type { Models, Piece } from "./models";
import type { Stage } from "./stage";

/** Where a pointer is on the page [px], and whether Shift is down. */
export interface PointerAt {
  x: number;
  y: number;
  isShift: boolean;
}

/** What is under a pointer. */
export interface Picked {
  /** Id of the object; "" for table and robot. */
  object: string;
  part: string | null;
  /** Of a switch, as commands name it. */
  button: string | null;
  point: Vector3;
  piece: Piece;
}

/** By eighths of a turn, counterclockwise. */
const ARROWS = "→↗↑↖←↙↓↘";
/** So short that perspective does not bend it [units]. */
const SHORT = 0.1;

/** Looks along the pointer. */
export class Picker {
  private readonly caster = new Raycaster();

  constructor(
    private readonly stage: Stage,
    private readonly models: Models,
  ) {}

  /** From the eye through the pointer, in the world. */
  rayOf({ x, y }: { x: number; y: number }): Ray {
    const box = this.stage.canvas.getBoundingClientRect();
    const place = new Vector2(
      (2 * (x - box.left)) / box.width - 1,
      1 - (2 * (y - box.top)) / box.height,
    );
    this.caster.setFromCamera(place, this.stage.camera);
    return this.caster.ray.clone();
  }

  /** The nearest thing that is to be seen. */
  pick(at: { x: number; y: number }): Picked | null {
    this.rayOf(at);
    return this.nearest(this.models.pieces);
  }

  /** The first thing straight below a point, but not that of an object, if one is given, nor the robot. */
  below(point: Vector3, except: string | null): Picked | null {
    this.caster.set(point, new Vector3(0, 0, -1));
    return this.nearest(
      this.models.pieces.filter((piece) => piece.object !== except && !this.models.isOfRobot(piece)),
    );
  }

  /** How far it is from a point in a direction of length 1 to an object, through all others; infinite if it is not there. */
  distanceTo(object: string, point: Vector3, direction: Vector3): number {
    this.caster.set(point, direction);
    return this.nearest(this.models.piecesOf(object))?.point.distanceTo(point) ?? Infinity;
  }

  /** Where on the page a point of the world is [px]. */
  toPage(point: Vector3): { x: number; y: number } {
    const box = this.stage.canvas.getBoundingClientRect();
    const place = point.clone().project(this.stage.camera);
    return {
      x: box.left + ((place.x + 1) / 2) * box.width,
      y: box.top + ((1 - place.y) / 2) * box.height,
    };
  }

  /** An arrow that points in the picture where a direction leads from a point. */
  arrow(from: Vector3, direction: Vector3): string {
    const start = this.toPage(from);
    const end = this.toPage(from.clone().addScaledVector(direction, SHORT / (direction.length() || 1)));
    const eighth = Math.round((4 * Math.atan2(start.y - end.y, end.x - start.x)) / Math.PI);
    return ARROWS[(eighth + 8) % 8]!;
  }

  private nearest(pieces: Piece[]): Picked | null {
    let best: { hit: Intersection; piece: Piece } | null = null;
    for (const piece of pieces) {
      if (!piece.mesh.visible) continue;
      const hit = this.caster.intersectObject(piece.mesh, false)[0];
      if (hit && (best === null || hit.distance < best.hit.distance)) best = { hit, piece };
    }
    if (best === null) return null;
    const { hit, piece } = best;
    return { object: piece.object, part: piece.visual.part ?? null, button: piece.visual.button ?? null, point: hit.point, piece };
  }
}

/** Where a ray meets a plane through a point; null where it does not. */
export function meet(ray: Ray, normal: Vector3, point: Vector3): Vector3 | null {
  return ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(normal, point), new Vector3());
}
