// What becomes of a recording: looked at, played, edited, renamed, thrown away and taken back.

import assert from "node:assert/strict";
import { existsSync, readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, replay } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

test("a recording is shown, played, edited, renamed, binned and taken back", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { studio: ["--no-robot"] });
  const { timeline, segments } = person;
  const id = await person.record(async () => {
    for (const block of ["RedBlock", "GreenBlock"]) {
      await person.grasp(block);
      await person.dragTo(block, [null, null, 2]);
      await person.release();
    }
  });

  // It opens in the timeline by itself, in words and pictures.
  await segments.filter({ hasText: "RedBlock" }).first().waitFor();
  const pictures = timeline.locator(".segment img");
  await page.waitForFunction(() => {
    const shown = [...document.querySelectorAll(".segment img")];
    return shown.length > 2 && shown.every((image) => image.naturalWidth === 320);
  });
  assert.equal(await pictures.count(), await segments.count());

  await person.press("Clear");
  await witness.until(() => witness.ids.length === 0, "an empty table");
  await timeline.getByRole("slider", { name: "Moment" }).fill("1");
  await witness.until(() => witness.state.mode === "playback" && witness.state.playback.seconds === 1, "a moment of it");
  const pause = page.getByRole("button", { name: "Pause", exact: true });
  await page.waitForFunction((button) => button.disabled, await pause.elementHandle()); // the world waits anyway
  await person.press("Play", timeline);
  await witness.until(() => witness.state.playback.seconds > 1.2, "it plays");
  await person.press("Stop", timeline);
  await person.press("Back to the table");
  await witness.until(() => witness.state.mode === "live", "the table again");
  await page.waitForFunction((button) => !button.disabled, await pause.elementHandle());
  assert.deepEqual(witness.ids, [], "as it was left");

  // Without its last action the block is still in the air: that is reported, and then done.
  await segments.last().click();
  await person.press("Delete", timeline);
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("switch", { name: "Also delete" }).uncheck();
  await dialog.getByRole("status").getByText(/GreenBlock|ends/).first().waitFor();
  assert.deepEqual(readdirSync(studio.recordings).filter((name) => !name.startsWith(".")), [id], "only reported so far");
  await dialog.getByRole("textbox").fill("Shorter");
  await person.press("Save as a new recording", dialog);
  await dialog.waitFor({ state: "detached" });
  await person.showPanel("Library");
  const card = (title) => page.locator(".recording", { has: page.locator("strong", { hasText: title }) });
  await card("Shorter").waitFor();
  const made = readdirSync(studio.recordings).filter((name) => name !== id && !name.startsWith("."));
  assert.equal(made.length, 1, `${made}`);
  assert.ok(replay(join(studio.recordings, made[0])).identical);
  assert.ok(replay(join(studio.recordings, id)).identical, "the original stays as it was");

  await choose("Shorter", "Title and notes");
  await page.getByRole("dialog").getByRole("textbox", { name: "Title" }).fill("Two blocks");
  await person.press("Save", page.getByRole("dialog"));
  await card("Two blocks").waitFor();
  // What goes into the bin before its picture is there has none: the page would complain.
  const picture = card("Two blocks").locator("img");
  await picture.scrollIntoViewIfNeeded();
  await picture.evaluate((image) => image.decode());
  await choose("Two blocks", "Move to the bin");
  await card("Two blocks").waitFor({ state: "detached" });
  assert.ok(!existsSync(join(studio.recordings, made[0])), "it is gone");
  await person.press("Show the bin");
  await person.press("Restore", card("Two blocks"));
  await person.press("Show the bin");
  await card("Two blocks").waitFor();
  assert.ok(existsSync(join(studio.recordings, made[0])), "it is back");

  async function choose(title, entry) {
    await person.press(`Actions for “${title}”`);
    await page.getByRole("menuitem", { name: entry }).click();
  }
});

test("titles are changed where they stand", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  const id = await person.record(async () => {
    await person.grasp("RedBlock");
    await person.release();
  });
  const { timeline } = person;
  const titleIn = (place, title) => place.getByRole("button", { name: title, exact: true });
  const before = await timeline.locator(".timeline-name").textContent();
  const field = page.getByRole("textbox", { name: "Title" });
  await person.showPanel("Library");
  const card = page.locator(".recording");

  await titleIn(timeline, before).click();
  await page.keyboard.type("Pick up red"); // it replaces the whole title
  await page.keyboard.press("Enter");
  await titleIn(timeline, "Pick up red").waitFor();
  await titleIn(card, "Pick up red").waitFor();
  const focused = () => page.evaluate(() => document.activeElement.textContent);
  assert.equal(await focused(), "Pick up red", "the keyboard continues where it was");

  await titleIn(card, "Pick up red").click();
  await page.keyboard.type("Something else");
  await page.keyboard.press("Escape");
  await field.waitFor({ state: "detached" });
  await titleIn(card, "Pick up red").click();
  await page.keyboard.press("End");
  await page.keyboard.type(" twice");
  await page.getByRole("heading", { name: "SMILE studio" }).click(); // it is left
  await titleIn(card, "Pick up red twice").waitFor();

  // 256 bytes may be fewer letters than the field takes: the program's reason is shown, and the text stays.
  await titleIn(card, "Pick up red twice").click();
  await page.keyboard.insertText("\u{1F916}".repeat(100));
  await page.keyboard.press("Enter");
  await page.getByRole("alert").getByText(/title/).waitFor();
  assert.equal((await field.inputValue()).length, 200);
  await page.keyboard.press("Escape");
  const { title } = (await witness.request("library")).recordings.find((one) => one.id === id);
  assert.equal(title, "Pick up red twice");
});

test("what mattered in a recording is found out, and kept", async (t) => {
  const { studio, page, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  await person.record(async () => {
    // The first one comes down where it was.
    for (const [block, x] of [["BlueBlock", null], ["RedBlock", -1]]) {
      await person.grasp(block);
      await person.dragTo(block, [x, null, 0.8]);
      await person.release();
    }
  });
  await person.showPanel("Library");
  await person.press(/^Actions for/);
  await page.getByRole("menuitem", { name: "What mattered" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("listitem").filter({ hasText: /^2\./ }).waitFor();
  assert.equal(await dialog.locator(".order-graph .subtask").count(), 2);
  assert.equal(await dialog.locator(".order-graph .redundant").count(), 1);
  await dialog.getByText("The same is achieved with fewer subtasks: 2.").waitFor();
  await dialog.getByText(/^Color of RedBlock, .* instead of red: the same is achieved/).waitFor();
  await dialog.getByText("Everything that is not fixed, 100 mm to the left: the same is achieved.").waitFor();
  // Without a tick, the place of the blue block does not count.
  const counts = dialog.getByRole("group", { name: "What counts" });
  await counts.getByRole("checkbox", { name: /^BlueBlock/ }).uncheck();
  await dialog.getByRole("listitem").filter({ hasText: /^2\./ }).waitFor();
  assert.equal(await counts.getByRole("checkbox", { checked: false }).count(), 1);
  await counts.getByRole("checkbox", { name: /^BlueBlock/ }).check();
  await dialog.getByText("The same is achieved with fewer subtasks: 2.").waitFor();
  await person.press("Save without the rest", dialog);
  await dialog.waitFor({ state: "detached" });
  const made = readdirSync(studio.recordings).filter((name) => name.includes("shortened"));
  assert.equal(made.length, 1, `${made}`);
  assert.ok(replay(join(studio.recordings, made[0])).identical);
  assert.equal(await person.segments.count(), 3, "the beginning, taking and releasing the red block");
});

test("recordings that come or go by other means are seen without a reload", async (t) => {
  const { studio, page, person } = await browser.workplace(t, { studio: ["--no-robot", "--no-pictures"] });
  const id = await person.record(async () => {
    await person.grasp("RedBlock");
    await person.release();
  });
  await person.showPanel("Library");
  const cards = page.locator(".recording");
  const picture = cards.locator("img");
  await picture.scrollIntoViewIfNeeded();
  await picture.evaluate((image) => image.decode());
  rmSync(join(studio.recordings, id), { recursive: true });
  await page.getByText("No recordings yet.").waitFor();
  assert.equal(await cards.count(), 0);
});
