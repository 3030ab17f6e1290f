import { Box3, type Quaternion, Vector3 } from "three";
import type { Point, SceneMessage } from "../protocol";
import type { Cuboid } from "./alignment";
import type { Models, Piece } from "./models";

/** Where an object is, or is taken to be [units]. */
export interface Place {
  position: Vector3;
  quaternion: Quaternion;
}

/**
 * The cuboids around what is drawn of the objects, and the table top [m].
 * @param elsewhere  objects that are taken to be somewhere else
 */
export function cuboidsOf(
  models: Models,
  { table, metersPerUnit }: SceneMessage,
  elsewhere: ReadonlyMap<string, Place>,
): Map<string, Cuboid> {
  const pieces = new Map<string, Piece[]>();
  for (const piece of models.pieces) {
    if (piece.object === "" || !piece.mesh.visible) continue;
    const ofObject = pieces.get(piece.object);
    if (ofObject) ofObject.push(piece);
    else pieces.set(piece.object, [piece]);
  }
  const [x, y] = table.size;
  const half: Point = [(x * metersPerUnit) / 2, (y * metersPerUnit) / 2, 0];
  const top: Cuboid = { object: "", center: [0, 0, 0], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], half };
  const cuboids = [...pieces].map(([object, its]) => {
    const place = elsewhere.get(object) ?? its[0]!.mesh.parent!;
    return [object, cuboidAround(object, its, place, metersPerUnit)] as const;
  });
  return new Map([...cuboids, ["", top] as const]);
}

function cuboidAround(object: string, pieces: Piece[], { position, quaternion }: Place, metersPerUnit: number): Cuboid {
  const box = new Box3();
  for (const { mesh } of pieces) {
    if (mesh.geometry.boundingBox === null) mesh.geometry.computeBoundingBox();
    mesh.updateMatrix();
    box.union(mesh.geometry.boundingBox!.clone().applyMatrix4(mesh.matrix));
  }
  const axis = (...along: Point) => new Vector3(...along).applyQuaternion(quaternion).toArray() as Point;
  const center = box.getCenter(new Vector3()).applyQuaternion(quaternion).add(position);
  return {
    object,
    center: center.multiplyScalar(metersPerUnit).toArray() as Point,
    axes: [axis(1, 0, 0), axis(0, 1, 0), axis(0, 0, 1)],
    half: box.getSize(new Vector3()).multiplyScalar(metersPerUnit / 2).toArray() as Point,
  };
}
