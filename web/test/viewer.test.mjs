// The page on a simulation in Python: in a tab and in the cell of a notebook it shows what the program does, and nothing
// on it does anything.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { dirname, join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { Browser } from "./workbench.mjs";

const SMILE = resolve(process.env.SMILE ?? "build/dev/bin/smile");
const PROJECT = resolve(import.meta.dirname, "../..");
const PATH = [join(PROJECT, "python"), join(dirname(dirname(SMILE)), "python")].join(":");
// Carries out what is written to it, line by line, and prints what it says.
const PROGRAM = `
import sys, smile
sim = smile.Simulation(smile.load(smile.data_file("scenes/tower.xml")))
studio = smile.studio(sim)
say = lambda text: print(text, flush=True)
say(studio.url)
for line in sys.stdin:
    exec(line)
    say("done")
`;

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** A program in Python with a simulation that is shown. */
class Program {
  static async start(t) {
    const child = spawn("/usr/bin/python3", ["-B", "-c", PROGRAM], {
      env: { ...process.env, PYTHONPATH: PATH },
      stdio: ["pipe", "pipe", "inherit"],
    });
    t.after(() => child.kill());
    const program = new Program(child);
    program.link = await program.nextLine();
    return program;
  }

  constructor(child) {
    this.child = child;
    this.lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
    this.whenClosed = [];
  }

  async nextLine() {
    const { value, done } = await this.lines.next();
    if (done) throw new Error("the program has ended");
    return value;
  }

  /** Carries out a line; returns what it printed. */
  async does(line) {
    this.child.stdin.write(`${line}\n`);
    const said = [];
    for (let one = await this.nextLine(); one !== "done"; one = await this.nextLine()) said.push(one);
    return said.join("\n");
  }
}

/** Waits until an object is drawn higher than this [units]. */
function isAbove(frame, height) {
  return frame.waitForFunction((least) => window.smileStudio?.placeOf("RedBlock")?.[2] > least, height);
}

const LIFT = 'hand = sim.hand("left"); hand.grasp("RedBlock"); hand.move_to([0.3, 0.2, 0.3]); sim.run_until("arrived")';

test("a tab shows what the program does, and changes nothing", async (t) => {
  const program = await Program.start(t);
  const page = await browser.open(program, {}, { "tour-known": false });
  t.after(() => page.context().close());
  await page.getByRole("button", { name: "Record" }).waitFor({ state: "detached" });
  assert.equal(await page.getByRole("complementary").count(), 0, "no panels beside the world");
  assert.equal(await page.getByRole("dialog").count(), 0, "no tour");

  await program.does(LIFT);
  await isAbove(page, 2.9);
  const before = await program.does("say(sim.hash)");
  const { x, y } = await page.evaluate(() => window.smileStudio.screenPointOf("GreenBlock"));
  await page.mouse.click(x, y);
  for (const key of ["r", "Space", "Backspace", "Control+z", "Delete"]) await page.keyboard.press(key);
  await page.evaluate(() => new Promise((settle) => setTimeout(settle, 200)));
  assert.equal(await program.does("say(sim.hash)"), before);

  await program.does("sim.undo()");
  await page.waitForFunction(() => window.smileStudio.placeOf("RedBlock")[2] < 1);
  // The next simulation appears at the same link.
  await program.does("other = smile.Simulation(smile.load(smile.data_file('scenes/row.xml'), None)); studio.show(other)");
  await page.getByRole("heading", { name: "row" }).waitFor();
  assert.deepEqual(page.complaints, []);
});

test("a cell of a notebook shows it too", async (t) => {
  const program = await Program.start(t);
  const cell = await program.does("say(studio._repr_html_())");
  const notebook = createServer((_, answer) => {
    answer.setHeader("Content-Type", "text/html");
    answer.end(`<!doctype html><title>Notebook</title><body style="width: 700px">${cell}`);
  });
  await new Promise((listening) => notebook.listen(0, "127.0.0.1", listening));
  t.after(() => notebook.close());
  const context = await browser.browser.newContext();
  t.after(() => context.close());
  const page = await context.newPage();
  await page.goto(`http://localhost:${notebook.address().port}/`);
  const frame = page.frames().find((one) => one.url() === program.link);
  await frame.waitForFunction(() => window.smileStudio?.stats().isShown);
  await program.does(LIFT);
  await isAbove(frame, 2.9);
  if (process.env.SMILE_PICTURE) await page.screenshot({ path: process.env.SMILE_PICTURE });
});
