// What makes daily work easier: keys in tooltips, a layout that stays, a palette, several objects at once, the
// choice of the recorded camera.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const BARE = ["--no-robot", "--no-pictures"];

test("tooltips name the keys that do the same", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: BARE });
  await person.grasp("RedBlock");
  await person.button("Move up").waitFor();
  const hinted = await page.locator("[aria-keyshortcuts][title]").evaluateAll((all) =>
    all.map(({ title, ariaKeyShortcuts, textContent }) => ({ title, key: ariaKeyShortcuts ?? "", text: textContent })),
  );
  assert.ok(hinted.length >= 20, `${hinted.length} tooltips`);
  for (const { title, text } of hinted) assert.match(title, /\(\S+\)$/, text);
  const titleOf = (name) => person.button(name).getAttribute("title");
  assert.equal(await titleOf("Front"), "View from the front, toward the robot (1)");
  assert.equal(await titleOf("Turn the plane by -5°"), "Turn the plane by -5° (Shift+/)");
  assert.match(await titleOf("Destroy"), /\(Del\)$/);

  // The keys that they name are those of the help, and do it.
  const before = witness.handOf("RedBlock").place[2];
  const [, key] = /\((.)\)$/.exec(await titleOf("Move up"));
  await page.keyboard.press(key.toLowerCase());
  await witness.until(() => witness.handOf("RedBlock").place[2] > before, "the key moves it up");
  await page.keyboard.press("h");
  const help = page.getByRole("dialog", { name: "Keys and mouse" });
  await help.waitFor();
  const known = await help.locator("kbd").allTextContents();
  for (const { title } of hinted) assert.ok(known.includes(/\((\S+)\)$/.exec(title)[1]), title);
});

test("the layout stays across visits, and returns to the default", async (t) => {
  const { page, person } = await browser.workplace(t, { studio: BARE });
  const visitAgain = async () => {
    await page.reload();
    await page.waitForFunction(() => window.smileStudio?.stats().isShown);
  };
  const panel = page.getByRole("complementary", { name: "Objects and library" });
  const widthOf = async (place) => (await place.boundingBox()).width;
  const usual = await widthOf(panel);
  /** Where the middle of the table's edge is on the page: another in each view. */
  const seen = async () => {
    await person.look();
    const { x, y } = await person.placeOnPage([4, 0, 0]);
    return [Math.round(x), Math.round(y)];
  };
  const first = await seen();

  await person.showPanel("Library");
  const { x, y, width, height } = await panel.getByRole("separator").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 90, y + height / 2, { steps: 3 });
  await page.mouse.up();
  await page.getByRole("button", { name: "Snap to" }).click();
  await page.getByRole("button", { name: "Timeline", exact: true }).click();
  await page.keyboard.press("3");
  const fromAbove = await seen();
  assert.notDeepEqual(fromAbove, first);

  await visitAgain();
  assert.ok(Math.abs((await widthOf(panel)) - usual - 90) <= 2, `${await widthOf(panel)} px`);
  await page.getByRole("tab", { name: "Library", selected: true }).waitFor();
  assert.equal(await page.getByRole("button", { name: "Snap to" }).getAttribute("aria-expanded"), "false");
  assert.equal(await page.getByRole("button", { name: "Timeline", exact: true }).getAttribute("aria-expanded"), "false");
  assert.deepEqual(await seen(), fromAbove, "from above");
  await panel.getByRole("separator").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs((await widthOf(panel)) - usual - 110) <= 2, "by keys, too");

  for (const visit of ["now", "later"]) {
    if (visit === "now") {
      await page.keyboard.press("h");
      await person.press("Default layout");
    } else {
      await visitAgain();
    }
    await page.getByRole("tab", { name: "Objects", selected: true }).waitFor();
    assert.equal(await widthOf(panel), usual);
    assert.equal(await page.getByRole("button", { name: "Snap to" }).getAttribute("aria-expanded"), "true");
    assert.equal(await page.getByRole("button", { name: "Timeline", exact: true }).getAttribute("aria-expanded"), "true");
    assert.deepEqual(await seen(), first, visit);
  }
});

/** A place of the table on the page [px]. */
const placeOnPage = (page, place) => page.evaluate((point) => window.smileStudio.screenPlaceOf(point), place);

test("objects are dragged from the palette to a place", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: BARE });
  const chip = page.getByRole("list", { name: /^Palette/ }).getByRole("button", { name: "Big block" });
  const drop = async (place) => {
    const from = await chip.boundingBox();
    const to = await placeOnPage(page, place);
    await page.mouse.move(from.x + 8, from.y + 8);
    await page.mouse.down();
    await page.mouse.move(to.x - 20, to.y, { steps: 3 });
    await page.mouse.move(to.x, to.y, { steps: 2 });
    await page.locator(".carried").waitFor();
    await page.mouse.up();
  };
  await person.look();
  const before = witness.ids;
  await drop([-4, 1.5, 0]);
  await witness.until(() => witness.ids.length === before.length + 1, "a block more");
  const [added] = witness.ids.filter((id) => !before.includes(id));
  await witness.until(() => witness.positionOf(added).every(Number.isFinite));
  const [x, y] = witness.positionOf(added);
  assert.ok(Math.hypot(x + 4, y - 1.5) < 0.15, `it is at ${x}, ${y}`);

  // Where there is no room, or beside the world, nothing is added.
  await person.look();
  const tray = await page.getByRole("region", { name: "Timeline" }).boundingBox();
  const from = await chip.boundingBox();
  await page.mouse.move(from.x + 8, from.y + 8);
  await page.mouse.down();
  await page.mouse.move(tray.x + 300, tray.y + 30, { steps: 3 });
  await page.getByText("Drop it on the table").waitFor();
  await page.mouse.up();
  await page.locator(".carried").waitFor({ state: "detached" });
  assert.equal(witness.ids.length, before.length + 1);
  await person.press("Undo");
  await witness.until(() => witness.ids.length === before.length, "it is gone");
});

test("several objects are moved together, copied and pasted", async (t) => {
  const { page, studio, witness, person } = await browser.workplace(t, { studio: BARE });
  const list = page.getByRole("listbox", { name: /^Objects/ });
  const option = (id) => list.getByRole("option", { name: new RegExp(`^${id}`) });
  const card = page.getByRole("region", { name: /^Selected/ });
  const placesOf = (...ids) => ids.map((id) => witness.positionOf(id));
  const moved = ([before, after]) => after.map((value, axis) => value - before[axis]);

  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  const { id } = witness.state.recording;
  await option("RedBlock").click();
  await option("GreenBlock").click({ modifiers: ["Control"] });
  await page.getByRole("region", { name: "Selected: 2 objects" }).waitFor();
  assert.deepEqual(Object.values(witness.state.hands).map(({ object }) => object), [null, null, null, null]);
  const before = placesOf("RedBlock", "GreenBlock", "BlueBlock");
  const way = () => Math.hypot(...moved([before[0], witness.positionOf("RedBlock")]));
  await person.press("Move them left", card);
  await witness.until(() => way() > 0.09, "it is moved");
  await person.press("Undo");
  await witness.until(() => way() < 1e-4, "it is back");

  // One of them is dragged; the other one goes along.
  await person.look();
  const start = await person.pointOf("RedBlock");
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(start.x - 30, start.y + 20, { steps: 4 });
  await page.mouse.move(start.x - 60, start.y + 40, { steps: 4 });
  await page.mouse.up();
  await witness.until(() => way() > 0.2, "it is dragged");
  await witness.until(() => Math.abs(witness.positionOf("GreenBlock")[2] - before[1][2]) < 0.01, "they rest");
  const after = placesOf("RedBlock", "GreenBlock", "BlueBlock");
  const [red, green, blue] = before.map((place, k) => moved([place, after[k]]));
  assert.ok(red.every((value, axis) => Math.abs(value - green[axis]) < 0.01), `${red} and ${green}`);
  assert.ok(Math.hypot(...blue) < 0.01, "the others stay");

  // Copies stand beside them, to each other as they do, and are selected.
  await page.keyboard.press("Control+c");
  await page.keyboard.press("Control+v");
  await witness.until(() => witness.ids.includes("RedBlock_2") && witness.ids.includes("GreenBlock_2"), "copies");
  await card.getByText("RedBlock_2, GreenBlock_2").waitFor();
  await witness.until(() => placesOf("RedBlock_2", "GreenBlock_2").flat().every(Number.isFinite));
  const [r, g, r2, g2] = placesOf("RedBlock", "GreenBlock", "RedBlock_2", "GreenBlock_2");
  const [one, two] = [moved([r, r2]), moved([g, g2])];
  assert.ok(one.every((value, axis) => Math.abs(value - two[axis]) < 0.01), `${one} and ${two}`);

  // With Shift, objects are selected in the world.
  await page.keyboard.press("Escape");
  await page.getByRole("region", { name: "Selected: 0 objects" }).waitFor();
  for (const block of ["BlueBlock", "RedBlock"]) {
    await page.keyboard.down("Shift");
    await person.click(await person.pointOf(block));
    await page.keyboard.up("Shift");
  }
  await card.getByText("BlueBlock, RedBlock").waitFor();
  await person.finish();
  await person.segments.filter({ hasText: "moved 2 objects" }).first().waitFor();
  await person.segments.filter({ hasText: "added 2 objects" }).first().waitFor();
  assert.ok(replay(join(studio.recordings, id)).identical);
});

test("the camera is chosen whose pictures are recorded", async (t) => {
  const { page, studio, witness, person } = await browser.workplace(t);
  const choice = page.getByRole("combobox", { name: "Recorded camera" });
  const { info } = await recordWith("eye");
  assert.equal(info.eye.camera ?? "eye", "eye");
  const picture = page.locator(".eye img");
  const before = await picture.getAttribute("src");
  await choice.selectOption("in the screen");
  await witness.until(() => witness.state.eye.camera === "head", "the other camera");
  await page.waitForFunction(([image, old]) => image.src !== old, [await picture.elementHandle(), before]);
  const other = await recordWith("head");
  assert.equal(other.info.eye.camera, "head");
  assert.ok(replay(other.folder).identical);

  async function recordWith(camera) {
    await witness.until(() => witness.state.eye.camera === camera);
    const id = await person.record(async () => {
      // Not while it is recorded.
      await page.getByRole("combobox", { name: "Recorded camera", disabled: true }).waitFor();
      await person.grasp("RedBlock");
      await person.release();
    });
    const folder = join(studio.recordings, id);
    return { folder, info: JSON.parse(readFileSync(join(folder, "demo.json"), "utf8")) };
  }
});
