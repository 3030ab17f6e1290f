import {
  type Camera,
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  NeutralToneMapping,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  ShadowMaterial,
  type Vector3,
  WebGLRenderer,
  type WebGLRenderTarget,
} from "three";

const FLOOR_DEPTH = 0.9; // below the table top [m]
const LIT_RADIUS = 1.7; // about the table's middle, in which shadows fall [m]
const SHADOW_PIXELS = 2048;
const COARSE = 0.6; // of a pixel

/** Light, floor and background, and what draws them. The background is the page's own. */
export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera();
  /** [px] */
  width = 1;
  height = 1;
  private renderer: WebGLRenderer;
  private fullRatio = 1;
  private readonly sun = new DirectionalLight("#fff9f0", 1.9);
  private readonly fill = new DirectionalLight("#e6eeff", 0.6);
  private readonly floor = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.28 }));
  private readonly ground = new Mesh(new PlaneGeometry(1, 1), groundMaterial());
  private readonly sizes: ResizeObserver;

  constructor(
    private readonly host: HTMLElement,
    private readonly onResize: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.sun.shadow.radius = 3.5;
    this.floor.receiveShadow = true;
    this.ground.renderOrder = -1;
    this.scene.add(this.sun, this.sun.target, this.fill, this.fill.target, this.floor, this.ground);
    this.scene.add(new HemisphereLight("#f4f7fc", "#b9b4ae", 1.5));
    host.style.background =
      "linear-gradient(light-dark(#b4c4d6, #0e1218), light-dark(#e6eaee, #272e38) 70%)";
    this.renderer = this.makeRenderer(false);
    if (isDrawnBySoftware(this.renderer)) this.setDetail(true);
    this.fit();
    this.sizes = new ResizeObserver(() => {
      this.fit();
      this.onResize();
    });
    this.sizes.observe(host);
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  get isLow(): boolean {
    return !this.renderer.shadowMap.enabled;
  }

  /** Edges are smoothed or not from the beginning of a drawing context on: so it is a new one. */
  setDetail(isLow: boolean): void {
    if (isLow === this.isLow) return;
    this.renderer.domElement.remove();
    this.renderer.dispose();
    this.renderer = this.makeRenderer(isLow);
    this.fit();
  }

  /** With fewer pixels, or as many as there are. */
  setCoarse(isCoarse: boolean): void {
    const ratio = isCoarse ? COARSE : this.fullRatio;
    if (ratio === this.renderer.getPixelRatio()) return;
    this.renderer.setPixelRatio(ratio);
    this.fit();
  }

  /** So many units make a meter; the middle of the table top is here. */
  setScale(unitsPerMeter: number, center: Vector3): void {
    const lit = LIT_RADIUS * unitsPerMeter;
    this.sun.position.set(0.5, 0.42, 1).multiplyScalar(2.4 * unitsPerMeter).add(center);
    this.fill.position.set(-0.6, -0.8, 0.5).multiplyScalar(unitsPerMeter).add(center);
    for (const { target } of [this.sun, this.fill]) target.position.copy(center);
    Object.assign(this.sun.shadow.camera, { left: -lit, right: lit, top: lit, bottom: -lit });
    Object.assign(this.sun.shadow.camera, { near: 0.1 * unitsPerMeter, far: 6 * unitsPerMeter });
    this.sun.shadow.camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = 0.003 * unitsPerMeter;
    this.camera.far = 100 * unitsPerMeter;
    this.camera.updateProjectionMatrix();
    for (const [level, depth] of [[this.floor, FLOOR_DEPTH], [this.ground, FLOOR_DEPTH + 0.001]] as const) {
      level.position.set(center.x, center.y, center.z - depth * unitsPerMeter);
      level.scale.setScalar(9 * unitsPerMeter);
    }
    this.shadowsMoved();
  }

  /** To be called when something moved that casts a shadow. */
  shadowsMoved(): void {
    this.renderer.shadowMap.needsUpdate = true;
  }

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** Draws something else that is not shown itself, but needed to draw. */
  drawInto(target: WebGLRenderTarget, scene: Scene, camera: Camera): void {
    this.renderer.setRenderTarget(target);
    this.renderer.clear();
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
  }

  /** Of the last picture. */
  get counts(): { calls: number; triangles: number } {
    return this.renderer.info.render;
  }

  dispose(): void {
    this.sizes.disconnect();
    this.renderer.domElement.remove();
    this.renderer.dispose();
  }

  private makeRenderer(isLow: boolean): WebGLRenderer {
    const renderer = new WebGLRenderer({ antialias: !isLow, alpha: true, stencil: true });
    renderer.toneMapping = NeutralToneMapping;
    renderer.toneMappingExposure = 1.0;
    renderer.shadowMap.enabled = !isLow;
    renderer.shadowMap.type = PCFShadowMap;
    renderer.shadowMap.autoUpdate = false;
    renderer.shadowMap.needsUpdate = true;
    this.sun.castShadow = !isLow;
    this.floor.visible = !isLow;
    this.fullRatio = isLow ? 1 : Math.min(devicePixelRatio, 2);
    renderer.setPixelRatio(this.fullRatio);
    renderer.domElement.style.cssText = "position:absolute;inset:0;width:100%;height:100%;touch-action:none";
    this.host.prepend(renderer.domElement);
    return renderer;
  }

  private fit(): void {
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    this.renderer.setSize(this.width, this.height, false);
    this.camera.aspect = this.width / this.height;
    this.camera.updateProjectionMatrix();
  }
}

function isDrawnBySoftware(renderer: WebGLRenderer): boolean {
  const gl = renderer.getContext();
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = names === null ? "" : String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
  return /llvmpipe|swiftshader|softpipe|software/i.test(name);
}

/** A floor that one feels rather than sees: it fades away. */
function groundMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: { shade: { value: new Color("#7d8894").convertLinearToSRGB() } },
    vertexShader: `
      varying vec2 place;
      void main() {
        place = 2.0 * uv - 1.0;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform vec3 shade;
      varying vec2 place;
      void main() { gl_FragColor = vec4(shade, 0.30 * smoothstep(1.0, 0.1, length(place))); }`,
  });
}
