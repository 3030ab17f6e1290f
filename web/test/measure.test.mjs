// Distances and angles that are measured in the world.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Browser } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

test("clicked points and origins of objects are measured, and nothing is taken", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  const click = async (point, [right, down] = [0, 0]) => {
    const { x, y } = await page.evaluate((place) => window.smileStudio.screenPlaceOf(place), point);
    await page.mouse.click(x + right, y + down);
  };
  const panel = page.getByRole("region", { name: "Measure" });
  await page.keyboard.press("m");
  await panel.getByText(/^Click two points/).waitFor();
  await click([-6, -4, 0]);
  await click([-6, -1, 0]);
  const length = /^AB: (\d\.\d\d) units \((\d+) mm\); along x, y, z: (.*)$/;
  const [, units, millimeters] = length.exec(await panel.getByText(length).textContent());
  assert.ok(Math.abs(units - 3) < 0.1, `${units} units`);
  assert.ok(Math.abs(millimeters - 100 * units) < 1, "a unit is 100 mm");
  await click([-8, -1, 0]);
  const angle = /^Angle at B: ([\d.]+)°$/;
  assert.ok(Math.abs(angle.exec(await panel.getByText(angle).textContent())[1] - 90) < 3);

  // Near a corner, also beside the block, the corner is meant; near the middle of an edge, the edge.
  await person.press("Begin again", panel);
  const [x, y, z] = witness.positionOf("RedBlock").map((value, axis) => value + [0, -0.5, 0.5][axis]);
  await click([x - 0.5, y, z], [-3, -4]);
  await click([x + 0.5, y, z], [-4, 3]);
  await panel.getByText("A: corner of RedBlock", { exact: true }).waitFor();
  await panel.getByText("B: corner of RedBlock", { exact: true }).waitFor();
  const ofEdge = await panel.getByText(length).textContent();
  assert.match(ofEdge, /^AB: 1.00 units \(100 mm\); along x, y, z: 1.00, 0.00, 0.00$/);
  await click([x, y, z], [0, 5]);
  await panel.getByText("C: edge of RedBlock", { exact: true }).waitFor();
  await panel.getByText("Angle at B: 0.0°").waitFor();

  // With the keyboard: the origins of objects, which one chooses in the list.
  await person.press("Begin again", panel);
  const list = page.getByRole("listbox", { name: /^Objects/ });
  for (const id of ["RedBlock", "GreenBlock"]) {
    await list.getByRole("option", { name: new RegExp(id) }).click();
    await person.press(`Add the origin of ${id}`, panel);
  }
  const [red, green] = ["RedBlock", "GreenBlock"].map((id) => witness.positionOf(id));
  const expected = Math.hypot(...red.map((value, axis) => green[axis] - value)).toFixed(2);
  await panel.getByText(`AB: ${expected} units`).waitFor();
  assert.ok(Object.values(witness.state.hands).every(({ object }) => object === null), "no hand took anything");

  await page.keyboard.press("m");
  await panel.waitFor({ state: "detached" });
  await person.grasp("RedBlock");
});
