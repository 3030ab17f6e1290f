// A shared recording: anyone with the link looks at it and plays it in a browser of their own, and changes nothing;
// the person who shared it continues undisturbed.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import WebSocket from "ws";
import { Browser } from "./workbench.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const PHONE = { width: 390, height: 844 };
const DESK = { width: 1280, height: 800 };

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** A person with a link, in a browser that has never seen the studio. */
class Watcher {
  static async at(studio, link) {
    const context = await browser.browser.newContext({ viewport: DESK, reducedMotion: "reduce" });
    studio.whenClosed.push(() => context.close());
    const page = await context.newPage();
    const watcher = new Watcher(page);
    page.on("request", (request) => watcher.paths.push(new URL(request.url()).pathname));
    page.on("websocket", (socket) => watcher.paths.push(socket.url()));
    page.on("pageerror", (error) => watcher.complaints.push(String(error)));
    await page.goto(link);
    return watcher;
  }

  constructor(page) {
    Object.assign(this, { page, paths: [], complaints: [] });
  }

  get moment() {
    return this.page.getByRole("slider", { name: "Moment" });
  }

  async seconds() {
    return Number(await this.moment.inputValue());
  }

  async isShown() {
    await this.page.waitForFunction(() => window.smileStudio?.stats().isShown);
  }

  /** Drags the thumb of the slider to a share of its length. */
  async scrubTo(share) {
    const box = await this.moment.boundingBox();
    const at = (one) => [box.x + 8 + one * (box.width - 16), box.y + box.height / 2];
    const length = Number(await this.moment.getAttribute("max"));
    await this.page.mouse.move(...at((await this.seconds()) / length));
    await this.page.mouse.down();
    await this.page.mouse.move(...at(share), { steps: 5 });
    await this.page.mouse.up();
  }

  /** Waits until the block is drawn at this height [units]. */
  async blockIsAt(height) {
    const isThere = (wanted) => Math.abs(window.smileStudio.placeOf("RedBlock")[2] - wanted) < 0.01;
    await this.page.waitForFunction(isThere, height);
  }
}

/** What axe-core has to say of a page. */
async function violationsOn(page) {
  await page.evaluate(AXE);
  return page.evaluate(() =>
    window.axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) => violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`)),
  );
}

/** The status with which a WebSocket is answered. */
function statusOf(door) {
  return new Promise((resolve) => {
    const socket = new WebSocket(door);
    socket.on("unexpected-response", (request, answer) => {
      request.destroy();
      resolve(answer.statusCode);
    });
    socket.on("open", () => resolve(101));
    socket.on("error", () => resolve(0));
  });
}

/** Opens the dialog of the only recording. */
async function openDialog(page, person) {
  await person.showPanel("Library");
  await page.getByRole("button", { name: /^Actions for/ }).click();
  await page.getByRole("menuitem", { name: "Share…" }).click();
  const dialog = page.getByRole("dialog", { name: /^Share/ });
  await dialog.getByText("This recording has no link.").waitFor();
  return dialog;
}

/** It plays to its end, and goes where it is dragged. */
async function plays(watcher, { below, above }) {
  const { page, moment } = watcher;
  const play = page.getByRole("button", { name: "Play" });
  await page.getByRole("combobox", { name: "Playback speed" }).selectOption({ label: "4×" });
  await play.click();
  await watcher.blockIsAt(above);
  await play.waitFor();
  const length = Number(await moment.getAttribute("max"));
  await watcher.blockIsAt(below);
  assert.ok(length - (await watcher.seconds()) < 0.05, "at the end the block is down again");
  await watcher.scrubTo(0);
  await watcher.blockIsAt(below);
  await watcher.scrubTo(0.5);
  assert.ok(Math.abs((await watcher.seconds()) - length / 2) < 0.1 * length, `${await watcher.seconds()} of ${length}`);
  await page.locator("h1").click();
  await page.keyboard.press("Space");
  await page.getByRole("button", { name: "Stop" }).waitFor();
  await page.keyboard.press("Space");
  await play.waitFor();
}

/** One looks around, and reaches nothing. */
async function changesNothing(watcher, witness, link) {
  const { page, paths } = watcher;
  const before = await page.evaluate(() => window.smileStudio.screenPointOf("RedBlock"));
  const events = witness.events.length;
  await page.mouse.click(before.x, before.y);
  await page.mouse.click(before.x, before.y, { button: "right" });
  for (const key of ["r", "Delete", "Backspace", "Control+z", "Enter"]) await page.keyboard.press(key);
  assert.equal(await page.getByRole("menu").count(), 0);
  assert.equal(await page.getByRole("textbox").count(), 0);
  await page.mouse.move(200, 300);
  await page.mouse.down();
  await page.mouse.move(320, 320, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction(({ x, y }) => {
    const now = window.smileStudio.screenPointOf("RedBlock");
    return now === null || Math.hypot(now.x - x, now.y - y) > 20;
  }, before);
  await witness.catchUp();
  assert.equal(witness.events.length, events, "nothing happened in the studio");
  assert.equal(witness.state.mode, "live", "it shows its table");
  assert.deepEqual(paths.filter((path) => !path.startsWith("/shared/")), [], "the page uses nothing else of the studio");
  assert.equal(await statusOf(`${link.replace("http", "ws")}/ws`), 404);
}

/** Everyone can use the page, also on a phone. */
async function isForEveryone(watcher) {
  const { page } = watcher;
  for (const [viewport, colorScheme] of [[DESK, "light"], [DESK, "dark"], [PHONE, "light"]]) {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme });
    await page.waitForFunction((theme) => document.documentElement.dataset.theme === theme, colorScheme);
    await picture(page, `${colorScheme}-${viewport.width}`);
    assert.deepEqual(await violationsOn(page), [], `${colorScheme}, ${viewport.width} px`);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width, "nothing is beside the page");
  }
}

test("a shared recording is played in other browsers, and nothing can be changed", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { studio: ["--no-robot", "--size", "64x48"] });
  const below = witness.positionOf("RedBlock")[2];
  let above = below;
  const id = await person.record(async () => {
    await person.grasp("RedBlock");
    await person.dragTo("RedBlock", [null, null, 3]);
    above = await witness.settled(() => witness.positionOf("RedBlock")[2], "the block is held", 300);
    await person.dragTo("RedBlock", [null, null, below]);
    await person.release();
  });
  const dialog = await openDialog(page, person);
  await person.press("Make a link", dialog);
  const link = await dialog.getByRole("textbox", { name: "Link" }).inputValue();
  assert.match(link, /^http:\/\/127\.0\.0\.1:\d+\/shared\/[0-9a-f]{32}$/);
  await picture(page, "dialog");
  assert.deepEqual(await violationsOn(page), []);
  assert.equal((await witness.request("share_links", { recording: id })).ok, false, "watchers of the studio see no links");

  const [watcher, other] = [await Watcher.at(studio, link), await Watcher.at(studio, `${link}/`)];
  await Promise.all([watcher.isShown(), other.isShown()]);
  const title = await watcher.page.getByRole("heading", { level: 1 }).textContent();
  assert.equal(await watcher.page.title(), title);
  await watcher.page.getByRole("img", { name: "View of the robot’s eye" }).waitFor();
  await watcher.page.waitForFunction(() => {
    const shown = [...document.querySelectorAll(".segment img")];
    return shown.length > 1 && shown.every((image) => image.naturalWidth === 320);
  });
  await plays(watcher, { below, above });
  assert.equal(await other.seconds(), 0, "each watcher has a time of their own");
  await other.page.locator(".segment button").last().click();
  assert.ok((await other.seconds()) > 0);
  await changesNothing(watcher, witness, link);
  await isForEveryone(watcher);

  await person.press("Stop sharing", dialog);
  await dialog.getByText("This recording has no link.").waitFor();
  for (const gone of [link, `${link}/`, link.slice(0, -1), new URL("/shared/", link).href, `${new URL("/shared/", link).href}${"0".repeat(32)}`]) {
    await watcher.page.goto(gone);
    await watcher.page.getByRole("alert").getByText("no longer shared").waitFor();
  }
  await picture(watcher.page, "gone");
  assert.deepEqual(await violationsOn(watcher.page), []);
  assert.deepEqual([...watcher.complaints, ...other.complaints], []);
});

/** For people to look at, if they want to. */
async function picture(page, name) {
  const folder = process.env.SMILE_PICTURES;
  if (folder !== undefined) await page.screenshot({ path: `${folder}/sharing-${name}.png` });
}
