// Measures what the page promises, with a real browser and mouse: npm run figures.
// Nothing else should run meanwhile. SMILE names the program, build/release is the one to measure.

import { readdirSync, statSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { Browser, Witness } from "./workbench.mjs";

const PAGE = fileURLToPath(new URL("../../build/page/", import.meta.url));
const NUM_LOADS = 7;
const NUM_MOVES = 300;
const MOVE_MS = 1000 / 60;
const WATCHERS = [0, 20];

const browser = new Browser();
await browser.start({ isComposedByGl: true });
try {
  printSize();
  await printFirstPicture();
  for (const numWatchers of WATCHERS) await printDrag(numWatchers);
  await printScript();
} finally {
  await browser.close();
}

function printSize() {
  const packed = readdirSync(PAGE).filter((name) => name.endsWith(".gz") && name !== "de.js.gz");
  const numBytes = packed.reduce((sum, name) => sum + statSync(PAGE + name).size, 0);
  print("the page, packed", `${Math.round(numBytes / 1000)} kB`);
}

/** Each time in a browser that knows nothing yet. */
async function printFirstPicture() {
  const times = [];
  await atWork({}, async ({ studio }) => {
    for (let k = 0; k < NUM_LOADS; ++k) {
      const page = await browser.open(studio);
      times.push(await page.evaluate(() => window.firstPictureAt));
      await page.context().close();
    }
  });
  print("first picture, from the call of the page on", figures(times, "ms"));
}

/** While others watch. */
async function printDrag(numWatchers) {
  await atWork({}, async ({ studio, page, person }) => {
    for (let k = 0; k < numWatchers; ++k) await Witness.of(studio);
    await carryToAndFro(page, person);
    const [latencies, fps] = await page.evaluate(() => [window.smileStudio.lastLatencies(), window.smileStudio.fps()]);
    print(`drag to pose, ${numWatchers} watchers`, `${figures(latencies, "ms")}, ${Math.round(fps)} pictures a second`);
  });
}

/** What a picture of all detail costs the page itself: the rest is the graphics card's. */
async function printScript() {
  await atWork({ likes: { detail: "high" } }, async ({ page, person }) => {
    await page.evaluate(() => {
      window.scriptTimes = [];
      const ask = window.requestAnimationFrame.bind(window);
      window.requestAnimationFrame = (draw) =>
        ask((now) => {
          const start = performance.now();
          draw(now);
          window.scriptTimes.push(performance.now() - start);
        });
    });
    await carryToAndFro(page, person);
    print("script of a picture in high detail", figures(await page.evaluate(() => window.scriptTimes), "ms"));
  });
}

/** A block, as people do. */
async function carryToAndFro(page, person) {
  await person.grasp("RedBlock");
  const { x, y } = await person.take("RedBlock");
  const start = performance.now();
  for (let k = 0; k < NUM_MOVES; ++k) {
    await page.mouse.move(x + 60 * Math.sin(k / 20), y - 60 + 60 * Math.cos(k / 20));
    await new Promise((resolve) => setTimeout(resolve, start + (k + 1) * MOVE_MS - performance.now()));
  }
  await page.mouse.up();
}

async function atWork(options, work) {
  const ends = [];
  const desk = await browser.workplace({ after: (end) => ends.push(end) }, options);
  await work(desk);
  for (const end of ends) await end();
}

function figures(values, unit) {
  const sorted = values.toSorted((a, b) => a - b);
  const quantile = (part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))].toFixed(1);
  return `${quantile(0.5)} ${unit}, p95 ${quantile(0.95)} ${unit}, of ${sorted.length}`;
}

function print(what, figure) {
  console.log(`${what}: ${figure}`);
}
