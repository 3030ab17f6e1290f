// Things that slide on others, in the dock for disk drives.

import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const DOCK = new URL("../../scenes/dock.xml", import.meta.url).pathname;
/** The middle of the drawer's handle, and how far it is pulled toward the viewer [units]. */
const HANDLE = [-5.9, -1.05, 1.4];
const PULL = 1.5;

test("a drawer slides to the end of its rail, and no full hand takes another object", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [DOCK, "--no-pictures"] });
  const placement = page.getByRole("status", { name: "Placement of the object" });
  await witness.until(() => witness.state.still, "the drives stand");
  const [dockCase, drawer, bin] = ["DockCase", "DockDrawer", "Bin"].map((id) => witness.positionOf(id));
  const [from, to] = [HANDLE, [HANDLE[0], HANDLE[1] - PULL, HANDLE[2]]];

  // The scene's own view shows the front, which the robot sees; the mouse leaves the rail by far.
  const picked = await pointedAt(from);
  await person.pointer.press(picked);
  const target = await person.placeOnPage(to);
  await person.pointer.moveTo({ x: target.x, y: target.y });
  await witness.until(() => Math.abs(witness.positionOf("DockDrawer")[1] - (drawer[1] - PULL)) < 0.3, "the drawer is where the mouse is");
  await person.pointer.moveTo({ x: target.x - 60, y: target.y + 160 });
  await witness.until(() => witness.positionOf("DockDrawer")[1] < drawer[1] - 2.9, "the drawer is at its end");
  await person.pointer.lift();
  await witness.settled(() => witness.positionOf("DockDrawer"), "the drawer stays there", 300);
  const moved = Math.hypot(...witness.positionOf("DockCase").map((value, axis) => value - dockCase[axis]));
  assert.ok(moved < 0.02, `the case has moved by ${moved} units`);

  const box = await person.pointOf("Bin");
  await person.pointer.press(box);
  await person.pointer.moveTo({ x: box.x, y: box.y - 80 });
  await person.pointer.lift();
  await page.getByRole("alert").getByText("already holds 'DockDrawer'; release it first").waitFor();
  assert.deepEqual(witness.positionOf("Bin"), bin);

  await page.keyboard.press("Backspace");
  await person.grasp("Drive3");
  await placement.getByText("rests in DockDrawer", { exact: true }).waitFor();

  /** Where the mouse is over something that can be taken there: the page may just be turning to its first view. */
  async function pointedAt(place) {
    for (let k = 0; k < 50; ++k) {
      const at = await person.placeOnPage(place);
      await page.mouse.move(at.x + 1, at.y);
      await person.look();
      await page.mouse.move(at.x, at.y);
      await person.look();
      if (await page.evaluate(() => document.querySelector(".world").style.cursor === "pointer")) return at;
    }
    throw new Error("nothing to take is seen there");
  }
});

test("a drive that is stopped by the case says to open its drawer first", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [DOCK, "--no-pictures"] });
  const placement = page.getByRole("status", { name: "Placement of the object" });
  await witness.until(() => witness.state.still, "the drives stand");
  await page.getByRole("option", { name: /^Drive3/ }).dblclick();
  await page.getByText("In units of 100 mm").waitFor();
  assert.deepEqual(await page.locator(".nudge-step option").allTextContents(), ["10 mm", "100 mm"]);
  await person.typePlace({ z: 4 });
  await placement.getByText("stopped by DockCase: slide DockDrawer first", { exact: true }).waitFor();
  // The numbers are those of the drive, not of where its hand pulls, and so is what Lower does.
  const height = page.getByRole("spinbutton", { name: "z", exact: true });
  assert.ok(Math.abs(Number(await height.inputValue()) - witness.positionOf("Drive3")[2]) < 0.02, await height.inputValue());
  await placement.getByText(/^falls/).waitFor();
  await person.press("Lower");
  await placement.getByText(/^falls/).waitFor({ state: "detached" });
  await witness.until(() => Math.abs(witness.positionOf("Drive3")[2] - 1.3) < 0.05, "it is back in its slot");
});

test("what is turned beside a slot says by how much, and is straightened; the recording replays exactly", async (t) => {
  const { page, studio, witness, person } = await browser.workplace(t, { studio: [DOCK, "--no-pictures"] });
  const placement = page.getByRole("status", { name: "Placement of the object" });
  await witness.until(() => witness.state.still, "the drives stand");
  // The view with which the scene begins is one among the others, and shows the dock from its front.
  const isSeen = (isUpright) =>
    page.waitForFunction((isIt) => {
      const [low, high] = [0.5, 3].map((z) => window.smileStudio.screenPlaceOf([-5.9, -1.05, z]));
      return low.y - high.y > 40 === isIt;
    }, isUpright);
  await isSeen(true);
  await person.press("Top");
  await isSeen(false);
  await person.press("Scene");
  await isSeen(true);
  const recording = await person.record(async () => {
    await person.grasp("Spare");
    await person.typePlace({ z: 4, x: -4.5, y: -0.5 });
    await placement.getByText(/^turned 15° from \w+: Straighten aligns it$/).waitFor();
    await placement.getByText(/^falls \d+ mm: Lower it first$/).waitFor();
    await person.press("Straighten");
    await placement.getByText("turned").waitFor({ state: "detached" });
    await witness.until(() => witness.handOf("Spare").angles.every((angle) => Math.abs(angle) < 0.1), "it is straight");
    await person.typePlace({ x: 0, y: -2 });
    await placement.getByText("rests on the table", { exact: true }).waitFor();
    await placement.getByText(/^falls/).waitFor();
    await person.press("Lower");
    await placement.getByText(/^falls/).waitFor({ state: "detached" });
    await witness.until(() => Math.abs(witness.positionOf("Spare")[2] - 0.8) < 0.02, "it touches the table");
    assert.ok(witness.isHeld("Spare"));
    await person.release();
  });
  assert.equal(replay(join(studio.recordings, recording)).identical, true);
});
