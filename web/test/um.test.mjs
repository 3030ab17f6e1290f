// The demonstration that the robot is to imitate, made at the page with a real mouse.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { buildLetters, ORDER, SHIFT } from "./letters.mjs";
import { Browser, programSays, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const shipped = (path) => new URL(`../../${path}`, import.meta.url).pathname;
const SCENE = shipped("scenes/um.xml");
const CLOSE = 0.1; // 10 mm [units]
const UPRIGHT = 2; // [degrees]

test("the letters U and M are built of twelve objects, and recorded as what examples/um.jsonl shows", async (t) => {
  const { studio, person } = await browser.workplace(t, { studio: [SCENE] });
  await person.press("Hide the robot’s view"); // the short plank lies behind it
  const id = await person.record(() => buildLetters(person));

  const demonstration = join(studio.recordings, id);
  const report = replay(demonstration);
  assert.equal(report.identical, true, JSON.stringify(report));

  const example = join(studio.folder, "example");
  programSays(["run", SCENE, "--commands", shipped("examples/um.jsonl"), "--no-robot", "--record", example]);
  const [shown, wanted] = [demonstration, example].map((folder) => programSays(["describe", folder]));
  assert.deepEqual(shown.order, ORDER);
  assert.deepEqual(shown.relations, wanted.relations);
  assert.deepEqual(shown.effects, []);
  assert.deepEqual(Object.keys(shown.objects), Object.keys(wanted.objects));
  for (const [object, { position, rotation }] of Object.entries(shown.objects)) {
    const away = position.map((value, axis) => value - wanted.objects[object].position[axis] - SHIFT[axis]);
    assert.ok(Math.hypot(...away) < CLOSE, `${object} is ${away} units from where the example has it`);
    assert.ok(Math.hypot(...rotation) < UPRIGHT, `${object} is turned by ${rotation} degrees`);
  }
});
