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
/** Surfaces no deeper than this below the object touch it [m]. */
const NEAR = 0.005;
const DEPTH = 1.5; // below the held object, to which shadows fall [m]

/**
 * Drop shadow: the shadow of a held object on everything below it, as if lit from straight above.
 * Materials passed to addTo() compare depths with a picture of the object, taken from below.
 */
export class DropShadow {
  private readonly picture = new WebGLRenderTarget(SIZE, SIZE, { depthTexture: new DepthTexture(SIZE, SIZE) });
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly plain = new MeshBasicMaterial({ side: DoubleSide, colorWrite: false });
  private readonly uniforms = {
    dropShadowDepths: { value: this.picture.depthTexture },
    dropShadowMatrix: { value: new Matrix4() },
    dropShadowNear: { value: 0 },
    dropShadowDarkness: { value: 0 },
  };
  private unitsPerMeter = 10;

  setScale(unitsPerMeter: number): void {
    this.unitsPerMeter = unitsPerMeter;
  }

  /** Adds the shadow to the shader of a material on which it may fall. */
  addTo(material: Material): void {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", `#include <common>\n${IN_VERTEX}`)
        .replace(
          "#include <project_vertex>",
          "#include <project_vertex>\ndropShadowPlace = (dropShadowMatrix * modelMatrix * vec4(transformed, 1.0)).xyz;",
        );
      shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", `#include <common>\n${IN_FRAGMENT}`)
        .replace(
          "#include <tonemapping_fragment>",
          "gl_FragColor.rgb *= 1.0 - dropShadowShade();\n#include <tonemapping_fragment>",
        );
    };
  }

  hide(): void {
    this.uniforms.dropShadowDarkness.value = 0;
  }

  /** Shows the shadow of these pieces, which lie within a sphere. */
  show(pieces: Piece[], center: Vector3, radius: number): void {
    this.place(center, radius);
    this.scene.clear();
    for (const { mesh } of pieces) {
      if (mesh.visible) this.scene.add(this.copyOf(mesh));
    }
    this.uniforms.dropShadowDarkness.value = DARKNESS;
  }

  /** Draws the picture from below; call before the world is drawn. */
  draw(stage: Stage): void {
    if (this.uniforms.dropShadowDarkness.value > 0) stage.drawInto(this.picture, this.scene, this.camera);
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
    this.uniforms.dropShadowNear.value = (NEAR * this.unitsPerMeter) / camera.far;
    this.uniforms.dropShadowMatrix.value
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
  uniform mat4 dropShadowMatrix;
  varying vec3 dropShadowPlace;`;

/** Four samples soften the edge. The depth is 1 where the picture is empty. */
const IN_FRAGMENT = `
  uniform highp sampler2D dropShadowDepths;
  uniform float dropShadowNear;
  uniform float dropShadowDarkness;
  varying vec3 dropShadowPlace;

  float dropShadowAt(vec2 aside) {
    float depth = texture2D(dropShadowDepths, dropShadowPlace.xy + aside / ${SIZE}.0).r;
    return depth < 0.9999 && dropShadowPlace.z < depth - dropShadowNear ? 0.25 : 0.0;
  }

  float dropShadowShade() {
    vec2 away = abs(dropShadowPlace.xy - 0.5);
    if (dropShadowDarkness == 0.0 || max(away.x, away.y) > 0.49) return 0.0;
    float covered = dropShadowAt(vec2(-0.8, -0.4)) + dropShadowAt(vec2(0.4, -0.8)) +
                    dropShadowAt(vec2(0.8, 0.4)) + dropShadowAt(vec2(-0.4, 0.8));
    return dropShadowDarkness * covered;
  }`;
