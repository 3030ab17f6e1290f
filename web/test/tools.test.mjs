// Tools in a hand: the page shows when one is in place, and what it can do there.

import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const SCISSORS = new URL("../../scenes/scissors.xml", import.meta.url).pathname;
/** From the middle of the scissors to that of their blades [units]. */
const TO_BLADES = 2.2;
const HEIGHT = 3.5; // of the string, between its post and the weight
const IN_PLACE = [-0.2, 0.8, HEIGHT];

test("a mark and a text show what scissors can cut, while the string is between their blades", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [SCISSORS, "--no-robot", "--no-pictures"] });
  const hint = page.getByRole("status", { name: "Tool in place" });
  const mark = () => page.evaluate(() => window.smileStudio.toolMarkPlace());
  await witness.until(() => witness.state.still, "the string has come to rest");
  await person.grasp("Scissors");
  await person.typePlace({ x: -0.2, y: -0.6, z: HEIGHT });
  await witness.until(() => witness.positionOf("Scissors")[0] < -0.1, "the scissors are in front of the string");
  await isLedToTheString();
  await witness.settled(() => witness.positionOf("Scissors"), "they hang there", 300);
  await person.look();
  await isMarked("before they are in place");
  await person.press("Use Scissors");
  await page.getByRole("alert").getByText(/the blades of 'Scissors' are [\d.]+ units beside String/).waitFor();

  await person.carryAbove("Scissors", IN_PLACE);
  await hint.getByText(/^Scissors can cut String between link \d+ and \d+$/).waitFor();
  await hint.getByText("Press Cut with Scissors, or right-click the tool").waitFor();
  await witness.settled(() => witness.positionOf("Scissors"), "the scissors hang there", 300);
  await person.look();
  await isMarked("in place");

  await person.carryAbove("Scissors", [-0.2, -0.6, HEIGHT]);
  await isLedToTheString();
  await person.carryAbove("Scissors", IN_PLACE);
  await hint.getByText("Scissors can cut").waitFor();
  const menu = await person.menuAt(witness.positionOf("Scissors"));
  await person.entry("Cut with Scissors", menu).waitFor();
  await page.keyboard.press("Escape");
  await person.press("Cut with Scissors");
  await witness.until(() => witness.events.some(({ kind, state }) => kind === "used" && state === "cut"), "the string is cut");
  await page.getByText(/^Cut with Scissors: String between link/).waitFor();

  async function isLedToTheString() {
    await hint.getByText("can").waitFor({ state: "detached" });
    await hint.getByText(/^[←-↙] \d+ mm to String between link \d+ and \d+$/).waitFor();
  }

  async function isMarked(when) {
    const [[x, y, z], shown] = [witness.positionOf("Scissors"), await mark()];
    const error = Math.hypot(...[x, y + TO_BLADES, z].map((value, axis) => value - shown[axis]));
    assert.ok(error < 0.1, `${when}, the mark is ${error} units from the blades`);
  }
});

test("scissors are brought to the string past its posts, and the string stays where it hangs", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [SCISSORS, "--no-robot", "--no-pictures"] });
  const hint = page.getByRole("status", { name: "Tool in place" });
  await witness.until(() => witness.state.still, "the string has come to rest");
  const weight = witness.positionOf("Weight");
  await person.grasp("Scissors");
  await hint.getByText("Press Bring into place, or drag it there").waitFor();
  await person.press("Bring into place");
  await hint.getByText(/^Scissors can cut String between link \d+ and \d+$/).waitFor();
  const moved = Math.hypot(...witness.positionOf("Weight").map((value, axis) => value - weight[axis]));
  assert.ok(moved < 0.05, `the weight has moved by ${moved} units`);
  await page.getByRole("button", { name: "Bring into place" }).waitFor({ state: "detached" });
  await person.press("Cut with Scissors");
  await witness.until(() => witness.positionOf("Weight")[2] < weight[2] - 0.5, "the weight falls");
});

test("a notice names what pressed a switch", async (t) => {
  const folder = await mkdtemp(join(tmpdir(), "smile-press-"));
  t.after(() => rm(folder, { recursive: true }));
  const scene = join(folder, "panel.xml");
  await writeFile(
    scene,
    `<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
      <composite id="Panel" location="(0,-2,0.5)" mass="2"><block location="(0,0,0)" xspan="3" yspan="2" zspan="1"/>
        <toggleSwitch id="Power" location="(0,0,0.5)" xspan="2" yspan="1.2" zspan="0.35" angle="16"/></composite>
      <block id="Weight" location="(3,-2,0.3)" xspan="0.6" yspan="0.6" zspan="0.6"/></tabletop>`,
  );
  const { page, witness, person } = await browser.workplace(t, { studio: [scene, "--no-robot", "--no-pictures"] });
  await person.grasp("Weight");
  await person.typePlace({ x: 3, y: -2, z: 2.5 });
  await person.typePlace({ x: 0.6, y: -2, z: 2.5 });
  await witness.until(() => witness.positionOf("Weight")[0] < 0.7, "the weight is above the switch");
  await person.typePlace({ x: 0.6, y: -2, z: 1.2 });
  await page.getByText("Power pressed by Weight", { exact: true }).first().waitFor();
});
