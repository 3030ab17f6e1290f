import {
  type BufferGeometry,
  DepthTexture,
  DoubleSide,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  Scene,
  type Vector3,
  WebGLRenderTarget,
} from "three";
import type { Piece } from "./models";
import type { Stage } from "./stage";

const SIZE = 512; // [px]
const DARKNESS = 0.42;
/** What is no deeper below than this touches [m]. */
const NEAR = 0.005;
const DEPTH = 1.5; // below the held object, to which shadows fall [m]

/**
 * The shadow of a held object, as if the sun stood overhead: on all that is below it. What is drawn
 * with a dressed material asks a picture of the object, taken from below, whether it is under it.
 */
export class Overhead {
  private readonly picture = new WebGLRenderTarget(SIZE, SIZE, { depthTexture: new DepthTexture(SIZE, SIZE) });
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly plain = new MeshBasicMaterial({ side: DoubleSide, colorWrite: false });
  private readonly uniforms = {
    overheadDepths: { value: this.picture.depthTexture },
    overheadMatrix: { value: new Matrix4() },
    overheadNear: { value: 0 },
    overheadDarkness: { value: 0 },
  };
  private unitsPerMeter = 10;

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
  }

  /** Shadows may fall on what has this material. */
  dress(material: Material): void {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", `#include <common>\n${IN_VERTEX}`)
        .replace(
          "#include <project_vertex>",
          "#include <project_vertex>\noverheadPlace = (overheadMatrix * modelMatrix * vec4(transformed, 1.0)).xyz;",
        );
      shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", `#include <common>\n${IN_FRAGMENT}`)
        .replace(
          "#include <tonemapping_fragment>",
          "gl_FragColor.rgb *= 1.0 - overheadShade();\n#include <tonemapping_fragment>",
        );
    };
  }

  hide(): void {
    this.uniforms.overheadDarkness.value = 0;
  }

  /** Of these pieces, which are in a ball. */
  show(pieces: Piece[], center: Vector3, radius: number): void {
    this.place(center, radius);
    this.scene.clear();
    for (const { mesh } of pieces) {
      if (mesh.visible) this.scene.add(this.copyOf(mesh));
    }
    this.uniforms.overheadDarkness.value = DARKNESS;
  }

  /** To be called before the world is drawn. */
  draw(stage: Stage): void {
    if (this.uniforms.overheadDarkness.value > 0) stage.drawInto(this.picture, this.scene, this.camera);
  }

  /** Below the object, looking up. */
  private place(center: Vector3, radius: number): void {
    const depth = DEPTH * this.unitsPerMeter;
    const half = 1.1 * radius;
    const { camera } = this;
    Object.assign(camera, { left: -half, right: half, top: half, bottom: -half });
    Object.assign(camera, { near: 0, far: depth + 2 * half });
    camera.updateProjectionMatrix();
    camera.position.set(center.x, center.y, center.z - half - depth);
    camera.up.set(0, 1, 0);
    camera.lookAt(center);
    camera.updateMatrixWorld();
    this.uniforms.overheadNear.value = (NEAR * this.unitsPerMeter) / camera.far;
    this.uniforms.overheadMatrix.value
      .makeTranslation(0.5, 0.5, 0.5)
      .multiply(new Matrix4().makeScale(0.5, 0.5, 0.5))
      .multiply(camera.projectionMatrix)
      .multiply(camera.matrixWorldInverse);
  }

  private copyOf(mesh: Mesh): Mesh<BufferGeometry, MeshBasicMaterial> {
    const copy = new Mesh(mesh.geometry, this.plain);
    copy.matrixAutoUpdate = false;
    copy.matrix.copy(mesh.matrixWorld);
    return copy;
  }
}

const IN_VERTEX = `
  uniform mat4 overheadMatrix;
  varying vec3 overheadPlace;`;

/** Four looks make a softer edge. Where the picture is empty its depth is 1. */
const IN_FRAGMENT = `
  uniform highp sampler2D overheadDepths;
  uniform float overheadNear;
  uniform float overheadDarkness;
  varying vec3 overheadPlace;

  float overheadAt(vec2 aside) {
    float depth = texture2D(overheadDepths, overheadPlace.xy + aside / ${SIZE}.0).r;
    return depth < 0.9999 && overheadPlace.z < depth - overheadNear ? 0.25 : 0.0;
  }

  float overheadShade() {
    vec2 away = abs(overheadPlace.xy - 0.5);
    if (overheadDarkness == 0.0 || max(away.x, away.y) > 0.49) return 0.0;
    float covered = overheadAt(vec2(-0.8, -0.4)) + overheadAt(vec2(0.4, -0.8)) +
                    overheadAt(vec2(0.8, 0.4)) + overheadAt(vec2(-0.4, 0.8));
    return overheadDarkness * covered;
  }`;
