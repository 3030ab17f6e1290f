// What the page reports when the program ends, says nothing, or cannot execute a request.

import assert from "node:assert/strict";
import { existsSync, rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, replay, Studio } from "./workbench.mjs";

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
  await page.clock.install();
  const died = new Promise((resolve) => studio.child.once("exit", resolve));
  studio.child.kill("SIGKILL");
  await died;
  const alert = page.getByRole("alert").filter({ hasText: "Connection lost" });
  await alert.waitFor();
  assert.equal((await alert.textContent()).trim(), "Connection lost. Reconnecting…");
  await page.clock.fastForward(10_000);
  const doubt = page.getByRole("alert").filter({ hasText: "The program does not respond" });
  await doubt.waitFor();
  assert.match(await doubt.textContent(), /A recording in progress may lack its last moments\.$/);
});

test("a full disk ends the recording; one message stays until it is confirmed", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { studio: PLAIN, maxFileBytes: 24 * 1024 });
  await page.clock.install();
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  const { id } = witness.state.recording;
  await person.grasp("RedBlock");
  for (let k = 0; witness.state.recording !== null && k < 60; ++k) {
    await person.dragTo("RedBlock", [null, null, k % 2 === 0 ? 3 : 1.5]);
  }
  await witness.until(() => witness.state.recording === null, "its end");
  const alert = await onlyAlert(page);
  assert.match(await alert.textContent(), /Recording of “tower” has stopped.*are in the library.*File too large/);
  assert.equal(replay(join(studio.recordings, id)).identical, true);
  await person.press("OK");
  await alert.waitFor({ state: "detached" });
});

test("a recording whose folder is removed is reported as lost, not as being in the library", async (t) => {
  const { studio, page, witness, person } = await browser.workplace(t, { studio: PLAIN });
  await page.clock.install();
  await person.press("Pause");
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "a recording");
  const { id } = witness.state.recording;
  rmSync(studio.recordings, { recursive: true });
  await person.press("Finish");
  await witness.until(() => witness.state.recording === null, "its end");
  const alert = await onlyAlert(page);
  assert.match(await alert.textContent(), /“tower” is lost.*was removed during the recording/);
  assert.ok(!existsSync(join(studio.recordings, id)));
  await person.press("OK");
  await person.press("Record");
  await witness.until(() => witness.state.recording !== null, "the next one");
  assert.equal(witness.state.failure, null);
});

/** The one message of the page, long after it came. The page's clock must be installed. */
async function onlyAlert(page) {
  const alert = page.locator(".banner.error");
  await alert.waitFor();
  await page.clock.fastForward(1000);
  assert.deepEqual(await page.locator(".notice").allTextContents(), [], "nothing else is said");
  await page.clock.fastForward(60_000);
  assert.equal(await alert.count(), 1, "it stays");
  return alert;
}

test("nothing counts as shown before the program has said what there is", async (t) => {
  const { page } = await browser.workplace(t, { studio: PLAIN });
  await page.routeWebSocket(/\/ws/, () => {}); // a program that accepts, and says nothing
  await page.reload();
  await page.waitForFunction(() => window.smileStudio !== undefined);
  assert.equal(await page.evaluate(() => window.smileStudio.stats().isShown), false);
});
