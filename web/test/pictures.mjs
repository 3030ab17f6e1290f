// Takes the pictures of docs/studio.md, into docs/images: npm run pictures [-- FUNCTION…].
// They are made small by Debian's pngquant, which has to be there.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildLetters } from "./letters.mjs";
import { writeMoodyBrain } from "./moody_brain.mjs";
import { MujocoProgram } from "./mujoco_program.mjs";
import { Fingers, Person } from "./person.mjs";
import { Browser, Witness } from "./workbench.mjs";

const FOLDER = fileURLToPath(new URL("../../docs/images/", import.meta.url));
const SMILE = process.env.SMILE ?? "build/dev/bin/smile";
const shipped = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const UM = shipped("scenes/um.xml");

/** Blurred pictures are for people without a graphics card. */
const LIKES = { detail: "high" };
/** Notches of the wheel. */
const ZOOM = 4;

const ends = [];
const browser = new Browser();
await browser.start();
try {
  for (const take of [atTheTable, withLetters, onAPhone, ofManyRobots, inMujoco]) {
    const isWanted = process.argv.length === 2 || process.argv.includes(take.name);
    if (isWanted) await take();
    for (const end of ends.splice(0)) await end();
  }
} finally {
  await browser.close();
}

function begin(options) {
  return browser.workplace({ after: (end) => ends.push(end) }, options);
}

/** Once the world and all pictures of the panels are drawn. */
async function shoot({ page, person }, name) {
  await page.waitForFunction(() => {
    const toasts = document.querySelectorAll(".notice, .spinner").length;
    const shown = [...document.images].filter((image) => {
      const { top, right, bottom, left, width } = image.getBoundingClientRect();
      return width > 0 && bottom > 0 && top < innerHeight && right > 0 && left < innerWidth;
    });
    return toasts === 0 && shown.every((image) => image.complete);
  });
  await person.look();
  const path = `${FOLDER}${name}.png`;
  await page.screenshot({ path });
  execFileSync("pngquant", ["--force", "--strip", "--output", path, "192", path]);
}

async function atTheTable() {
  const desk = await begin({ likes: LIKES });
  const { page, witness, person } = desk;
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  for (const [block, place] of [["GreenBlock", [0, -2, 0.5]], ["RedBlock", [0, -2, 1.5]]]) {
    await person.grasp(block);
    await person.carryOnto(block, place);
    await person.release();
  }
  await person.grasp("BlueBlock");
  await person.carryAbove("BlueBlock", [1.8, -2, 2.4]);
  await person.press("color");
  await shoot(desk, "studio-demonstrating");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
  await shoot(desk, "studio-dark");
  await page.emulateMedia({ colorScheme: "light" });
  await page.waitForFunction(() => document.documentElement.dataset.theme === "light");

  await person.carryOnto("BlueBlock", [0, -2, 2.5]);
  await person.release();
  await person.press("Finish");
  await person.showPanel("Library");
  const timeline = page.getByRole("region", { name: "Timeline" });
  await person.button("Play", timeline).waitFor();
  await timeline.getByRole("list", { name: "Segments" }).getByRole("button").nth(3).click();
  await witness.until(() => witness.state.mode === "playback", "a moment of it");
  await shoot(desk, "studio-library");
  await person.press("Back to the table");

  await person.showPanel("Objects");
  await person.press("Reload");
  await person.showPanel("Brain");
  await page.getByRole("combobox", { name: "Brain", exact: true }).selectOption("wave.py");
  await person.press("Start");
  await page.getByRole("log", { name: "Console" }).getByText("left gripper").first().waitFor();
  await shoot(desk, "studio-brain");
  await person.press("Stop");
  await person.showPanel("Robot");
  await shoot(desk, "studio-robot");

  await person.press("Edit");
  const text = page.getByRole("textbox", { name: "Scene text" });
  await text.fill((await text.inputValue()).replace("(0.4,-3.8,0.5)", "(0.4,-3.8)"));
  await page.getByRole("button", { name: /^Line/ }).first().waitFor();
  await shoot(desk, "studio-editor");
}

/** As the robot would see them. */
async function withLetters() {
  const desk = await begin({ studio: [UM, "--no-robot"], likes: LIKES });
  const { page, person } = desk;
  await person.press("Robot");
  await person.record(() => buildLetters(person));
  const { x, y } = await person.pointOf("Blue1");
  await page.mouse.move(x, y);
  for (let k = 0; k < ZOOM; ++k) await page.mouse.wheel(0, -100);
  await page.mouse.move(0, 0);
  await shoot(desk, "studio-letters");
}

async function onAPhone() {
  const desk = await begin({
    likes: LIKES,
    page: { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true },
  });
  const { page, witness } = desk;
  await page.getByRole("button", { name: "Record" }).waitFor();
  const person = new Person(page, witness, await Fingers.on(page));
  await person.grasp("GreenBlock");
  await shoot(desk, "studio-phone");
}

/** Six episodes of a brain that sometimes gives up. */
async function ofManyRobots() {
  const brains = mkdtempSync(join(tmpdir(), "smile-brains-"));
  ends.push(() => rmSync(brains, { recursive: true }));
  writeMoodyBrain(brains);
  const desk = await begin({ studio: ["--brains", brains], likes: LIKES });
  const { studio, page, person } = desk;
  execFileSync(SMILE, ["run", shipped("scenes/tower.xml"), "--commands", shipped("examples/tower.jsonl"),
    "--record", join(studio.recordings, "tower")]);
  await person.showPanel("Library");
  await person.press("Actions for “tower”");
  await page.getByRole("menuitem", { name: "Generate…" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("textbox", { name: "Name" }).fill("towers");
  await dialog.getByRole("spinbutton", { name: "Episodes" }).fill("6");
  await shoot(desk, "studio-generate");
  await person.press("Generate", dialog);
  await dialog.getByText("Done").waitFor({ timeout: 300_000 });
  await dialog.locator("footer").getByRole("button", { name: "Close" }).click();
  await page.getByRole("region", { name: "Generated sets" }).getByRole("button", { name: "Open" }).click();
  await page.locator(".attempt img").nth(5).waitFor();
  await shoot(desk, "studio-attempts");
}

/** That of docs/other-simulators.md. */
async function inMujoco() {
  const model = readFileSync(shipped("tools/simulator_pictures/boxes.xml"), "utf8");
  const program = await MujocoProgram.start({ after: (end) => ends.push(end) }, model);
  const witness = await Witness.of(program);
  const page = await browser.open(program, {}, LIKES);
  const person = new Person(page, witness);
  await person.press("Record");
  await person.grasp("blue");
  const [x, y, z] = witness.positionOf("red");
  await person.carryAbove("blue", [x, y, z + 1.6]);
  await shoot({ page, person }, "simulators/mujoco-page");
}
