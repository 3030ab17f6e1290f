// Brains that are started from the page.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, sceneFile } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const STUMBLES = `def step(sensor, motor, aux):
    if hasattr(aux, "has_stepped"):
        motor.jointVelocities = aux.nowhere
    print("steps once")
    aux.has_stepped = True
`;
const RESTS = `# smile: imitates
def step(sensor, motor, aux):
    aux.exit = True
`;
const TRIPS = `# smile: imitates
def init(aux):
    raise RuntimeError("no camera")
def step(sensor, motor, aux):
    pass
`;
const DAWDLES = `import time
def init(aux):
    time.sleep(1000)
def step(sensor, motor, aux):
    pass
`;

/** A block that begins above its place and falls there: then a task of its place is done by doing nothing. */
const FALLS = `<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="RedBlock" location="(0,-2,1.5)" color="red"/>
</tabletop>
`;

/** A folder with these brains. */
function brains(t, programs) {
  const folder = mkdtempSync(join(tmpdir(), "smile-brains-"));
  t.after(() => rmSync(folder, { recursive: true }));
  for (const [name, text] of Object.entries(programs)) writeFileSync(join(folder, `${name}.py`), text);
  return folder;
}

test("a brain runs; its error shows the line, and an imitation its score", async (t) => {
  const folder = brains(t, { stumbles: STUMBLES, rests: RESTS, trips: TRIPS });
  const scene = sceneFile(t, "falls", FALLS);
  const { page, witness, person } = await browser.workplace(t, { studio: [scene, "--brains", folder] });
  await person.showPanel("Brain");
  const program = page.getByRole("combobox", { name: "Brain" });
  await program.selectOption("stumbles.py");
  await person.press("Start");
  const log = page.getByRole("log", { name: "Console" });
  await log.getByText(/^steps once/).waitFor();
  await witness.until(() => witness.state.brain.status === "failed", "its failure");
  assert.equal(witness.state.brain.line, 3);
  await log.getByRole("button", { name: /stumbles\.py:3$/ }).first().waitFor();

  await person.showPanel("Hands");
  await person.press("Record");
  await person.grasp("RedBlock");
  await person.release();
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");
  await person.showPanel("Brain");
  // What does not read demonstrations is not offered for them.
  const imitator = page.getByRole("combobox", { name: "Imitating brain" });
  const offered = await imitator.getByRole("option").allTextContents();
  assert.deepEqual(offered, ["rests.py (python)", "trips.py (python)", "matlab/learner (octave)", "python/learner (python)"]);
  assert.equal(await imitator.inputValue(), "rests.py", "one's own comes first");
  await person.press("Imitate");
  const score = page.getByRole("status", { name: "Score" });
  await score.getByText("100 %").waitFor();
  await score.getByText("Everything is in its place.").waitFor();
  assert.equal(witness.state.brain.status, "exited");
  await person.showPanel("Library");
  await page.locator(".recording").getByText("falls, imitated").waitFor();

  // A program that fails has done nothing: the cause is reported.
  await person.showPanel("Brain");
  await imitator.selectOption("trips.py");
  await person.press("Imitate");
  await score.getByText(/^the brain failed: .*no camera/).waitFor();
  assert.doesNotMatch(await score.textContent(), /in its place/);
});

test("the shipped learner is chosen, begins, and is recorded", async (t) => {
  const { page, witness, person } = await browser.workplace(t);
  await person.showPanel("Hands");
  const isAt = (place) => {
    const at = witness.positionOf("RedBlock");
    return ["x", "y", "z"].every((axis, k) => !(Math.abs(place[axis] - at[k]) > 0.01));
  };
  const id = await person.record(async () => {
    await person.grasp("RedBlock");
    for (const place of [{ z: 3 }, { x: 2, y: -2 }, { z: 1 }]) {
      await person.typePlace(place);
      await witness.until(() => isAt(place), "it is where it was asked to be");
    }
    await person.release();
    // A block that still falls in the last picture of the recording would be taken for one in a container.
    await witness.until(() => witness.positionOf("RedBlock")[2] < 0.51, "it lies on the table");
    await witness.settled(() => (witness.state.still ? witness.positionOf("RedBlock") : null), "it rests", 300);
  });
  await person.showPanel("Brain");
  const imitator = page.getByRole("combobox", { name: "Imitating brain" });
  assert.equal(await imitator.inputValue(), "matlab/learner");
  const place = page.getByRole("combobox", { name: "Scene", exact: true });
  assert.equal(await place.locator("option:checked").textContent(), "where it was recorded: tower");
  await person.press("Imitate");
  await witness.until(() => witness.state.recording !== null, "the imitation is recorded");
  assert.notEqual(witness.state.recording.id, id);
  const hasBegun = await witness.within(60_000, () => witness.state.brain.status !== "starting");
  assert.ok(hasBegun && witness.state.brain.status === "running", JSON.stringify(witness.state.brain));
  assert.equal(witness.state.brain.name, "matlab/learner");
  await page.getByRole("status").getByText(/^matlab\/learner running$/).waitFor();
  await person.press("Stop");
  await page.getByRole("status", { name: "Score" }).waitFor();
  await witness.until(() => witness.state.recording === null, "the recording ends with the imitation");
  assert.equal(await page.getByRole("combobox", { name: "Demonstration" }).inputValue(), id, "not the imitation itself");
  await page.getByText("The whole recording: no hand acted").first().waitFor();
  assert.equal(await page.getByText("contains no action").count(), 0, "what a robot did is no action of a hand");
});

test("the studio does not wait for a brain that does not get ready", async (t) => {
  const folder = brains(t, { dawdles: DAWDLES });
  const { page, witness, person } = await browser.workplace(t, { studio: ["--brains", folder] });
  await person.showPanel("Brain");
  await page.getByRole("combobox", { name: "Brain" }).selectOption("dawdles.py");
  await person.press("Start");
  const status = page.getByRole("status");
  await status.getByText("starting…").waitFor();
  await person.grasp("RedBlock");
  assert.equal(witness.state.brain.status, "starting");
  await person.press("Stop");
  await status.getByText("stopped").waitFor();
});
