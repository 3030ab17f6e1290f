// For everyone: what axe-core has to say of the page's main states, in light and in dark.

import assert from "node:assert/strict";
import { cpSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser } from "./workbench.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** A set with one attempt, a failure: a copy of the only recording. */
function addGeneratedSet(recordings) {
  const [recording] = readdirSync(recordings).filter((name) => !name.startsWith("."));
  const attempt = join(recordings, "generated/few/failures/seed-0007");
  cpSync(join(recordings, recording), join(attempt, "imitation"), { recursive: true });
  writeFileSync(join(recordings, "generated/few/generation.json"), "{}");
  const variation = {
    scene: "tower.xml", level: "scattered", eye: "eye", noise: { joints: 0, image: 0, depth: 0, seed: 7 },
    looks: null, behavior: { speed: null, order: null, grasp: null, path: null }, disturbance: null,
  };
  const ended = {
    episode: 0, try: 1, seed: 7, variation, outcome: "failure", cause: { word: "never_taken", text: "it was not taken" },
    score: 0, seconds: 1, recording: "failures/seed-0007/imitation", hash: null, result_hash: null, state_hash: null,
  };
  writeFileSync(join(attempt, "attempt.json"), JSON.stringify(ended));
}

/** Axe on a page. */
async function judgeOf(page) {
  await page.evaluate(AXE);
  return { enabled, holdsNothingAgainst };

  /** What is about to be enabled is pale for a moment. */
  async function enabled(name) {
    await page.getByRole("button", { name, exact: true, disabled: false }).waitFor();
  }

  async function holdsNothingAgainst(state) {
    await turn("light");
    const violations = await look({});
    await turn("dark");
    violations.push(...(await look({ runOnly: ["color-contrast"] })));
    const serious = violations
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .map(({ id, nodes }) => `${id}: ${nodes.map(({ html, any }) => `${html} ${any[0]?.message}`).join("\n")}`);
    assert.deepEqual(serious, [], state);
  }

  async function turn(colorScheme) {
    await page.emulateMedia({ colorScheme });
    await page.waitForFunction((theme) => document.documentElement.dataset.theme === theme, colorScheme);
  }

  /** Waits for the end of color transitions, which are no defects. */
  async function settle() {
    await page.evaluate(() => {
      const moving = document.getAnimations().filter((one) => one.effect?.getComputedTiming().endTime !== Infinity);
      const ended = Promise.allSettled(moving.map((one) => one.finished));
      // An animation whose element is no longer drawn never finishes.
      return Promise.race([ended, new Promise((resolve) => setTimeout(resolve, 3000))]).then(() => undefined);
    });
  }

  async function look(options) {
    await settle();
    return page.evaluate((how) => window.axe.run(document, how).then(({ violations }) => violations), {
      resultTypes: ["violations"],
      ...options,
    });
  }
}

test("axe-core finds no serious barrier, in light and in dark", async (t) => {
  const { page, person } = await browser.workplace(t, { studio: ["--no-pictures"] });
  const { enabled, holdsNothingAgainst } = await judgeOf(page);
  await enabled("Record");
  await holdsNothingAgainst("at the beginning");

  await person.press("Record");
  await person.grasp("RedBlock");
  await page.getByText("Held object: RedBlock").waitFor();
  await enabled("Undo");
  await holdsNothingAgainst("holding something, recording");
  await person.release();
  await person.finish();
  await person.showPanel("Library");
  await person.showPanel("Robot");
  const { timeline } = person;
  await timeline.getByRole("slider", { name: "Moment" }).fill("0.2");
  await person.button("Back to the table").waitFor();
  await holdsNothingAgainst("looking at a recording");
  await person.segments.last().click();
  await person.press("Delete", timeline);
  await enabled("Save as a new recording");
  await holdsNothingAgainst("about to delete a segment");
  await person.press("Cancel");
  await person.press("Back to the table");

  await person.showPanel("Objects");
  await person.showPanel("Brain");
  await person.press("Edit");
  await page.getByRole("textbox", { name: "Scene text" }).fill("<tabletop>");
  await page.getByRole("button", { name: /^Line 1/ }).first().waitFor();
  await holdsNothingAgainst("a scene with errors");
  await person.press("Discard");
  await person.press("Help");
  await holdsNothingAgainst("help");
});

test("axe-core finds no serious barrier at generated sets", async (t) => {
  const { studio, page, person } = await browser.workplace(t, { studio: ["--no-pictures"] });
  const { enabled, holdsNothingAgainst } = await judgeOf(page);
  await person.record(async () => {
    await person.grasp("RedBlock");
    await person.release();
  });
  await person.showPanel("Library");
  addGeneratedSet(studio.recordings);
  await person.press("Refresh");
  await person.press("Actions for “few”");
  await page.keyboard.press("Escape");
  await holdsNothingAgainst("generated sets");
  await person.press("Open", page.getByRole("region", { name: "Generated sets" }));
  await page.getByRole("button", { name: /^Seed 7/ }).waitFor();
  await holdsNothingAgainst("the attempts of a set");
  await person.press("Close");
  for (const entry of ["Generate…", "Export…"]) {
    await page.getByRole("button", { name: /^Actions for “[^f]/ }).first().click();
    await page.getByRole("menuitem", { name: entry }).click();
    await enabled(entry.slice(0, -1));
    await holdsNothingAgainst(entry);
    await person.press("Cancel");
  }
});
