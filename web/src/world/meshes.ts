import { BufferAttribute, BufferGeometry } from "three";
import { programFolder } from "../studio";

const HEADER_BYTES = 8;
const CORNER_BYTES = 24;
const TRIANGLE_BYTES = 12;

/** Fetches a mesh of a scene; docs/studio-protocol.md specifies its bytes. */
export async function fetchMesh(scene: number, mesh: number): Promise<BufferGeometry> {
  const answer = await fetch(`${programFolder.value}meshes/${scene}/${mesh}`);
  if (!answer.ok) throw new Error(`mesh ${mesh}: ${answer.status}`);
  return decodeMesh(await answer.arrayBuffer());
}

function decodeMesh(bytes: ArrayBuffer): BufferGeometry {
  const [corners = 0, triangles = 0] = new Uint32Array(bytes, 0, 2);
  if (bytes.byteLength !== HEADER_BYTES + corners * CORNER_BYTES + triangles * TRIANGLE_BYTES) {
    throw new Error("mesh file: its size differs from its header");
  }
  const floats = (at: number) => new Float32Array(bytes, HEADER_BYTES + at * 12 * corners, 3 * corners);
  const numbers = new Uint32Array(bytes, HEADER_BYTES + corners * CORNER_BYTES, 3 * triangles);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(floats(0), 3));
  geometry.setAttribute("normal", new BufferAttribute(floats(1), 3));
  geometry.setIndex(new BufferAttribute(numbers, 1));
  return geometry;
}
