// What makes daily work easier: keys in tooltips, and a layout that stays.

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

test("the layout stays across visits, and returns to the default", async (t) => {
  const { page, person } = await browser.workplace(t, { studio: BARE });
  const visitAgain = async () => {
    await page.reload();
    await page.waitForFunction(() => window.smileStudio?.stats().isShown);
  };
  const panel = page.getByRole("complementary", { name: "Objects and library" });
  const widthOf = async (place) => (await place.boundingBox()).width;
  const usual = await widthOf(panel);
  /** Where the middle of the table's edge is on the page: another in each view. */
  const seen = async () => {
    await person.look();
    const { x, y } = await person.placeOnPage([4, 0, 0]);
    return [Math.round(x), Math.round(y)];
  };
  const first = await seen();

  await person.showPanel("Library");
  const { x, y, width, height } = await panel.getByRole("separator").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 90, y + height / 2, { steps: 3 });
  await page.mouse.up();
  await page.getByRole("button", { name: "Snap to" }).click();
  await page.getByRole("button", { name: "Timeline", exact: true }).click();
  await page.keyboard.press("3");
  const fromAbove = await seen();
  assert.notDeepEqual(fromAbove, first);

  await visitAgain();
  assert.ok(Math.abs((await widthOf(panel)) - usual - 90) <= 2, `${await widthOf(panel)} px`);
  await page.getByRole("tab", { name: "Library", selected: true }).waitFor();
  assert.equal(await page.getByRole("button", { name: "Snap to" }).getAttribute("aria-expanded"), "false");
  assert.equal(await page.getByRole("button", { name: "Timeline", exact: true }).getAttribute("aria-expanded"), "false");
  assert.deepEqual(await seen(), fromAbove, "from above");
  await panel.getByRole("separator").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs((await widthOf(panel)) - usual - 110) <= 2, "by keys, too");

  for (const visit of ["now", "later"]) {
    if (visit === "now") {
      await page.keyboard.press("h");
      await person.press("Default layout");
    } else {
      await visitAgain();
    }
    await page.getByRole("tab", { name: "Objects", selected: true }).waitFor();
    assert.equal(await widthOf(panel), usual);
    assert.equal(await page.getByRole("button", { name: "Snap to" }).getAttribute("aria-expanded"), "true");
    assert.equal(await page.getByRole("button", { name: "Timeline", exact: true }).getAttribute("aria-expanded"), "true");
    assert.deepEqual(await seen(), first, visit);
  }
});
