// A person demonstrates at the page, with a real mouse; what came of it is asked of the program and of the files.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Person } from "./person.mjs";
import { Browser, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

test("three blocks are stacked, recorded, and replayed exactly", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t);
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  const { id } = witness.state.recording;
  await stack("RedBlock", [0, -2.5, 0.5]);
  await stack("GreenBlock", [0, -2.5, 1.5]);
  await stack("BlueBlock", [0, -2.5, 2.5]);

  // One more, which is taken back.
  await person.grasp("BlueBlock");
  await person.dragTo("BlueBlock", [null, null, 4]);
  await person.release();
  const numSegments = witness.state.recording.segments.length;
  await person.press("Undo");
  await person.press("Undo");
  await witness.until(() => witness.state.recording.segments.length < numSegments, "a segment less");
  await witness.until(() => Math.abs(witness.positionOf("BlueBlock")[2] - 2.5) < 0.1, "the tower stands again");

  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");
  await person.showPanel("Library");
  await page.locator(".recording", { hasText: "tower" }).waitFor();
  assert.ok(existsSync(join(studio.recordings, id)));
  const report = replay(join(studio.recordings, id));
  assert.equal(report.identical, true, JSON.stringify(report));

  async function stack(block, place) {
    await person.grasp(block);
    await person.carryOnto(block, place);
    await person.release();
    const isThere = () => Math.hypot(...place.map((value, k) => value - witness.positionOf(block)[k])) < 0.15;
    await witness.until(isThere, `${block} stands at ${place}`);
  }
});

test("planes and rings turn the held object; clicks elsewhere and keys release it", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-robot"] });
  await person.grasp("BlueBlock");
  await person.dragTo("BlueBlock", [null, null, 2]);

  const { plane } = witness.handOf("BlueBlock");
  await page.keyboard.press("\\");
  const turned = () => Math.abs(Math.abs(witness.handOf("BlueBlock").plane - plane) - 90) < 1e-6;
  await witness.until(turned, "the plane is turned by a right angle");
  await page.keyboard.press("\\");
  await witness.until(() => !turned(), "and by another");

  const before = witness.handOf("BlueBlock").angles;
  await person.turnRing("z", 245, 290);
  const byRing = () => witness.handOf("BlueBlock").angles[2] - before[2];
  await witness.until(() => Math.abs(byRing()) > 20, "the ring has turned it");
  await person.untilDone();
  assert.deepEqual(witness.handOf("BlueBlock").angles.slice(0, 2), before.slice(0, 2), "about z only");
  await page.getByRole("slider", { name: "Turn about z (°)" }).fill("90");
  await witness.until(() => Math.abs(witness.yawOf("BlueBlock") - 90) < 1, "the slider has turned it in the world");

  // From here, both other rings cross z's letter: it turns about z nevertheless.
  await page.keyboard.press("1");
  await page.mouse.move(330, 120);
  await page.mouse.down();
  await page.mouse.move(410, 180, { steps: 4 });
  await page.mouse.up();
  await person.look();
  assert.ok((await gapAtLetter("x")) < 8 && (await gapAtLetter("y")) < 8, "both cross it");
  const upright = witness.handOf("BlueBlock").angles;
  await person.turnRing("z", 230, 270);
  await person.untilDone();
  const turnedTo = witness.handOf("BlueBlock").angles;
  assert.ok(Math.abs(turnedTo[2] - upright[2]) > 20, `${turnedTo}`);
  assert.deepEqual(turnedTo.slice(0, 2), upright.slice(0, 2), "about z only");
  await page.keyboard.press("2");

  await person.click(await person.placeOnPage([-6, 3, 0]));
  await witness.until(() => !witness.isHolding, "a click elsewhere releases it");

  // And all of it again, without a mouse.
  await page.getByRole("listbox", { name: /^Objects/ }).focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Enter");
  await witness.until(() => witness.isHeld("RedBlock"), "Enter takes the chosen object");
  await page.locator("#nudge:focus").waitFor();
  await page.keyboard.press("Shift+PageUp");
  await witness.until(() => witness.positionOf("RedBlock")[2] > 1.4, "Page Up lifts it");
  await page.keyboard.press("Enter");
  await witness.until(() => !witness.isHolding, "Enter releases it");
  await witness.until(() => witness.positionOf("RedBlock")[2] < 0.6, "and it falls");

  /** From the letter of the ring about z to another ring [px]. */
  function gapAtLetter(axis) {
    return page.evaluate((other) => {
      const letter = window.smileStudio.ringPointOf("z", 230);
      const gaps = Array.from({ length: 180 }, (_, k) => window.smileStudio.ringPointOf(other, 2 * k));
      return Math.min(...gaps.map(({ x, y }) => Math.hypot(x - letter.x, y - letter.y)));
    }, axis);
  }
});

test("keys work wherever the focus is, but where text is written", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-pictures"] });
  const isRecording = () => witness.state.recording !== null;
  await person.showPanel("Robot");
  await page.keyboard.press("r");
  await witness.until(isRecording, "R begins a recording while a tab has the focus");
  await page.keyboard.press("h");
  const help = page.getByRole("dialog");
  await help.waitFor();
  await page.keyboard.press("Escape");
  await help.waitFor({ state: "detached" });
  await page.getByRole("listbox", { name: /^Objects/ }).focus();
  await page.keyboard.press("r");
  await witness.until(() => !isRecording(), "R finishes it while the list has the focus");
  const slider = page.getByRole("tabpanel", { name: "Robot" }).getByRole("slider").first();
  await slider.focus();
  await page.keyboard.press("r");
  await witness.until(isRecording, "R begins another while a slider has the focus");
  await page.getByRole("searchbox").first().focus();
  await page.keyboard.press("r");
  await person.untilDone();
  assert.ok(isRecording(), "R is a letter there");
});

test("a reload loses nothing; a second page watches, asks for control, and gets it", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { studio: ["--no-robot"] });
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  const { id } = witness.state.recording;
  await person.grasp("GreenBlock");
  await person.dragTo("GreenBlock", [null, null, 2]);
  await page.reload();
  await page.waitForFunction(() => window.smileStudio?.stats().isShown);
  await person.button("Finish").waitFor();
  assert.equal(witness.state.recording.id, id, "it still records");
  assert.ok(witness.isHeld("GreenBlock"), "and still holds");
  assert.ok(witness.positionOf("GreenBlock")[2] > 1.9);

  const second = await browser.open(studio);
  const other = new Person(second, witness);
  await second.getByText("You are watching.").waitFor();
  await other.click(await other.pointOf("RedBlock"));
  assert.ok(await other.button("Finish").isDisabled(), "a watcher records nothing");
  await other.press("Take control");
  await person.press("Hand over");
  await page.getByText("You are watching.").waitFor();
  assert.ok(!witness.isHeld("RedBlock"), "a watcher grasps nothing");
  await other.press("Finish");
  await witness.until(() => witness.state.recording === null, "who has control may finish");
});

/** For pages of which only buttons matter: each picture costs time. */
const SMALL = { viewport: { width: 1000, height: 560 } };
/** The controller is asked at most once in this time, by all clients together. */
const PAUSE_MS = 3000;

test("requests for control stop no drag, and each refused client is notified", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  const [second, third] = [await browser.open(studio, SMALL), await browser.open(studio, SMALL)];
  const [other, another] = [new Person(second, witness), new Person(third, witness)];
  await person.grasp("RedBlock");
  await person.dragTo("RedBlock", [null, null, 2]);
  const at = await person.take("RedBlock");
  await page.mouse.move(at.x, at.y - 30, { steps: 3 });
  await other.press("Take control");
  const banner = page.getByRole("status", { name: "Control requested" });
  await banner.getByText(/Visitor \d+ requests control/).waitFor();
  const before = await person.restOf("RedBlock");
  await page.mouse.move(at.x, at.y - 90, { steps: 3 });
  await witness.until(() => witness.handOf("RedBlock").place[2] > before[2] + 0.3, "it is dragged on");
  await page.mouse.up();

  await page.waitForTimeout(PAUSE_MS);
  await another.press("Take control");
  await banner.getByText(/Visitors \d+ and \d+ request control/).waitFor();
  await person.press("Keep control", banner);
  await second.getByText(/Visitor \d+ keeps control/).waitFor();
  await third.getByText(/Visitor \d+ keeps control/).waitFor();
  assert.equal(await banner.count(), 0);
  await another.press("Take control");
  await third.getByText(/you can ask again in \d+ s/).waitFor();
  await third.getByRole("button", { name: "Control", exact: true }).click();
  await third.getByRole("menuitem", { name: "Take control from an inactive controller" }).click();
  await third.getByText(/control can be taken after inactivity of 30 s/).waitFor();
  assert.equal(await banner.count(), 0, "no client is asked so often");
  assert.ok(witness.isHeld("RedBlock"));
  await person.release();
});

test("of several who ask, one is chosen to have control", async (t) => {
  const { studio, page, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  const banner = page.getByRole("status", { name: "Control requested" });
  const askers = [await browser.open(studio, SMALL), await browser.open(studio, SMALL)];
  for (const [k, asker] of askers.entries()) {
    if (k > 0) await page.waitForTimeout(PAUSE_MS);
    await asker.getByRole("button", { name: "Take control" }).click();
    await asker.getByText("Control requested").waitFor();
  }
  const both = /Visitors (\d+) and (\d+) request/;
  await banner.getByText(both).waitFor();
  const [, first, second] = both.exec(await banner.textContent());
  assert.notEqual(first, second);
  await person.press("Hand over", banner);
  await page.getByRole("menuitem", { name: `Give control to visitor ${first}` }).click();
  await askers[0].getByText(/^In control/).first().waitFor();
  await banner.waitFor({ state: "detached" });
  await page.getByText("You are watching.").waitFor();
  assert.equal(await askers[1].getByText("You are watching.").count(), 1);
});
