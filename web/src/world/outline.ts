import {
  AlwaysStencilFunc,
  BackSide,
  BufferAttribute,
  type BufferGeometry,
  Color,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  ShaderMaterial,
  Vector2,
} from "three";

/** Bit of the stencil: outlined things are marked, so that only what sticks out of them is drawn. */
export const MARK = 1;
const MARK_ORDER = 20;

const vertexShader = `
  attribute vec3 spread;
  uniform vec2 width;
  void main() {
    vec4 corner = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    vec2 outwards = (normalMatrix * spread).xy;
    corner.xy += normalize(outwards + vec2(1e-6)) * width * corner.w;
    gl_Position = corner;
  }`;
const fragmentShader = `
  uniform vec3 color;
  void main() { gl_FragColor = vec4(color, 1.0); }`;

/** A line of even width around an object, seen through everything that stands before it. */
export class Outline {
  private readonly marking = new MeshBasicMaterial({
    colorWrite: false,
    depthWrite: false,
    depthTest: false,
    transparent: true,
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });
  private readonly rim = new ShaderMaterial({
    uniforms: { color: { value: new Color() }, width: { value: new Vector2() } },
    vertexShader,
    fragmentShader,
    side: BackSide,
    depthWrite: false,
    depthTest: false,
    transparent: true,
    stencilWrite: true,
    stencilFunc: NotEqualStencilFunc,
  });
  private drawn: Mesh[] = [];
  private around: Mesh[] = [];

  /** @param mark bit of the stencil; an outline is also drawn over what is marked with another bit */
  constructor(
    private readonly pixels: number,
    color: string,
    private readonly mark = MARK,
  ) {
    for (const material of [this.marking, this.rim]) {
      material.stencilRef = material.stencilFuncMask = material.stencilWriteMask = mark;
    }
    this.rim.uniforms["color"]!.value.set(color).convertLinearToSRGB();
  }

  /** Around these, and nothing else. */
  show(meshes: Mesh[]): void {
    if (meshes.length === this.around.length && meshes.every((mesh, k) => mesh === this.around[k])) return;
    for (const mesh of this.drawn) mesh.removeFromParent();
    this.around = meshes;
    this.drawn = meshes.flatMap((mesh) => {
      const mark = new Mesh(mesh.geometry, this.marking);
      const rim = new Mesh(withSpread(mesh.geometry), this.rim);
      mark.renderOrder = MARK_ORDER + 2 * (this.mark - MARK);
      rim.renderOrder = mark.renderOrder + 1;
      rim.frustumCulled = false;
      mesh.add(mark, rim);
      return [mark, rim];
    });
  }

  setSize(width: number, height: number): void {
    this.rim.uniforms["width"]!.value.set((2 * this.pixels) / width, (2 * this.pixels) / height);
  }
}

/** Where faces meet, their normals' mean: the rim has no gaps at corners. */
function withSpread(geometry: BufferGeometry): BufferGeometry {
  if (geometry.hasAttribute("spread")) return geometry;
  const positions = geometry.getAttribute("position");
  const normals = geometry.getAttribute("normal");
  const nameOf = (k: number) =>
    `${positions.getX(k).toFixed(5)} ${positions.getY(k).toFixed(5)} ${positions.getZ(k).toFixed(5)}`;
  const sums = new Map<string, [number, number, number]>();
  for (let k = 0; k < positions.count; ++k) {
    const sum = sums.get(nameOf(k)) ?? [0, 0, 0];
    sum[0] += normals.getX(k);
    sum[1] += normals.getY(k);
    sum[2] += normals.getZ(k);
    sums.set(nameOf(k), sum);
  }
  const spread = new Float32Array(3 * positions.count);
  for (let k = 0; k < positions.count; ++k) spread.set(sums.get(nameOf(k)) ?? [0, 0, 1], 3 * k);
  geometry.setAttribute("spread", new BufferAttribute(spread, 3));
  return geometry;
}
