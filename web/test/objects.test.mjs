// Scenes that are uploaded, wrong ones too, objects that are added, and a robot that clears the table.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { Browser } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const WRONG = `<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="One" location="(0,0,0.5)"/>
  <block id="Two" location="(here)"/>
</tabletop>
`;
const RIGHT = WRONG.replace("(here)", "(3,0,0.5)");

test("a wrong scene changes nothing and shows where it is wrong; a right one is loaded", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  await page.locator("input[type=file]").setInputFiles({ name: "two.xml", mimeType: "text/xml", buffer: Buffer.from(WRONG) });
  const editor = page.getByRole("dialog", { name: "Scene editor" });
  await editor.getByRole("button", { name: /^Line 3 .*location/ }).click();
  assert.equal(await editor.locator(".editor-gutter .wrong").textContent(), "3");
  const selected = () => page.evaluate(() => document.activeElement.value.slice(document.activeElement.selectionStart, document.activeElement.selectionEnd));
  assert.equal(await selected(), WRONG.split("\n")[2], "a click on the error leads to its line");
  assert.ok(await person.button("Load this scene", editor).isDisabled());
  assert.equal(witness.scene.name, "tower", "the table stays as it is");

  await editor.getByRole("textbox", { name: "Scene text" }).fill(RIGHT);
  await editor.getByText("No errors").waitFor();
  await person.press("Load this scene", editor);
  await witness.until(() => witness.scene.name === "two", "the scene is there");
  assert.deepEqual(witness.ids, ["One", "Two"]);

  await page.getByRole("spinbutton", { name: "Seed" }).fill("7");
  const places = await spawn();
  await person.press("Reload");
  await witness.until(() => witness.ids.length === 2, "the scene as it was loaded");
  await page.getByRole("spinbutton", { name: "Seed" }).fill("7");
  assert.deepEqual(await spawn(), places, "the same seed, the same places");

  await person.press("Clear");
  await witness.until(() => witness.ids.length === 0, "an empty table");
  await person.press("Undo");
  await witness.until(() => witness.ids.length > 2, "all is back");
  await person.press("Undo");
  await witness.until(() => witness.ids.length === 2, "what was added is gone");
  await person.press("Undo");
  await witness.until(() => witness.ids.length > 2, "the scene as it was before it was loaded again");
  await person.press("Undo");
  await witness.until(() => witness.ids.length === 2, "without what was added");
  await person.press("Undo");
  await witness.until(() => witness.scene.name === "tower", "the scene that was left");

  async function spawn() {
    await person.press("Add");
    await witness.until(() => witness.ids.length > 2 && witness.ids.every((id) => witness.positionOf(id)[2] > 0), "new objects");
    return witness.ids.map((id) => witness.positionOf(id).slice(0, 2).map((value) => Math.round(10 * value) + 0)); // no -0
  }
});

test("the robot's rage leaves all as it was", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-pictures"] });
  await person.grasp("RedBlock");
  await person.dragTo("RedBlock", [null, null, 2]);
  await witness.until(() => Math.abs(witness.positionOf("RedBlock")[2] - 2) < 0.05, "it hangs there");
  const left = await witness.settled(tableNow, "it hangs still", 500);
  await page.getByRole("combobox", { name: "Simulation speed" }).selectOption("4");
  await person.press("Rage");
  await witness.until(() => witness.state.mode === "rage", "the rage");
  await page.getByText("The robot is clearing the table.").first().waitFor();
  await witness.until(() => !witness.isHeld("RedBlock") && witness.positionOf("RedBlock")[2] < 1, "nothing is held then");
  for (const name of ["Add", "Clear", "Rage", "Undo"]) assert.ok(await person.button(name).isDisabled(), name);
  await witness.until(() => witness.state.mode === "live", "the end of it");
  await witness.within(5000, () => isDeepStrictEqual(tableNow(), left));
  assert.deepEqual(tableNow(), left, "as it was left");
  await person.press("Undo");
  await witness.until(() => !witness.isHolding, "the grasp is undone");
  await witness.until(() => witness.state.allowed.commands.undo !== true, "and nothing else was done");

  function tableNow() {
    const places = witness.ids.map((id) => witness.positionOf(id).map((value) => value.toFixed(2)));
    const { hands, allowed: { commands }, robot } = witness.state;
    return { places, hands, commands, joints: robot.joints };
  }
});

test("what fell to the floor is not listed on the table", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  const list = page.getByRole("listbox", { name: /^Objects/ });
  const total = witness.ids.length;
  await person.grasp("RedBlock");
  await person.typePlace({ z: 3 });
  await person.typePlace({ x: 16 });
  await witness.until(() => witness.positionOf("RedBlock")[0] > 15, "it is beside the table");
  await person.release();
  await page.getByText(/^On the floor: RedBlock/).waitFor();
  assert.equal(await list.getByRole("option").count(), total - 1);
  await page.getByText(`${total - 1} objects`).waitFor();
  await person.press("Undo");
  await list.getByRole("option", { name: /RedBlock/ }).waitFor();
});
