// In the middle of a recording that went wrong, the robot or a brain takes over.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** A small picture: the robot has many pieces, and a busy machine draws them slowly. */
const SMALL = { viewport: { width: 1000, height: 700 } };

/** Turns all joints for half a second, and is done. */
const NODS = `def step(sensor, motor, aux):
    aux.steps = getattr(aux, "steps", 0) + 1
    motor.arms[0].velocities[:] = 0.2
    print("nods")
    if aux.steps > 30:
        motor.arms[0].velocities[:] = 0
        aux.exit = True
`;

/** Records how the robot goes to a pose; then takes over in the middle of it. */
async function takeOver({ page, witness, person }) {
  await witness.until(() => witness.state.robot !== null, "a robot");
  await person.showPanel("Robot");
  const wrong = await person.record(async () => {
    await person.press("Go");
    await witness.until(() => witness.state.recording?.seconds >= 1, "a second of it");
  });
  await page.getByRole("slider", { name: "Moment" }).fill("0.5");
  await person.press("Correct");
  await page.getByText("when it resumes, you act").waitFor();
  await person.press("Resume", page.getByRole("main"));
  await witness.until(() => !witness.state.paused, "time goes on");
  return { wrong, right: witness.state.recording.id };
}

function hasCorrected(studio, { wrong, right }) {
  const report = replay(join(studio.recordings, right));
  assert.equal(report.identical, true, JSON.stringify(report));
  const { corrects } = JSON.parse(readFileSync(join(studio.recordings, right, "demo.json"), "utf8"));
  assert.equal(corrects.recording, wrong);
  assert.ok(Math.abs(corrects.seconds - 0.5) < 0.02, corrects.seconds);
}

test("the robot is jogged, takes a pose and opens its gripper in a correction", async (t) => {
  const place = await browser.workplace(t, { studio: ["--no-pictures", "--robot", "tern"], page: SMALL, likes: { detail: "low" } });
  const { page, studio, witness, person } = place;
  const takes = await takeOver(place);
  await person.showPanel("Robot");
  const joint = (name) => witness.state.robot.joints[name];
  const held = joint("wrist_turn");

  await page.getByRole("button", { name: "Hold to turn wrist_turn back" }).hover();
  await page.mouse.down();
  await witness.until(() => joint("wrist_turn") < held - 0.1, "it turns while the button is held");
  await page.mouse.up();
  await witness.settled(() => joint("wrist_turn"), "it stops", 300);

  const opening = witness.state.robot.grippers[0];
  await page.getByRole("button", { name: "Hold to close the arm gripper" }).hover();
  await page.mouse.down();
  await witness.until(() => witness.state.robot.grippers[0] < opening - 0.1, "the gripper closes");
  await page.mouse.up();

  await person.press("Go");
  await witness.until(() => witness.state.robot.following, "it goes to a pose");
  await person.press("Stop", page.getByRole("tabpanel", { name: "Robot" }));
  await witness.until(() => !witness.state.robot.following, "and stops on the way");
  await person.finish();
  hasCorrected(studio, takes);
});

test("after a nudge by a hand, a brain takes over in a correction", async (t) => {
  const folder = mkdtempSync(join(tmpdir(), "smile-brains-"));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(join(folder, "nods.py"), NODS);
  const place = await browser.workplace(t, {
    studio: ["--no-pictures", "--robot", "tern", "--brains", folder],
    page: SMALL,
    likes: { detail: "low" },
  });
  const { page, studio, witness, person } = place;
  const takes = await takeOver(place);
  const from = witness.positionOf("GreenBlock");
  await person.showPanel("Objects");
  await page.getByRole("option", { name: /GreenBlock/ }).dblclick();
  await witness.until(() => Object.values(witness.state.hands).some((hand) => hand.object === "GreenBlock"), "a hand has it");
  await person.showPanel("Hands");
  await person.press("Move right");
  const way = () => Math.hypot(...from.slice(0, 2).map((value, axis) => witness.positionOf("GreenBlock")[axis] - value));
  await witness.until(() => way() > 0.05, "it is elsewhere");
  await page.keyboard.press("Backspace");

  await person.showPanel("Brain");
  await page.getByRole("combobox", { name: "Brain", exact: true }).selectOption("nods.py");
  await person.press("Start");
  await page.getByRole("log", { name: "Console" }).getByText(/^nods/).first().waitFor();
  await witness.until(() => witness.state.brain.status === "exited", "the brain is done");
  assert.ok(witness.state.recording !== null, "the recording goes on");
  assert.equal(witness.state.recording.id, takes.right);
  await person.finish();
  hasCorrected(studio, takes);
});
