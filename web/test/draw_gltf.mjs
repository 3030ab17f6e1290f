// Draws a glTF file with three.js in a browser, from its camera `visitor`, in its own light and some from all around.
// Usage: node draw_gltf.mjs MODEL PICTURE; tools/make_simulator_pictures.sh calls it.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { Browser } from "./workbench.mjs";

const SIZE = { width: 640, height: 400 };
const DRAWING = `
  import * as THREE from "three";
  import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

  window.draw = async (bytes, { width, height }) => {
    const model = await new GLTFLoader().parseAsync(Uint8Array.from(bytes).buffer, "");
    const visitor = model.cameras.find((camera) => camera.name === "visitor");
    visitor.aspect = width / height;
    visitor.updateProjectionMatrix();
    const scene = new THREE.Scene();
    scene.background = new THREE.Color(0xdde4ea);
    scene.add(model.scene, new THREE.AmbientLight(0xffffff, 1));
    const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    renderer.setSize(width, height);
    document.body.append(renderer.domElement);
    renderer.render(scene, visitor);
  };
`;

const [model, picture] = process.argv.slice(2);
const { outputFiles } = await build({
  stdin: { contents: DRAWING, resolveDir: fileURLToPath(new URL("..", import.meta.url)) },
  bundle: true,
  format: "iife",
  write: false,
});
const browser = new Browser();
await browser.start();
try {
  const page = await browser.browser.newPage({ viewport: SIZE });
  await page.setContent("<style>body { margin: 0 }</style>");
  await page.addScriptTag({ content: outputFiles[0].text });
  await page.evaluate(([bytes, size]) => window.draw(bytes, size), [[...readFileSync(model)], SIZE]);
  await page.screenshot({ path: picture });
} finally {
  await browser.close();
}
