import { Color, DoubleSide, Matrix4, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector3 } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { guideColors } from "../colors";
import type { Piece } from "./models";

const HALF_SIZE = 0.7; // [m]
const UP = new Vector3(0, 0, 1);
/** Enough for the shipped scenes' finest meshes; beyond it a line is not worth the wait. */
const MOST_TRIANGLES = 60000;

/**
 * Drag plane: the plane in which a hand drags, drawn as a surface around the held object with the line
 * in which it cuts the table and the objects on it.
 */
export class DragPlane {
  private readonly surface = new Mesh(new PlaneGeometry(2, 2), surfaceMaterial());
  private readonly cut = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ color: guideColors.plane, linewidth: 2.5, transparent: true, opacity: 0.95 }),
  );
  readonly parts = [this.surface, this.cut];
  private readonly normal = new Vector3();
  private readonly point = new Vector3();
  private unitsPerMeter = 10;

  constructor() {
    this.surface.renderOrder = 5;
    this.surface.frustumCulled = false;
    this.cut.renderOrder = 6;
    this.cut.frustumCulled = false;
    this.hide();
  }

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
  }

  hide(): void {
    for (const part of this.parts) part.visible = false;
  }

  /** @param isCutNew whether something moved that may be cut */
  show(normal: Vector3, point: Vector3, pieces: Piece[], isCutNew: boolean): void {
    const isOld =
      this.cut.visible &&
      this.normal.distanceTo(normal) < 1e-4 &&
      Math.abs(point.clone().sub(this.point).dot(normal)) < 1e-4 * this.unitsPerMeter;
    this.normal.copy(normal);
    this.point.copy(point);
    this.place();
    if (!isOld || isCutNew) this.drawCut(pieces);
    for (const part of this.parts) part.visible = true;
  }

  /** What is drawn with lines must know the picture's size [px]. */
  setSize(width: number, height: number): void {
    this.cut.material.resolution.set(width, height);
  }

  private place(): void {
    const half = HALF_SIZE * this.unitsPerMeter;
    const isLevel = this.normal.z > 0.5;
    const right = isLevel ? new Vector3(1, 0, 0) : new Vector3().crossVectors(UP, this.normal);
    const up = new Vector3().crossVectors(this.normal, right);
    this.surface.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(right, up, this.normal));
    this.surface.position.copy(this.point);
    this.surface.scale.setScalar(half);
    const { size, corner } = this.surface.material.uniforms;
    size!.value = half;
    corner!.value.set(this.point.dot(right), this.point.dot(up));
  }

  private drawCut(pieces: Piece[]): void {
    const places: number[] = [];
    let triangles = 0;
    for (const { mesh } of pieces) {
      if (!mesh.visible || !this.reaches(mesh)) continue;
      triangles += (mesh.geometry.index?.count ?? 0) / 3;
      if (triangles > MOST_TRIANGLES) break;
      cutMesh(mesh, this.normal, this.point, places);
    }
    if (places.length === 0) places.push(0, 0, 0, 0, 0, 0);
    this.cut.geometry.dispose();
    this.cut.geometry = new LineSegmentsGeometry().setPositions(places);
  }

  private reaches(mesh: Mesh): boolean {
    if (mesh.geometry.boundingSphere === null) mesh.geometry.computeBoundingSphere();
    const ball = mesh.geometry.boundingSphere!.clone().applyMatrix4(mesh.matrixWorld);
    return Math.abs(ball.center.sub(this.point).dot(this.normal)) <= ball.radius;
  }
}

/** Appends the ends of the lines in which a plane cuts a mesh's faces. */
function cutMesh(mesh: Mesh, normal: Vector3, point: Vector3, places: number[]): void {
  const positions = mesh.geometry.getAttribute("position");
  const corners: Vector3[] = [];
  const heights: number[] = [];
  for (let k = 0; k < positions.count; ++k) {
    const corner = new Vector3().fromBufferAttribute(positions, k).applyMatrix4(mesh.matrixWorld);
    corners.push(corner);
    heights.push(normal.dot(corner) - normal.dot(point));
  }
  const index = mesh.geometry.index;
  if (index === null) return;
  for (let k = 0; k < index.count; k += 3) {
    const ends: Vector3[] = [];
    for (let side = 0; side < 3; ++side) {
      const a = index.getX(k + side);
      const b = index.getX(k + ((side + 1) % 3));
      const [from, to] = [heights[a]!, heights[b]!];
      if (from < 0 === to < 0) continue;
      ends.push(corners[a]!.clone().lerp(corners[b]!, from / (from - to)));
    }
    if (ends.length === 2) places.push(...ends[0]!.toArray(), ...ends[1]!.toArray());
  }
}

/** Fades away from its middle, with a line at each unit. */
function surfaceMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    uniforms: {
      color: { value: new Color(guideColors.plane).convertLinearToSRGB() },
      size: { value: 1 },
      corner: { value: new Vector2() },
    },
    vertexShader: `
      varying vec2 place;
      void main() {
        place = position.xy;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform vec3 color;
      uniform float size;
      uniform vec2 corner;
      varying vec2 place;
      void main() {
        vec2 units = place * size + corner;
        vec2 near = abs(fract(units - 0.5) - 0.5) / fwidth(units);
        float line = 1.0 - min(min(near.x, near.y), 1.0);
        float fade = smoothstep(1.0, 0.25, length(place));
        gl_FragColor = vec4(color, fade * (0.16 + 0.22 * line));
      }`,
  });
}
