// The parts of docs/tutorials that are done with a mouse, step by step.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, programSays, replay } from "./workbench.mjs";

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
