// What people are told when the program goes away, and when it cannot do what they want.

import assert from "node:assert/strict";
import { rmSync } from "node:fs";
import { after, before, test } from "node:test";
import { Browser, Studio } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const PLAIN = ["--no-robot", "--no-pictures"];

test("when the program dies, the page claims nothing that it cannot know", async (t) => {
  const studio = await Studio.start(PLAIN);
  t.after(async () => {
    for (const close of studio.whenClosed) await close();
    rmSync(studio.folder, { recursive: true });
  });
  const page = await browser.open(studio);
  const died = new Promise((resolve) => studio.child.once("exit", resolve));
  studio.child.kill("SIGKILL");
  await died;
  const alert = page.getByRole("alert").filter({ hasText: "Connection lost" });
  await alert.waitFor();
  assert.equal((await alert.textContent()).trim(), "Connection lost. Reconnecting…");
});
