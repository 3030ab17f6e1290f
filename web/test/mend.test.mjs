// What a recording can become: continued from any moment, also of an abandoned branch; trimmed and
// cut; and looked at, while the table waits.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { Person } from "./person.mjs";
import { Browser, programSays, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const PLAIN = { studio: ["--no-robot", "--no-pictures"] };
const MILLIMETERS_PER_UNIT = 100;

test("a recording continues from any moment, also of an abandoned branch", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, PLAIN);
  const { timeline } = person;
  const moment = timeline.getByRole("slider", { name: "Moment" });
  const id = await recordFall(person, witness);
  const [, taking] = await segments();
  await person.press("Close this recording", timeline);
  await person.showPanel("Library");
  await person.press("Open", page.locator(".recording"));

  // Where a segment ends, the next action is not done yet.
  await person.segments.nth(1).click();
  await witness.until(() => witness.state.mode === "playback", "the end of the first action");
  await goOn(() => person.press("Continue from here", timeline));
  assert.ok(witness.isHeld("RedBlock"), "it is not released yet");
  await person.finish();
  assert.deepEqual(await undone(), [false, false, true]);

  // In its middle; and now something else is done.
  await person.slideTo(moment, (taking.begin + taking.end) / 2);
  await goOn(() => person.press("Continue from here", timeline));
  assert.ok(witness.isHeld("RedBlock"), "as it was then");
  await person.release();
  await person.finish();
  assert.deepEqual(await undone(), [false, false, true, false]);

  // What was left first is still there to go on from, and all before it as it was then.
  await goOn(() => chooseInHistory(2));
  await witness.until(() => isOnTable(witness, "RedBlock"), "it lies where it fell then");
  assert.ok(!witness.isHeld("RedBlock"), "and is not held");
  await person.grasp("GreenBlock");
  await person.release();
  await person.finish();
  assert.deepEqual(await undone(), [false, false, false, true, false, false]);
  await person.slideTo(moment, taking.end - 0.2);
  await goOn(() => person.press("Continue from here", timeline));
  assert.ok(witness.isHeld("RedBlock"), "as it was then");
  await witness.until(() => witness.positionOf("RedBlock")[2] > 2.9, "lifted as far as then");
  await person.finish();
  const report = replay(join(studio.recordings, id));
  assert.equal(report.identical, true, JSON.stringify(report));

  async function segments() {
    return (await witness.request("open", { recording: id })).timeline.segments;
  }

  async function goOn(deed) {
    await deed();
    await witness.until(() => witness.state.recording?.id === id, "it is recorded on");
    assert.equal(witness.state.mode, "live");
  }

  async function openHistory() {
    await person.press("History", timeline);
    return page.getByRole("menu").getByRole("menuitem");
  }

  /** Of each step, whether it is not what the recording now shows. */
  async function undone() {
    const entries = await (await openHistory()).allTextContents();
    await page.keyboard.press("Escape");
    return entries.map((entry) => entry.endsWith("(undone)"));
  }

  async function chooseInHistory(step) {
    await (await openHistory()).filter({ hasText: new RegExp(`^${step}:`) }).click();
  }
});

async function recordTwoCarries(person) {
  return person.record(async () => {
    for (const [block, x] of [["RedBlock", -5], ["GreenBlock", 2]]) {
      await person.grasp(block);
      await person.dragTo(block, [x, null, 2]);
      await person.release();
    }
  });
}

/** The dialog reports as many effects as the program does, and how far off the block ends. */
async function reports(dialog, report, block) {
  const centimeters = (report.displaced.find((one) => one.id === block).distance_mm / 10).toFixed(0);
  await dialog.getByRole("status").getByText(`${block} ends ${centimeters} cm from its previous place`).waitFor();
  const effects = ["left_out", "gone", "there_again", "displaced", "controls", "host_points", "joints"];
  const number = effects.reduce((sum, kind) => sum + report[kind].length, 0);
  assert.equal(await dialog.getByRole("listitem").count(), number, JSON.stringify(report));
}

test("a take is deleted with its release, unless that is not wanted", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, PLAIN);
  const { timeline } = person;
  const dialog = page.getByRole("dialog");
  const id = await recordTwoCarries(person);
  await person.showPanel("Library");
  await page.locator(".recording").waitFor();
  const listed = await witness.request("library");

  // Neither taken nor released, or released only: reported, and not done.
  await timeline.getByRole("slider", { name: "Any: GreenBlock", exact: true }).click();
  await page.getByRole("button", { name: /hand takes GreenBlock/, pressed: true }).waitFor();
  await page.getByTitle("any hand drops GreenBlock on the table. Belongs to the selected segment").waitFor();
  await person.press("Delete", timeline);
  const pair = dialog.getByRole("switch", { name: "Also delete “any hand drops GreenBlock on the table”" });
  const both = programSays(["edit", join(studio.recordings, id), "--drop", "3-4", "--dry-run"]);
  assert.deepEqual(both.left_out, []);
  await reports(dialog, both, "GreenBlock");
  await pair.uncheck();
  const dropped = programSays(["edit", join(studio.recordings, id), "--drop", "3", "--dry-run"]);
  assert.equal(dropped.left_out.length, 1, JSON.stringify(dropped));
  await reports(dialog, dropped, "GreenBlock");
  await dialog.getByText("can no longer be carried out, and is left out").waitFor();
  await person.press("Cancel", dialog);
  await dialog.waitFor({ state: "detached" });
  assert.deepEqual((await witness.request("library")).recordings, listed.recordings, "nothing was done");
  assert.deepEqual(recordingsOf(studio), [id]);

  await person.segments.nth(4).click();
  await person.press("Delete", timeline);
  await dialog.getByRole("switch", { name: "Also delete “any hand takes GreenBlock”", checked: true }).waitFor();
  await reports(dialog, both, "GreenBlock");
  await person.press("Cancel", dialog);
  await dialog.waitFor({ state: "detached" });
});

test("the effect of an edit is reported before it is written, and comes true", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, PLAIN);
  const { timeline } = person;
  const dialog = page.getByRole("dialog");
  const id = await recordTwoCarries(person);
  const original = filesIn(studio, id);
  await person.showPanel("Library");
  await page.locator(".recording").waitFor();

  // The red block is taken and not carried: reported, and done.
  await person.segments.nth(1).click();
  await person.press("Trim", timeline);
  const to = dialog.getByRole("slider", { name: "To (s)" });
  await person.slideTo(to, 0.1);
  const trim = `1:0-${await to.inputValue()}`;
  const trimmed = programSays(["edit", join(studio.recordings, id), "--trim", trim, "--dry-run"]);
  await reports(dialog, trimmed, "RedBlock");
  await person.press("Save as a new recording", dialog);
  await dialog.waitFor({ state: "detached" });
  const made = recordingsOf(studio).filter((name) => name !== id);
  assert.equal(made.length, 1, `${made}`);
  assert.equal(replay(join(studio.recordings, made[0])).identical, true);
  assert.deepEqual(filesIn(studio, id), original, "the original stays as it is, to the last byte");

  const ends = [await endOf("RedBlock", id), await endOf("RedBlock", made[0])];
  const distance = MILLIMETERS_PER_UNIT * Math.hypot(...ends[0].map((value, k) => value - ends[1][k]));
  const reported = trimmed.displaced.find((one) => one.id === "RedBlock").distance_mm;
  assert.ok(Math.abs(distance - reported) < 1, `${distance} mm away, ${reported} mm were reported`);

  /** Where an object is in the last moment of a recording. */
  async function endOf(block, recording) {
    const { title } = (await witness.request("library")).recordings.find((one) => one.id === recording);
    await person.press(`Actions for “${title || recording}”`);
    await page.getByRole("menuitem", { name: "Show the end" }).click();
    const isAtEnd = ({ playback }) =>
      playback?.recording === recording && Math.abs(playback.seconds - playback.length) < 1e-3;
    await witness.until(() => isAtEnd(witness.state), `the end of ${recording}`);
    const slider = await timeline.getByRole("slider", { name: "Moment" }).elementHandle();
    await page.waitForFunction((moment) => moment.max - moment.value < 0.06, slider);
    return page.evaluate((object) => window.smileStudio.placeOf(object), block);
  }
});

test("an edit is canceled while it is written, or is seen at once, from its start", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-robot"] });
  const { timeline } = person;
  const id = await person.record(async () => {
    for (const block of ["RedBlock", "GreenBlock"]) {
      await person.grasp(block);
      await person.dragTo(block, [null, null, 2.5]);
      await person.release();
    }
  });
  await person.segments.nth(0).click();
  await timeline.getByRole("slider", { name: "Moment" }).press("Home");
  await witness.until(() => witness.state.playback?.seconds === 0, "its start is shown");
  await heightIs("GreenBlock", 0, 0.6);
  const start = await settledView(page);
  await person.segments.nth(3).click();
  await witness.until(() => witness.state.playback?.seconds > 0, "the segment's end is shown");
  await heightIs("GreenBlock", 2.4, 9);
  await until(async () => (await seenByRobot(page)) !== start, "the robot sees it lifted");
  const dialog = page.getByRole("dialog");
  await tryDelete();
  await page.evaluate(() => {
    const cancelOnceBegun = () => {
      if (document.querySelector("dialog progress[aria-label^=Writing]") === null) return;
      observer.disconnect();
      [...document.querySelectorAll("dialog footer button")].find((one) => one.innerText === "Cancel").click();
    };
    const observer = new MutationObserver(cancelOnceBegun);
    observer.observe(document.body, { childList: true, subtree: true });
  });
  await person.press("Save as a new recording", dialog);
  await dialog.waitFor({ state: "detached" });
  assert.deepEqual(await recordings(), [id]);

  await tryDelete();
  await dialog.getByRole("switch", { name: "Also delete" }).uncheck();
  await dialog.getByText("and is left out").waitFor();
  await page.evaluate(() => {
    window.barNames = new Set();
    const note = () => document.querySelectorAll("dialog progress").forEach((bar) => window.barNames.add(bar.ariaLabel));
    new MutationObserver(note).observe(document.body, { childList: true, subtree: true });
  });
  await person.press("Save as a new recording", dialog);
  await dialog.waitFor({ state: "detached" });
  const bars = await page.evaluate(() => [...window.barNames]);
  assert.match(bars.join(), /^Writing the new recording/, "a bar shows the progress");
  await witness.until(() => ![undefined, id].includes(witness.state.playback?.recording), "the new one is shown");
  assert.equal(witness.state.playback.seconds, 0);
  await timeline.getByText(/^0\.0 of /).waitFor();
  await timeline.getByRole("img", { name: /a command was left out: .* holds nothing\. The recording is complete without it/ }).waitFor();
  await heightIs("GreenBlock", 0, 0.6);
  await until(async () => (await seenByRobot(page)) === start, "the robot sees the start as well");
  assert.equal((await recordings()).length, 2, "what was canceled is not there");

  async function tryDelete() {
    await person.press("Delete", timeline);
    await dialog.getByText(/^The new duration/).waitFor();
  }

  async function recordings() {
    return (await witness.request("library")).recordings.map((one) => one.id);
  }

  function heightIs(block, low, high) {
    const isThere = ([object, from, to]) => {
      const [, , z] = window.smileStudio.placeOf(object);
      return z > from && z < to;
    };
    return page.waitForFunction(isThere, [block, low, high]);
  }
});

test("a client that connects during playback finds the timeline", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, PLAIN);
  await recordFall(person, witness);
  await person.segments.nth(1).click();
  await witness.until(() => witness.state.mode === "playback", "a moment of it");
  const { seconds } = witness.state.playback;
  const numSegments = await person.segments.count();
  await page.reload();
  await finds(person);
  const watcher = new Person(await browser.open(studio), witness);
  await finds(watcher);
  await person.press("Close this recording", person.timeline);
  await witness.until(() => witness.state.mode === "live", "the table");
  await person.timeline.getByText("Press Record and demonstrate a task").waitFor();

  async function finds(visitor) {
    await visitor.segments.nth(numSegments - 1).waitFor();
    assert.equal(await visitor.segments.count(), numSegments);
    await visitor.timeline.getByText(`${seconds.toFixed(1)} of `).waitFor();
  }
});

test("a recording is scrubbed and played while the table waits as it was left", async (t) => {
  const { page, witness, person } = await browser.workplace(t, PLAIN);
  const { timeline } = person;
  const moment = timeline.getByRole("slider", { name: "Moment" });
  const id = await recordFall(person, witness);
  const { segments } = (await witness.request("open", { recording: id })).timeline;
  await person.grasp("GreenBlock");
  await person.dragTo("GreenBlock", [null, null, 2]);
  await witness.until(() => Math.abs(witness.positionOf("GreenBlock")[2] - 2) < 0.05, "it hangs there");
  const left = await witness.settled(tableNow, "it hangs still", 500);

  await person.slideTo(moment, segments[1].end - 0.1);
  await shows("RedBlock", (z) => z > 2.5);
  await shows("GreenBlock", (z) => z < 0.6);
  assert.equal(witness.state.mode, "playback");
  await person.slideTo(moment, 0);
  await shows("RedBlock", (z) => z < 0.6);
  await person.press("Play", timeline);
  await shows("RedBlock", (z) => z > 1.5);
  await witness.until(() => witness.state.playback.rate === 0, "it ends");
  await shows("RedBlock", (z) => z < 0.6);

  await person.press("Back to the table");
  await witness.until(() => witness.state.mode === "live", "the table");
  await shows("GreenBlock", (z) => z > 1.9);
  await witness.within(5000, () => isDeepStrictEqual(tableNow(), left));
  assert.deepEqual(tableNow(), left, "as it was left");
  await person.release();
  await shows("GreenBlock", (z) => z < 0.6);

  /** Waits until the page draws an object at such a height. */
  async function shows(block, isThere) {
    const heightOf = (object) => window.smileStudio.placeOf(object)[2];
    let height = null;
    for (const end = Date.now() + 20_000; Date.now() < end; await person.look()) {
      height = await page.evaluate(heightOf, block);
      if (isThere(height)) return;
    }
    throw new Error(`${block} is drawn at a height of ${height}, not so that ${isThere}`);
  }

  function tableNow() {
    const places = witness.ids.map((object) => [object, ...witness.positionOf(object).map((value) => value.toFixed(2))]);
    return { places, hand: witness.handOf("GreenBlock") };
  }
});

/** The picture of the robot's eye; null if it was replaced while it was read. */
function seenByRobot(page) {
  const draw = async (image) => {
    await image.decode();
    const size = { width: image.naturalWidth, height: image.naturalHeight };
    const canvas = Object.assign(document.createElement("canvas"), size);
    canvas.getContext("2d").drawImage(image, 0, 0);
    return canvas.toDataURL();
  };
  return page.getByAltText("View of the robot’s eye").evaluate(draw).catch(() => null);
}

/** That picture, once it stays the same for a second: four a second are drawn. */
async function settledView(page) {
  let [before, since] = [null, 0];
  while (before === null || Date.now() - since < 1000) {
    const now = await seenByRobot(page);
    if (now !== before) [before, since] = [now, Date.now()];
    await page.waitForTimeout(50);
  }
  return before;
}

async function until(holds, what) {
  for (const end = Date.now() + 20_000; Date.now() < end; ) {
    if (await holds()) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  throw new Error(`this never came: ${what}`);
}

function recordingsOf(studio) {
  return readdirSync(studio.recordings).filter((name) => !name.startsWith("."));
}

/** Each file of a recording, with its bytes. */
function filesIn(studio, recording) {
  const folder = join(studio.recordings, recording);
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  return files.map(({ parentPath, name }) => [name, readFileSync(join(parentPath, name), "base64")]).sort();
}

/** The red block is taken, lifted and let fall. */
function recordFall(person, witness) {
  return person.record(async () => {
    await person.grasp("RedBlock");
    await person.dragTo("RedBlock", [null, null, 3]);
    await person.release();
    await witness.until(() => isOnTable(witness, "RedBlock"), "it falls");
  });
}

function isOnTable(witness, block) {
  return Math.abs(witness.positionOf(block)[2] - 0.5) < 0.05;
}
