// A telephone: all that a mouse does in the world, fingers do, too.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Fingers, Person } from "./person.mjs";
import { Browser, SIDE_BY_SIDE, sceneFile } from "./workbench.mjs";

const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

/** Nothing is there [px]. */
const SKY = { x: 120, y: 240 };
const PHONE = { viewport: { width: 400, height: 820 }, hasTouch: true, isMobile: true };

test("fingers take, carry and release, turn the view, and open the menu", async (t) => {
  const { page, witness } = await browser.workplace(t, {
    studio: [sceneFile(t, "pair", SIDE_BY_SIDE), "--no-robot", "--no-pictures"],
    page: PHONE,
  });
  const fingers = await Fingers.on(page);
  const person = new Person(page, witness, fingers);

  await person.grasp("Coming");
  await person.dragTo("Coming", [0.5, null, null]);
  await person.dragTo("Coming", [null, null, 2]);
  const place = await person.restOf("Coming");

  // One finger beside it goes around; two come nearer and go sideways, also where one of them is on what is held.
  let seen = await look();
  await fingers.press(SKY);
  await fingers.moveTo({ x: SKY.x + 60, y: SKY.y + 20 });
  await fingers.lift();
  let next = await look();
  assert.ok(Math.abs(next.slope - seen.slope) > 0.1, "it is seen from elsewhere");

  seen = next;
  const on = await person.pointOf("Coming");
  await fingers.press(on);
  await fingers.press(on, SKY);
  const apart = [{ x: on.x + 30, y: on.y + 60 }, { x: SKY.x - 30, y: SKY.y - 60 }];
  await fingers.moveTo(...apart);
  next = await look();
  assert.ok(next.width > 1.2 * seen.width, "it is seen from nearer");
  seen = next;
  await fingers.moveTo(...apart.map(({ x, y }) => ({ x: x - 40, y })));
  next = await look();
  assert.ok(Math.abs(next.x - seen.x + 40) < 8, `it follows the fingers: ${next.x - seen.x}`);
  assert.ok(Math.abs(next.width / seen.width - 1) < 0.05, "from as near");
  await fingers.lift();
  assert.deepEqual(await person.restOf("Coming"), place, "it was not carried along");

  await fingers.click(SKY);
  await witness.until(() => !witness.isHolding, "a tap elsewhere releases it");
  await witness.until(() => witness.positionOf("Coming")[2] < 0.6, "and it falls");

  await fingers.press(await person.pointOf("Resting"));
  const menu = await person.openMenu();
  await fingers.lift();
  const { x, y, width, height } = await person.entry("Point to", menu).boundingBox();
  await fingers.click({ x: x + width / 2, y: y + height / 2 });
  const isPointed = ({ kind, object }) => kind === "pointed" && object === "Resting";
  await witness.until(() => witness.events.some(isPointed), "it is pointed at");
  assert.ok(!witness.isHolding, "touching it long does not take it");

  /** How two places of the table are to be seen. */
  async function look() {
    await person.look();
    const [left, right] = [await person.placeOnPage([1, -2, 0]), await person.placeOnPage([-1, -2, 0])];
    const [dx, dy] = [right.x - left.x, right.y - left.y];
    return { x: (left.x + right.x) / 2, width: Math.hypot(dx, dy), slope: Math.atan2(dy, dx) };
  }
});
