// The page of `smile ros perform --page`: mouse and keys stop the robot, and the page says what became of it.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { dirname, join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { Browser } from "./workbench.mjs";

const SMILE = resolve(process.env.SMILE ?? "build/dev/bin/smile");
const PROJECT = resolve(import.meta.dirname, "../..");
const PATH = [join(PROJECT, "python"), join(dirname(dirname(SMILE)), "python")].join(":");
// A performance in the page, without a robot: prints its link, and why it was stopped.
const PROGRAM = `
import sys, threading, time
from smile.ros.stop_page import StopPage
page = StopPage("Tower", 0)
page.show("Performing", 2.5, 11, 0.004)
print(page.link, flush=True)
threading.Thread(target=lambda: sys.stdin.read(1) or __import__("os")._exit(0), daemon=True).start()
while (reason := page.must_stop()) is None:
    time.sleep(0.01)
print(reason, flush=True)
page.close("Stopped: " + reason + ".")
`;

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** The page of a performance, and the lines that its program prints. */
async function performance(t, options = {}) {
  const child = spawn(process.env.SMILE_PYTHON ?? "/usr/bin/python3", ["-c", PROGRAM], {
    env: { ...process.env, PYTHONPATH: PATH, PYTHONDONTWRITEBYTECODE: "1" },
    stdio: ["pipe", "pipe", "inherit"],
  });
  t.after(() => child.kill());
  const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
  const context = await browser.browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  t.after(() => context.close());
  const page = await context.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  t.after(() => assert.deepEqual(complaints, []));
  await page.goto((await lines.next()).value);
  await page.getByText("Performing: 2.5 s of 11.0 s. Greatest error now: 4 mrad.").waitFor();
  return { child, lines, page };
}

async function isStopped({ lines, page }) {
  assert.equal((await lines.next()).value, "the button of the page was pressed");
  await page.getByText("Stopped: the button of the page was pressed.").waitFor();
  assert.ok(await page.getByRole("button", { name: "STOP" }).isDisabled());
}

test("pressing the mouse on the button stops, before it comes up", async (t) => {
  const shown = await performance(t);
  const box = await shown.page.getByRole("button", { name: "STOP" }).boundingBox();
  await shown.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await shown.page.mouse.down();
  await isStopped(shown);
});

for (const key of ["Escape", "Space"]) {
  test(`${key} stops, on a phone as well`, async (t) => {
    const shown = await performance(t, { viewport: { width: 360, height: 640 }, colorScheme: "dark" });
    await shown.page.keyboard.press(key);
    await isStopped(shown);
    const { scrollWidth, clientWidth } = await shown.page.evaluate(() => document.documentElement);
    assert.equal(scrollWidth, clientWidth);
  });
}

test("a page whose program has gone says that its button does nothing", async (t) => {
  const { child, page } = await performance(t);
  child.stdin.end();
  await page.getByText("this button does nothing. If the robot moves, use the emergency stop.").waitFor();
  assert.ok(await page.getByRole("button", { name: "STOP" }).isDisabled());
});
