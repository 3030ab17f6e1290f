// Generated sets and datasets, made and looked at from the page.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, before, test } from "node:test";
import { writeMoodyBrain } from "./moody_brain.mjs";
import { Browser, replay } from "./workbench.mjs";

const SMILE = process.env.SMILE ?? "build/dev/bin/smile";
const shipped = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const RESTS = `# smile: imitates
import time
def step(sensor, motor, aux):
    time.sleep(0.1)
`;

/** A studio whose library has the demonstration of a tower. */
async function workplace(t) {
  const brains = mkdtempSync(join(tmpdir(), "smile-brains-"));
  t.after(() => rmSync(brains, { recursive: true }));
  writeMoodyBrain(brains);
  writeFileSync(join(brains, "rests.py"), RESTS);
  const desk = await browser.workplace(t, { studio: ["--no-pictures", "--brains", brains] });
  const { studio, page, person } = desk;
  execFileSync(SMILE, ["run", shipped("scenes/tower.xml"), "--commands", shipped("examples/tower.jsonl"),
    "--record", join(studio.recordings, "shown"), "--size", "320x240"], { stdio: "ignore" });
  await person.showPanel("Library");
  const card = (title) => page.locator(".recording", { has: page.locator("strong", { hasText: title }) });
  await card("shown").waitFor();
  const choose = async (title, entry) => {
    await person.press(`Actions for “${title}”`);
    await page.getByRole("menuitem", { name: entry }).click();
    return page.getByRole("dialog");
  };
  return { ...desk, card, choose };
}

/** Waits for what no page shows. */
async function until(holds, what) {
  const deadline = Date.now() + 60_000;
  while (!holds()) {
    assert.ok(Date.now() < deadline, `this never came: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

test("a set is generated, looked at by its causes, and its failure opened", async (t) => {
  const { studio, page, person, card, choose } = await workplace(t);
  const dialog = await choose("shown", "Generate…");
  assert.equal(await dialog.getByRole("combobox", { name: "Robot scene" }).inputValue(), "tower_robot");
  await dialog.getByRole("combobox", { name: "Brain that imitates" }).selectOption("moody.py");
  await dialog.getByRole("textbox", { name: "Name" }).fill("../towers");
  await person.press("Generate", dialog);
  await dialog.getByRole("alert").getByText("expected up to 100 letters").waitFor();
  await dialog.getByRole("textbox", { name: "Name" }).fill("towers");
  await dialog.getByRole("spinbutton", { name: "Episodes" }).fill("1");
  await dialog.getByRole("spinbutton", { name: "First seed" }).fill("3");
  await dialog.getByText("Variations: none").click();
  await dialog.getByRole("combobox", { name: "Sensor noise" }).selectOption("mild");
  await dialog.getByText("Variations: sensor noise").waitFor();
  await person.press("Generate", dialog);
  await dialog.getByText("0 of 1 episode").waitFor();
  await dialog.getByText("1 × never taken").waitFor({ timeout: 60_000 });
  // The page may be closed meanwhile.
  await page.reload();
  await page.waitForFunction(() => window.firstPictureAt !== undefined);
  await page.locator(".job").getByText("Done").waitFor({ timeout: 120_000 });
  await card("towers").getByText("1 of 1 episode").waitFor();
  await card("towers").getByText("2 attempts · yield 50 %").waitFor();
  assert.ok(existsSync(join(studio.recordings, "generated/towers/summary.json")));
  assert.match(readFileSync(join(studio.recordings, "generated/towers/manifest.jsonl"), "utf8"), /"noise":\{"joints":0\.00/);

  await person.press("Open", card("towers"));
  const grid = page.getByRole("dialog", { name: "Attempts of “towers”" });
  await grid.getByText(/95 %: 9 to 91 %/).waitFor();
  const attempts = grid.getByRole("list", { name: "Attempts" }).getByRole("button");
  assert.equal(await attempts.count(), 2);
  await page.waitForFunction(() => [...document.querySelectorAll(".attempt img")].every((image) => image.naturalWidth === 320));
  await person.press("success", grid);
  await grid.getByText("1 of 2 attempts shown").waitFor();
  await person.press("success", grid);
  await grid.getByRole("combobox", { name: "Cause" }).selectOption("never_taken");
  assert.equal(await attempts.count(), 1);
  await grid.getByRole("textbox", { name: "Seeds" }).fill("4-9");
  await grid.getByText("0 of 2 attempts shown").waitFor();
  await grid.getByRole("textbox", { name: "Seeds" }).fill("3");
  await attempts.first().click();
  await grid.waitFor({ state: "detached" });
  await person.timeline.getByText("towers, seed 3").first().waitFor();
  await person.press("Play", person.timeline);
  await person.press("Back to the table");
  assert.ok(replay(join(studio.recordings, "generated/towers/failures/seed-0003/imitation")).identical);

  const renaming = await choose("towers", "Rename…");
  await renaming.getByRole("textbox", { name: "Name" }).fill("towers");
  await person.press("Save", renaming);
  await renaming.getByRole("alert").getByText("there is a set \"towers\" already").waitFor();
  await renaming.getByRole("textbox", { name: "Name" }).fill("piles");
  await page.keyboard.press("Enter");
  await renaming.waitFor({ state: "detached" });

  await choose("piles", "Move to the bin");
  await card("piles").waitFor({ state: "detached" });
  await person.press("Show the bin");
  await person.press("Restore", card("piles"));
  await person.press("Show the bin");
  await card("piles").getByText("1 of 1 episode").waitFor();
});

test("a generation is stopped and continued", async (t) => {
  const { studio, page, person, card, choose } = await workplace(t);
  const dialog = await choose("shown", "Generate…");
  await dialog.getByRole("combobox", { name: "Brain that imitates" }).selectOption("rests.py");
  await dialog.getByRole("textbox", { name: "Name" }).fill("slow");
  await person.press("Generate", dialog);
  await dialog.getByText("0 of 20 episodes").waitFor();
  await until(() => existsSync(join(studio.recordings, "generated/slow/running")), "a run");
  await person.press("Stop", dialog);
  await dialog.getByText("Stopped; what is done is kept").waitFor();
  await person.press("Close", dialog.locator("footer"));
  await card("slow").getByText("0 of 20 episodes").waitFor();
  assert.ok(!existsSync(join(studio.recordings, "generated/slow/summary.json")));
  await choose("slow", "Continue");
  await page.locator(".job").getByText("0 of 20 episodes").waitFor();
  await person.press("Stop “slow”");
  await page.locator(".job").filter({ hasText: "Stopped" }).nth(1).waitFor();
});

/** Plays Python: its packages are missing until they are installed; then it exports, and the doctor finds something. */
const PYTHON = `#!/bin/sh
here=$(dirname "$0")
shift 4 # -c, a program, its module, and what that needs
what=$1
out=$2
[ -e "$here/installed" ] || { echo "smile: datasets need a Python package: No module named 'pyarrow'; get it by" >&2; exit 3; }
while [ $# -gt 0 ]; do [ "$1" = --out ] && out=$2; shift; done
[ $what = doctor ] && { echo "$out: 0 errors, 1 warnings"; exit 0; }
echo "episode 2 of 4: run, 9 frames" >&2
while [ ! -e "$here/go" ]; do sleep 0.05; done
mkdir -p "$out"
`;

test("a recording is exported, as soon as the packages are there, and checked", async (t) => {
  const folder = mkdtempSync(join(tmpdir(), "smile-python-"));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(join(folder, "python"), PYTHON, { mode: 0o755 });
  process.env.SMILE_PYTHON = join(folder, "python");
  t.after(() => delete process.env.SMILE_PYTHON);
  const { studio, page, person, choose } = await workplace(t);
  const dialog = await choose("shown", "Export…");
  await dialog.getByRole("combobox", { name: "Format" }).selectOption("zarr");
  await person.press("head", dialog);
  await dialog.getByRole("combobox", { name: "Picture size" }).selectOption("160x120");
  await dialog.getByRole("combobox", { name: "Frames per second" }).selectOption("10");
  await person.press("Export", dialog);
  await dialog.getByRole("alert").getByText("No module named 'pyarrow'; get it by").waitFor();
  writeFileSync(join(folder, "installed"), "");
  await person.press("Export", dialog);
  await dialog.getByText("1 of 4 episodes").waitFor();
  writeFileSync(join(folder, "go"), "");
  await dialog.getByText("0 errors, 1 warnings").waitFor();
  await dialog.getByText("datasets/shown", { exact: false }).last().waitFor();
  assert.ok(existsSync(join(studio.recordings, "datasets/shown")));
  await person.press("Close", dialog.locator("footer"));
  await page.locator(".job").filter({ hasText: "Done" }).waitFor();
  await person.press("Dismiss “shown”");
  await page.locator(".job").waitFor({ state: "detached" });
});

test("a film is made of a recording, downloaded, and another one stopped", async (t) => {
  const { studio, page, person, choose } = await workplace(t);
  const fill = async (dialog, name, size, rate) => {
    await dialog.getByRole("textbox", { name: "Name" }).fill(name);
    await dialog.getByRole("combobox", { name: "Camera" }).selectOption("From above");
    await dialog.getByRole("combobox", { name: "Picture size" }).selectOption(size);
    await dialog.getByRole("combobox", { name: "Frames per second" }).selectOption(rate);
    await person.press("Make the film", dialog);
  };
  const dialog = await choose("shown", "Film…");
  await fill(dialog, "from above", "320x240", "2");
  await dialog.getByText("Done").waitFor({ timeout: 120_000 });
  const [download] = await Promise.all([page.waitForEvent("download"), person.press("Download", dialog)]);
  assert.equal(download.suggestedFilename(), "from above.mp4");
  const film = readFileSync(await download.path());
  assert.equal(film.subarray(4, 8).toString(), "ftyp");
  assert.ok(film.equals(readFileSync(join(studio.recordings, "films/from above.mp4"))));
  await person.press("Close", dialog.locator("footer"));
  await page.locator(".job").filter({ hasText: "Film “from above”" }).getByRole("button", { name: "Download" }).waitFor();

  const other = await choose("shown", "Film…");
  await fill(other, "from above", "320x240", "2");
  await other.getByRole("alert").getByText("there is a film \"from above\" already").waitFor();
  await fill(other, "large", "1920x1080", "60");
  await other.getByText(/^ ?\d+ of \d+ s$/).waitFor({ timeout: 60_000 });
  await person.press("Stop", other);
  await other.getByText("Stopped; nothing is kept").waitFor();
  const left = readdirSync(join(studio.recordings, "films")).filter((name) => name.endsWith(".mp4"));
  assert.deepEqual(left, ["from above.mp4"]);
});
