// What hands can do beside carrying: two of them, the menu, destroying, snapping; and what they may not.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, SIDE_BY_SIDE, replay, sceneFile } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const BARE = ["--no-robot", "--no-pictures"];
/** The page asks where an object would come to rest every 300 ms, until it is at rest itself. */
const GHOST_MS = 800;
const shipped = (name) => new URL(`../../scenes/${name}.xml`, import.meta.url).pathname;

test("each hand holds its own, and takes what the other holds", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: BARE });
  const held = (hand) => witness.state.hands[hand].object;
  await page.keyboard.press("e");
  await person.grasp("RedBlock", "left");
  await person.dragTo("RedBlock", [null, null, 2]);
  await page.keyboard.press("e");
  await person.grasp("GreenBlock", "right");
  await witness.until(() => held("left") === "RedBlock" && held("right") === "GreenBlock", "both hands hold");
  await page.getByRole("radio", { name: /Left.*RedBlock/ }).waitFor();
  await page.getByRole("radio", { name: /Right.*GreenBlock/, checked: true }).waitFor();
  // There is no free hand any more, which the page says before one tries.
  await page.getByRole("radio", { name: /^Any/ }).check();
  await page.getByText("Both hands are full.").waitFor();
  await page.getByRole("radio", { name: /^Right/ }).check();

  // A full hand takes nothing more: a click on what the other one holds changes to that hand.
  await person.click(await person.pointOf("RedBlock"));
  await page.getByRole("radio", { name: /Left.*RedBlock/, checked: true }).waitFor();
  assert.equal(held("right"), "GreenBlock", "it still holds");
  await page.keyboard.press("e");

  await page.keyboard.press("Backspace");
  await witness.until(() => held("right") === null, "the right hand is empty");
  assert.equal(held("left"), "RedBlock", "the left one still holds");
  await person.grasp("RedBlock", "right");
  assert.equal(held("left"), null, "handed over");
  assert.ok(witness.positionOf("RedBlock")[2] > 1.9, "it was not dropped");
});

test("from above, what is held high is drawn over the place that it is above, until the view is turned", async (t) => {
  const { page, person } = await browser.workplace(t, { studio: BARE });
  const shift = async () => {
    const [low, high] = await Promise.all([0, 5].map((z) => person.placeOnPage([6, 3, z])));
    return Math.hypot(high.x - low.x, high.y - low.y);
  };
  const until = (isIt) => page.waitForFunction(isIt);
  await person.press("Top");
  await until(() => {
    const [low, high] = [0, 5].map((z) => window.smileStudio.screenPlaceOf([6, 3, z]));
    return Math.hypot(high.x - low.x, high.y - low.y) < 10;
  });
  const { x, y } = await person.placeOnPage([0, 0, 0]);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -200);
  await person.look();
  assert.ok((await shift()) < 15, "nearer, it is still a map");
  await page.mouse.down({ button: "right" });
  await page.mouse.move(x + 30, y - 60, { steps: 3 });
  await page.mouse.up({ button: "right" });
  await until(() => {
    const [low, high] = [0, 5].map((z) => window.smileStudio.screenPlaceOf([6, 3, z]));
    return Math.hypot(high.x - low.x, high.y - low.y) > 40;
  });
});

test("one hand is recorded while the other one acts as it was recorded", async (t) => {
  const { page, studio, witness, person } = await browser.workplace(t, { studio: BARE });
  const held = (hand) => witness.state.hands[hand].object;
  await page.keyboard.press("e");
  await person.press("Record");
  await person.grasp("RedBlock", "left");
  await person.dragTo("RedBlock", [null, null, 3]);
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");

  await person.press("Record over…");
  await page.getByRole("menuitem", { name: "Keep what the left hand does" }).click();
  await page.getByText("When it resumes, the left hand acts as recorded").waitFor();
  const { id } = witness.state.recording;
  assert.equal(held("left"), null, "back at the beginning");
  await page.keyboard.press("e");
  await person.grasp("GreenBlock", "right");
  await page.keyboard.press(" ");
  await witness.until(() => held("left") === "RedBlock" && held("right") === "GreenBlock", "both hands hold");
  await witness.until(() => witness.positionOf("RedBlock")[2] > 2.5, "and the left one carries");
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");
  const tracks = page.getByRole("list", { name: "What each hand held" });
  await tracks.locator(".clip").nth(1).waitFor();
  assert.deepEqual(await tracks.locator(".clip").allTextContents(), ["Left: RedBlock", "Right: GreenBlock"]);
  const report = replay(join(studio.recordings, id));
  assert.equal(report.identical, true, JSON.stringify(report));

  // What one hand did is shifted: the page says what comes of it, and the other hand's row stays.
  const begins = () => tracks.locator(".clip").evaluateAll((clips) => clips.map((clip) => clip.style.left));
  const before = await begins();
  await page.getByRole("button", { name: /left hand takes RedBlock/ }).click();
  await person.press("Shift");
  const dialog = page.getByRole("dialog", { name: "Shift “left hand takes RedBlock”" });
  await dialog.getByRole("slider", { name: "Later by (s)" }).fill("-4");
  await dialog.getByText(/it is shifted by -4 s, expected -?[\d.]+ to/).waitFor();
  await dialog.getByRole("slider", { name: "Later by (s)" }).fill("0.25");
  await dialog.getByRole("status").getByText(/ends|lasts/i).first().waitFor();
  await dialog.getByRole("textbox").last().fill("Later");
  await person.press("Save as a new recording", dialog);
  await dialog.waitFor({ state: "detached" });
  await page.locator(".timeline-name", { hasText: "Later" }).waitFor();
  assert.notEqual((await begins())[0], before[0], "the clip is elsewhere");
});

test("clips are shifted and stretched with mouse and keys, and show where hands conflict", async (t) => {
  const { page, studio, witness, person } = await browser.workplace(t, { studio: BARE });
  await person.press("Record");
  await page.keyboard.press("e");
  await person.grasp("RedBlock", "left");
  await person.dragTo("RedBlock", [null, null, 2]);
  await page.keyboard.press("Backspace");
  await page.keyboard.press("e");
  await witness.until(() => witness.state.hands.left.object === null && witness.state.still, "the block lies");
  await person.grasp("RedBlock", "right");
  await person.dragTo("RedBlock", [null, null, 3]);
  await page.keyboard.press("Backspace");
  await witness.until(() => witness.state.hands.right.object === null && witness.state.still, "it lies again");
  const { x, y } = await page.getByRole("button", { name: /right hand takes RedBlock/ }).boundingBox();
  await page.mouse.click(x + 40, y + 20);
  await page.getByText("Finish the recording first; then its segments can be deleted or changed.").waitFor();
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");

  const tracks = page.getByRole("list", { name: "What each hand held" });
  const whole = tracks.getByRole("slider", { name: "Right: RedBlock", exact: true });
  const end = tracks.getByRole("slider", { name: "End of Right: RedBlock" });
  const effect = page.getByRole("region", { name: "Result" });
  const beginOf = async (slider) => Number(await slider.getAttribute("aria-valuenow"));
  await whole.waitFor();
  const begin = await beginOf(whole);

  // By keys: a little later, it still ends the same.
  await whole.focus();
  await page.keyboard.press("ArrowRight");
  await effect.getByText("The final state is unchanged.").waitFor();
  assert.ok(Math.abs((await beginOf(whole)) - begin - 0.1) < 0.02, "a tenth of a second later");
  await end.focus();
  const before = await beginOf(end);
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs((await beginOf(end)) - before - 0.1) < 0.02, "it takes a little longer");
  await person.press("Discard", effect);
  await effect.waitFor({ state: "detached" });
  assert.equal(await beginOf(whole), begin);

  // By mouse, to where the other hand still holds it.
  const box = await whole.boundingBox();
  const left = await tracks.getByRole("slider", { name: "Left: RedBlock", exact: true }).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - (box.x - left.x - left.width / 2), box.y + 4, { steps: 5 });
  await page.mouse.up();
  await effect.getByText(/One command can no longer be carried out/).first().waitFor();
  const reason = /^At \d+\.\d s: takes RedBlock from the left hand, which holds it now$/;
  const mark = tracks.getByRole("img", { name: reason });
  await mark.waitFor();
  await mark.focus();
  await page.locator(".conflict-reason").filter({ hasText: reason }).waitFor({ state: "visible" });
  await person.press("Save as a new recording", effect);
  await page.locator(".timeline-name", { hasText: "edited" }).waitFor();
  await person.showPanel("Brain");
  const toImitate = page.getByRole("combobox", { name: "Demonstration" }).locator("option:checked");
  assert.match(await toImitate.textContent(), /edited$/, "what was made last is to be imitated");
  await person.showPanel("Hands");
  await tracks.getByRole("img", { name: /holds it now\. The recording is complete; this is only a note\.$/ }).waitFor();
  const { recording } = witness.state.playback;
  assert.equal(replay(join(studio.recordings, recording)).identical, true);
  const kept = JSON.parse(readFileSync(join(studio.recordings, recording, "conflicts.json"), "utf8"));
  assert.equal(kept.conflicts[0].hand, "right");
});

test("a recording is corrected from the moment at which it went wrong", async (t) => {
  const { page, studio, witness, person } = await browser.workplace(t, { studio: BARE });
  const held = (hand) => witness.state.hands[hand].object;
  await page.keyboard.press("e");
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  const wrong = witness.state.recording.id;
  await person.grasp("RedBlock", "left");
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");

  await page.getByRole("slider", { name: "Moment" }).fill("0");
  await person.press("Correct");
  await page.getByText("when it resumes, you act").waitFor();
  await page.getByText(/^Corrects .* from 0.0\ss$/).first().waitFor();
  const { id } = witness.state.recording;
  assert.equal(held("left"), null, "back before it went wrong");
  await page.keyboard.press(" ");
  await person.grasp("GreenBlock", "left");
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");
  assert.equal(replay(join(studio.recordings, id)).identical, true);
  const { corrects } = JSON.parse(readFileSync(join(studio.recordings, id, "demo.json"), "utf8"));
  assert.deepEqual(corrects, { recording: wrong, seconds: 0 });

  await person.showPanel("Library");
  const cards = page.getByRole("list").locator(".recording");
  await cards.nth(1).getByText(/^Corrects .* from 0.0\ss$/).waitFor();
});

test("buttons and keys move things the way they say, as one sees it", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-pictures"] });
  await person.grasp("RedBlock");
  await person.dragTo("RedBlock", [null, null, 3]);
  let place = await person.restOf("RedBlock");
  for (const view of ["Front", "Robot", "Left", "Right", "Top"]) {
    await person.press(view);
    await person.look();
    // To and fro, so that it ends where it began.
    const ways = [["x", 1], ["x", -1], ["y", 1], ["y", -1]];
    for (const [k, button] of ["Move right", "Move left", "Move nearer", "Move away"].entries()) {
      await goes(button, ways[k], () => person.press(button));
    }
    for (const [k, key] of ["l", "j", "o", "u"].entries()) await goes(key, ways[k], () => page.keyboard.press(key));

    async function goes(name, [axis, way], action) {
      const moved = await wayOf(action);
      assert.ok(way * moved[axis] > 0, `${view}: ${name} goes ${JSON.stringify(moved)}`);
    }
  }

  /** How far something that is done moves the block in the picture [px]. */
  async function wayOf(action) {
    const before = place;
    await action();
    place = await person.restOf("RedBlock");
    const [from, to] = await Promise.all([person.placeOnPage(before), person.placeOnPage(place)]);
    return { x: to.x - from.x, y: to.y - from.y };
  }
});

test("the ghost shows where a thing comes to rest", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [shipped("lidbox"), ...BARE] });
  await person.grasp("Lemon");
  await person.typePlace({ z: 6 });
  for (const [x, y] of [[3.4, -0.9], [5.5, -2.5]]) {
    await person.typePlace({ x, y });
    await person.typePlace({ z: 3.6 });
    await witness.until(() => witness.positionOf("Lemon")[2] < 3.65, "it hangs there");
    const shown = await page.evaluate(settledGhost, GHOST_MS);
    await person.release();
    const rest = await witness.settled(() => (witness.state.still ? witness.positionOf("Lemon") : null), "it rests", 300);
    const error = Math.hypot(...rest.map((value, axis) => value - shown[axis]));
    assert.ok(error < 0.03, `it is ${error} units off`);
    await person.press("Undo");
    await witness.until(() => witness.isHeld("Lemon"), "it is held again");
    await person.typePlace({ z: 6 });
  }

  /** Where the ghost is, once it stays there for this time. */
  async function settledGhost(milliseconds) {
    let [before, since] = [null, 0];
    while (before === null || performance.now() - since < milliseconds) {
      await new Promise(requestAnimationFrame);
      const now = window.smileStudio.ghostPlace();
      if (`${now}` !== `${before}`) [before, since] = [now, performance.now()];
    }
    return before;
  }
});

test("a right click triggers and points; an impossible action is gray and shows the reason", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [shipped("dock"), ...BARE] });
  const [raised, lamp, wall] = [[-4.87, -0.05, 1.1], [-4.9, 0.6, 0.98], [-5.9, 4, 2.9]];
  const switches = () => [1, 2, 3, 4].map((number) => witness.state.controls[`DockSwitch${number}`]);
  await person.press("Top");
  await isRefused("Press or switch", lamp, "follows other controls and cannot be triggered");
  await isRefused("Press or switch", wall, "It is not part of a control");

  await choose("Press or switch", raised);
  await witness.until(() => switches()[2] === "1", "the third switch is over");
  assert.deepEqual(switches(), ["0", "0", "1", "0"], "and no other");
  assert.equal(witness.state.controls.DockLight3, "off");
  // The button that is down now stands for the other one, too. A plain click on it opens the menu as well.
  await person.click(await person.placeOnPage(raised));
  const menu = await person.openMenu();
  assert.deepEqual(await menu.getByRole("menuitem").allTextContents().then((all) => all.slice(0, 2)), ["Press or switch", "Take it"]);
  await person.entry("Press or switch", menu).click();
  await witness.until(() => switches()[2] === "0", "the third switch is back");
  await choose("Point to", raised);
  await witness.until(() => witness.events.some(({ kind, part }) => kind === "pointed" && part === "DockPanel3"), "it is pointed at");

  await person.grasp("Spare");
  await isRefused("Point to", raised, "it must be empty to point");
  assert.ok(witness.isHeld("Spare"), "a menu releases nothing");
  assert.equal(witness.events.filter(({ kind }) => kind === "pointed" || kind === "triggered").length, 3);

  async function choose(name, place) {
    const menu = await person.menuAt(place);
    await person.entry(name, menu).click();
    await menu.waitFor({ state: "detached" });
  }

  async function isRefused(name, place, reason) {
    const menu = await person.menuAt(place);
    const entry = person.entry(name, menu);
    assert.equal(await entry.getAttribute("aria-disabled"), "true", `${name} is gray`);
    await entry.getByText(reason).waitFor();
    await entry.click({ force: true });
    await page.keyboard.press("Escape");
    await menu.waitFor({ state: "detached" });
  }
});

test("screws are fastened and loosened, nuts are not", async (t) => {
  const { witness, person } = await browser.workplace(t, { studio: [shipped("screws"), ...BARE] });
  const height = () => witness.positionOf("BrassScrew")[2];
  const inNut = height();
  await choose("Fasten", ...headOfScrew());
  await witness.until(() => Math.abs(height() - inNut + 0.4) < 0.02, "it is a third deeper");
  await choose("Loosen", ...headOfScrew());
  await witness.until(() => Math.abs(height() - inNut) < 0.02, "and out again");
  const turns = witness.events.filter(({ guest }) => guest === "BrassScrewTip");
  assert.deepEqual(turns.map(({ kind, tightness }) => [kind, tightness]), [["fastened", 2], ["loosened", 1]]);

  const menu = await person.menuAt([-4.5, -2.9, 1.2]);
  assert.equal(await menu.getAttribute("aria-label"), "Actions for Nut");
  const reasons = { Fasten: "has nothing to fasten it by", Loosen: "is not fastened there" };
  for (const [name, reason] of Object.entries(reasons)) {
    const entry = person.entry(name, menu);
    assert.equal(await entry.getAttribute("aria-disabled"), "true", name);
    await entry.getByText(reason).waitFor();
  }

  function headOfScrew() {
    const [x, y, z] = witness.positionOf("BrassScrew");
    return [x, y, z + 1];
  }

  async function choose(name, ...place) {
    const open = await person.menuAt(place);
    await person.entry(name, open).click();
    await open.waitFor({ state: "detached" });
  }
});

test("relevant properties are marked; Undo returns a destroyed object to the hand", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: BARE });
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  await person.grasp("RedBlock");
  const chips = page.getByRole("group", { name: "Relevant properties" });
  for (const property of ["color", "position"]) {
    await person.press(property, chips);
    await witness.until(() => witness.state.attention.RedBlock?.includes(property), `${property} matters`);
  }
  await chips.getByRole("button", { name: "color", pressed: true }).click();
  await witness.until(() => `${witness.state.attention.RedBlock}` === "position", "only one of them does");

  await person.press("Destroy");
  await witness.until(() => witness.state.gone.includes("RedBlock"), "it is gone");
  assert.ok(!witness.isHolding);
  await page.waitForFunction(() => window.smileStudio.screenPointOf("RedBlock") === null);
  await person.press("Undo");
  await witness.until(() => witness.state.gone.length === 0 && witness.isHeld("RedBlock"), "it is in the hand again");
  assert.deepEqual(witness.state.attention, { RedBlock: ["position"] });
  await page.waitForFunction(() => window.smileStudio.screenPointOf("RedBlock") !== null);
});

test("a drag ends flush with a face where faces are snapped to; Escape ends the drag", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: [sceneFile(t, "pair", SIDE_BY_SIDE), ...BARE] });
  const gap = () => witness.positionOf("Coming")[0] - witness.positionOf("Resting")[0] - 1;
  const placement = page.getByRole("status", { name: "Placement of the object" });
  await person.grasp("Coming");
  await turnPlaneTo(0);
  for (const target of ["Faces", "Edges"]) await person.press(target);
  await witness.until(() => witness.state.snap.join() === "rails", "sides are not snapped to");
  await person.dragTo("Coming", [null, null, 0.85]);
  await person.dragTo("Coming", [-0.4, null, null]);
  await dragAwayAndBack();
  assert.ok(gap() > 0.04, `it is where the mouse let it: ${gap()}`);
  await placement.getByText("rests on the table", { exact: true }).waitFor();
  assert.equal(await placement.getByText("touches").count(), 0);
  const missing = placement.getByText(/^[←-↙] \d+ mm to touch Resting$/);
  await missing.waitFor();
  // The arrow turns with the camera, without anything else moving.
  const [arrow] = await missing.textContent();
  await person.press("Front");
  await page.waitForFunction((old) => !document.querySelector(".placement-label").textContent.includes(old), arrow);
  await person.press("Robot");
  await placement.getByText(arrow).waitFor();

  await person.press("Faces");
  await witness.until(() => witness.state.snap.includes("faces"), "faces are snapped to");
  await dragAwayAndBack();
  assert.ok(Math.abs(gap()) < 0.02, `it is flush: ${gap()}`);
  await placement.getByText("touches Resting", { exact: true }).waitFor();

  // The mouse releases what it drags; the hand does not.
  const { x, y } = await person.take("Coming");
  await page.mouse.move(x + 60, y - 60, { steps: 4 });
  await witness.until(() => witness.handOf("Coming").place[2] > 1, "it is dragged");
  const place = await person.restOf("Coming");
  await page.keyboard.press("Escape");
  await page.mouse.move(x + 120, y - 120, { steps: 4 });
  await page.mouse.up();
  await person.look();
  assert.deepEqual(await person.restOf("Coming"), place, "it stays where it was");
  assert.ok(witness.isHeld("Coming"));
  await placement.getByText("touches").waitFor({ state: "detached" });

  // The text stays after the release.
  await person.release();
  await witness.until(() => witness.state.still, "it is at rest");
  await placement.getByText(/^falls/).waitFor({ state: "detached" });
  assert.deepEqual(await placement.locator("span").allTextContents(), ["rests on the table"]);

  async function turnPlaneTo(degrees) {
    const field = page.getByRole("spinbutton", { name: "Plane angle" });
    await field.fill(`${degrees}`);
    await field.press("Enter");
    await witness.until(() => Math.abs(witness.handOf("Coming").plane - degrees) < 1e-6, "the plane is turned");
  }

  /** The mouse ends where it began. */
  async function dragAwayAndBack() {
    const way = () => Math.abs(witness.handOf("Coming").place[0] + 0.4);
    const at = await person.take("Coming");
    await page.mouse.move(at.x + 80, at.y, { steps: 4 });
    await witness.until(() => way() > 0.3, "it moves");
    await page.mouse.move(at.x, at.y, { steps: 4 });
    await witness.until(() => way() < 0.2, "it comes back");
    const [x] = await person.restOf("Coming");
    await page.mouse.up();
    await witness.until(() => Math.abs(witness.positionOf("Coming")[0] - x) < 0.01, "it is there");
  }
});

test("no scene is loaded while recording: buttons are gray and show the reason, and edited text is kept", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: BARE });
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  await person.grasp("RedBlock");
  const why = "a recording is in progress; finish it first";
  for (const name of ["Rage", "Reload"]) await isGray(person.button(name));
  const gallery = page.getByRole("list", { name: "Scenes" });
  await gallery.getByRole("button", { disabled: true }).first().waitFor();
  assert.equal(await gallery.getByRole("button", { disabled: false }).count(), 0);
  assert.equal(await gallery.getAttribute("title"), why);

  await page.locator("input[type=file]").setInputFiles({ name: "pair.xml", mimeType: "text/xml", buffer: Buffer.from(SIDE_BY_SIDE) });
  const editor = page.getByRole("dialog", { name: "Scene editor" });
  await editor.getByText("No errors").waitFor();
  await isGray(person.button("Load this scene", editor));
  await editor.getByRole("textbox", { name: "Scene text" }).fill(SIDE_BY_SIDE.replace("Coming", "Late"));
  await person.press("Continue later", editor);
  assert.equal(witness.scene.name, "tower");
  assert.ok(witness.state.recording !== null && witness.isHeld("RedBlock"), "nothing was lost");

  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "the end of the recording");
  await person.press("Continue editing “pair”");
  await person.press("Load this scene", editor);
  await witness.until(() => witness.scene.name === "pair", "the scene is there");
  assert.deepEqual(witness.ids, ["Resting", "Late"]);

  async function isGray(button) {
    assert.ok(await button.isDisabled());
    assert.equal(await button.getAttribute("title"), why);
  }
});
