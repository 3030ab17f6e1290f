// A new user starts for the first time and does what the tour says.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, replay, sceneFile } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

test("the tour leads from nothing to a demonstration that a robot can use", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { likes: { "tour-known": false } });
  const says = (title) => page.locator(".tour h2", { hasText: title }).waitFor();

  await says("Show a robot what to do");
  await person.press("Start");
  await says("Look around");
  const sky = await page.locator(".world").boundingBox();
  // Who presses on the card turns no view, and selects nothing.
  const card = await page.locator(".tour p").boundingBox();
  await page.mouse.move(card.x + 20, card.y + 6);
  await page.mouse.down();
  await page.mouse.move(sky.x + 0.6 * sky.width, sky.y + 90, { steps: 12 });
  await page.mouse.up();
  assert.equal(await page.evaluate(() => getSelection().toString()), "");
  await staysAt(page, "Look around");
  await page.mouse.move(sky.x + sky.width - 70, sky.y + 90);
  await page.mouse.down();
  await page.mouse.move(sky.x + sky.width - 40, sky.y + 95, { steps: 6 });
  await page.mouse.up();
  await says("Record");
  await person.press("Record");
  await says("Take a block");
  await person.grasp("RedBlock");
  const { id } = witness.state.recording;
  await says("Lift it");
  await person.dragTo("RedBlock", [null, null, 2.3]);
  await says("Turn it");
  await page.getByRole("slider", { name: "Turn about z (°)" }).fill("90");
  await says("Put it on another");
  for (const view of ["Top", "Front"]) {
    await person.press(view);
    // The camera is on its way for a moment.
    for (let k = 0; k < 60 && (await coversBlocks()); ++k) await person.look();
    assert.equal(await coversBlocks(), false, `the card is beside all blocks in the view ${view}`);
  }
  const [x, y] = witness.positionOf("GreenBlock");
  await person.carryAbove("RedBlock", [x, y, 2.3]);
  await person.dragTo("RedBlock", [null, null, 1.5]);
  await person.release();
  await says("Undo");
  await person.press("Undo");
  await says("Redo");
  await person.press("Redo");
  await says("Finish");
  await person.press("Finish");
  await says("Tour complete");
  await person.press("Done");
  assert.equal(await page.locator(".tour").count(), 0);

  const { identical, ticks } = replay(join(studio.recordings, id));
  assert.ok(identical && ticks > 0);
  const [, take, put] = (await witness.request("open", { recording: id })).timeline.segments;
  assert.equal(take.deed.words, "any hand takes RedBlock");
  assert.equal(put.deed.words, "any hand puts RedBlock on GreenBlock");
  await page.reload();
  await page.waitForFunction(() => window.smileStudio?.stats().isShown);
  assert.equal(await page.locator(".tour").count(), 0, "who knows it is left in peace");

  async function coversBlocks() {
    const card = await page.locator(".tour").boundingBox();
    const points = await Promise.all(["RedBlock", "GreenBlock", "BlueBlock"].map((id) => person.pointOf(id)));
    return points.some(({ x, y }) => x > card.x && x < card.x + card.width && y > card.y && y < card.y + card.height);
  }
});

test("the tour takes no stack that was there before for the person's own", async (t) => {
  const scene = sceneFile(
    t,
    "stacked",
    `<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="Lower" location="(4,1,0.5)" color="green"/>
  <block id="Upper" location="(4,1,1.5)" color="blue"/>
  <block id="Free" location="(-1,-2,0.5)" color="red"/>
</tabletop>
`,
  );
  const { page, witness, person } = await browser.workplace(t, { studio: [scene], likes: { "tour-known": false } });
  const says = (title) => page.locator(".tour h2", { hasText: title }).waitFor();
  await says("Show a robot what to do");
  await person.press("Start");
  for (const title of ["Look around", "Record", "Take a block", "Lift it", "Turn it"]) {
    await says(title);
    await person.press("Skip this step");
  }
  await says("Put it on another");
  await person.grasp("Free");
  await person.release();
  await witness.until(() => witness.state.still && !witness.isHeld("Free"), "it rests on the table");
  await person.untilDone();
  await staysAt(page, "Put it on another");
  await person.grasp("Free");
  await person.carryOnto("Free", [4, 1, 2.5]);
  await person.release();
  await says("Undo");
});

/** A step that is done is praised at once, before the next one follows. */
async function staysAt(page, title) {
  await page.waitForTimeout(300);
  assert.equal(await page.locator(".tour h2").textContent(), title);
  assert.equal(await page.getByText("Well done!").count(), 0);
}
