// What makes daily work easier: keys in tooltips.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Browser } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const BARE = ["--no-robot", "--no-pictures"];

test("tooltips name the keys that do the same", async (t) => {
  const { page, witness, person } = await browser.workplace(t, { studio: BARE });
  await person.grasp("RedBlock");
  await person.button("Move up").waitFor();
  const hinted = await page.locator("[aria-keyshortcuts][title]").evaluateAll((all) =>
    all.map(({ title, ariaKeyShortcuts, textContent }) => ({ title, key: ariaKeyShortcuts ?? "", text: textContent })),
  );
  assert.ok(hinted.length >= 20, `${hinted.length} tooltips`);
  for (const { title, text } of hinted) assert.match(title, /\(\S+\)$/, text);
  const titleOf = (name) => person.button(name).getAttribute("title");
  assert.equal(await titleOf("Front"), "View from the front, toward the robot (1)");
  assert.equal(await titleOf("Turn the plane by -5°"), "Turn the plane by -5° (Shift+/)");
  assert.match(await titleOf("Destroy"), /\(Del\)$/);

  // The keys that they name are those of the help, and do it.
  const before = witness.handOf("RedBlock").place[2];
  const [, key] = /\((.)\)$/.exec(await titleOf("Move up"));
  await page.keyboard.press(key.toLowerCase());
  await witness.until(() => witness.handOf("RedBlock").place[2] > before, "the key moves it up");
  await page.keyboard.press("h");
  const help = page.getByRole("dialog", { name: "Keys and mouse" });
  const known = await help.locator("kbd").allTextContents();
  for (const { title } of hinted) assert.ok(known.includes(/\((\S+)\)$/.exec(title)[1]), title);
});
