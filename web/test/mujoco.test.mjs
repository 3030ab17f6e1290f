// The page on a MuJoCo model: a person stacks two boxes there with a real mouse, undoes and redoes a step, and the
// recording replays in MuJoCo. Skipped where tools/get_mujoco.sh could not install MuJoCo.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { hasMujoco, MujocoProgram } from "./mujoco_program.mjs";
import { Person } from "./person.mjs";
import { Browser, Witness } from "./workbench.mjs";

const MODEL = `<mujoco model="two boxes">
  <worldbody>
    <geom type="plane" size="2 2 .1"/>
    <body name="table" pos="0 0 .35"><geom type="box" size=".6 .4 .02"/></body>
    <body name="red" pos="-.15 0 .42"><freejoint/><geom type="box" size=".05 .05 .05" mass=".5" rgba=".8 .2 .1 1"/></body>
    <body name="blue" pos=".15 0 .42"><freejoint/><geom type="box" size=".05 .05 .05" mass=".2" rgba=".2 .3 .8 1"/></body>
  </worldbody>
</mujoco>`;

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

test("a person stacks two boxes of a MuJoCo model with the mouse", { skip: !hasMujoco }, async (t) => {
  const program = await MujocoProgram.start(t, MODEL);
  const witness = await Witness.of(program);
  const page = await browser.open(program);
  const person = new Person(page, witness);

  // What needs SMILE's own worlds is left out.
  await page.getByRole("tab", { name: "Hands" }).waitFor();
  for (const missing of ["Robot", "Brains", "Library"]) assert.equal(await page.getByRole("tab", { name: missing }).count(), 0);
  assert.deepEqual(witness.ids, ["red", "blue"]);

  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "the recording");
  const [x, y, z] = witness.positionOf("red");
  await person.grasp("blue");
  await person.carryOnto("blue", [x, y, z + 1.02]);
  await person.release();
  await witness.until(() => witness.state.still && Math.abs(witness.positionOf("blue")[2] - z - 1) < 0.05, "the stack");

  await person.press("Undo");
  await witness.until(() => witness.isHeld("blue"), "the hand before the release");
  await person.press("Redo");
  await witness.until(() => !witness.isHeld("blue"), "the release again");
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");

  const [recording, ...others] = program.recordings;
  assert.deepEqual(others, []);
  const { poses, done } = program.replay(recording);
  assert.ok(Math.abs(poses.blue[2] - poses.red[2] - 0.1) < 0.005, `blue stands on red: ${JSON.stringify(poses)}`);
  assert.equal(done[0], "grasp");
  assert.equal(done.at(-1), "release");
  assert.equal(done.filter((one) => one === "release").length, 1);
  assert.deepEqual(page.complaints, []);
});
