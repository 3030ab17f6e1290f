// The parts of docs/tutorials that are done with a mouse, step by step.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, programSays, replay, sceneFile } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

function tutorial(name) {
  return readFileSync(new URL(`../../docs/tutorials/${name}.md`, import.meta.url), "utf8");
}

test("a first demonstration is recorded as the tutorial describes", async (t) => {
  const text = tutorial("first-demonstration");
  const { studio, page, witness, person } = await browser.workplace(t, { likes: { "tour-known": false } });

  await press("Not now");
  await press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  await person.grasp("RedBlock");
  await page.getByText("Held object: RedBlock").waitFor();
  await person.dragTo("RedBlock", [null, null, 2.5]);
  const [x, y] = witness.positionOf("GreenBlock");
  await person.carryAbove("RedBlock", [x, y, 2.5]);
  await person.dragTo("RedBlock", [null, null, 1.5]);
  await press("Release");
  await witness.until(() => witness.state.still, "the block rests");
  await press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");
  await press("Play");
  const segments = ["Beginning", "any hand takes RedBlock", "any hand puts RedBlock on GreenBlock"];
  assert.ok(text.replace(/\s+/g, " ").includes(segments.map((segment) => `*${segment}*`).join(", ")));
  for (const segment of segments) await person.segments.filter({ hasText: segment }).waitFor();
  await press("Back to the table");

  assert.deepEqual(readdirSync(studio.recordings), ["tower"]);
  const recording = join(studio.recordings, "tower");
  const [{ object, on }] = programSays(["describe", recording]).relations;
  assert.deepEqual([object, on], ["RedBlock", "GreenBlock"]);
  assert.ok(replay(recording).identical);

  /** Presses a button that the tutorial names. */
  async function press(name) {
    assert.ok(text.includes(`**${name}**`), `the tutorial names ${name}`);
    await person.press(name);
  }
});

test("the switch and the drawer of the tutorial's scene work by mouse", async (t) => {
  const [, xml] = /```xml cabinet.xml\n(.*?)```/s.exec(tutorial("scene-with-a-mechanism"));
  const { page, witness, person } = await browser.workplace(t, {
    studio: [sceneFile(t, "cabinet", xml), "--no-robot", "--no-pictures"],
  });
  const menu = await person.menuAt([-3.7, 0, 0.75]);
  await person.entry("Press or switch", menu).click();
  await witness.until(() => witness.state.controls.Lamp === "on", "the lamp is on");

  const knob = await person.placeOnPage([2.4, 0, 0.75]);
  await person.click(knob);
  await witness.until(() => witness.isHeld("Drawer"), "the drawer is held by its knob");
  await person.look();
  await person.pointer.press(knob);
  await person.pointer.moveTo(await person.placeOnPage([0.4, 0, 0.75]));
  await person.look();
  await person.pointer.lift();
  const isOpen = () => witness.positionOf("Drawer")[0] < 2 && witness.positionOf("Cube")[0] < 2.3;
  await witness.until(isOpen, "the drawer is open, and the cube in it");
  await person.click(await person.placeOnPage([-6, -4, 0]));
  await witness.until(() => !witness.isHolding, "a click elsewhere releases it");
});
