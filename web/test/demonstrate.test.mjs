// A person at the page with a real mouse; what came of it is asked of the program and of the files.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openPage, smile, startBrowser, Studio, Witness } from "./workbench.mjs";

let browser;
before(async () => {
  browser = await startBrowser();
});
after(() => browser.close());

/** A studio, a page in control and a witness; all are taken down at the end of the test. */
async function workplace(t, ...words) {
  const studio = await Studio.start(...words);
  t.after(() => studio.close());
  const page = await openPage(browser, studio);
  t.after(() => page.context().close());
  const witness = await Witness.of(studio);
  t.after(() => witness.close());
  return { studio, page, witness };
}

async function pointOf(page, id) {
  return page.evaluate((object) => window.smileStudio.screenPointOf(object), id);
}

/** Clicks an object until a hand has it. */
async function grasp(page, witness, id) {
  const { x, y } = await pointOf(page, id);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.up();
  await witness.until(() => held(witness) === id, `${id} is in a hand`);
}

function held(witness) {
  return Object.values(witness.state.hands).find((hand) => hand.object !== null)?.object ?? null;
}

/** Drags what is held, in small steps as a hand does, by so many pixels. */
async function drag(page, witness, id, dx, dy) {
  const { x, y } = await pointOf(page, id);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 20 });
  await page.mouse.up();
}

export { assert, writeFileSync, join, test, smile, workplace, grasp, drag, held };
