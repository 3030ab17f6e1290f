// What a person does at the page, with a real mouse or real fingers: looks, moves, looks again.

import { isDeepStrictEqual } from "node:util";

const CLOSE = 0.04; // [units]
const CLEARANCE = 0.8; // [units]
const MAX_CORRECTIONS = 12;
const MAX_CLICKS = 5;
const CLICK_MS = 2000; // for a click to reach the program, and its news to come back

/** What a person points with. */
export class Mouse {
  constructor({ mouse }) {
    this.mouse = mouse;
  }

  async press({ x, y }) {
    await this.mouse.move(x, y);
    await this.mouse.down();
  }

  async moveTo({ x, y }) {
    await this.mouse.move(x, y, { steps: 2 });
  }

  async lift() {
    await this.mouse.up();
  }

  async click({ x, y }, options) {
    await this.mouse.move(x, y);
    await this.mouse.click(x, y, options);
  }
}

/** Fingers on a touch screen; each event contains the positions of all of them. */
export class Fingers {
  static async on(page) {
    return new Fingers(await page.context().newCDPSession(page));
  }

  constructor(screen) {
    this.screen = screen;
    this.at = [];
  }

  async press(...points) {
    await this.dispatch("touchStart", points);
  }

  /** In few steps: a finger that hardly moves for half a second asks for a menu. */
  async moveTo(...points) {
    const half = points.map(({ x, y }, k) => ({ x: (this.at[k].x + x) / 2, y: (this.at[k].y + y) / 2 }));
    await this.dispatch("touchMove", half);
    await this.dispatch("touchMove", points);
  }

  async lift() {
    await this.dispatch("touchEnd", []);
  }

  async click(point) {
    await this.press(point);
    await this.lift();
  }

  async dispatch(type, points) {
    this.at = points;
    const touchPoints = points.map(({ x, y }, id) => ({ x, y, id }));
    await this.screen.send("Input.dispatchTouchEvent", { type, touchPoints });
  }
}

/** The user of a page. The witness receives the program's messages; the page receives the input. */
export class Person {
  constructor(page, witness, pointer = new Mouse(page)) {
    Object.assign(this, { page, witness, pointer });
  }

  button(name, within = this.page) {
    return within.getByRole("button", { name, exact: true });
  }

  async press(name, within) {
    await this.button(name, within).click();
  }

  async showPanel(name) {
    await this.page.getByRole("tab", { name, exact: true }).click();
  }

  /** Where an object is to be seen [px], as soon as it is. */
  async pointOf(id) {
    const seen = this.page.waitForFunction((object) => window.smileStudio.screenPointOf(object), id);
    const point = await seen.catch(() => Promise.reject(new Error(`${id} is not to be seen`)));
    return point.jsonValue();
  }

  async placeOnPage(point) {
    return this.page.evaluate((place) => window.smileStudio.screenPlaceOf(place), point);
  }

  async click(point, options) {
    await this.pointer.click(point, options);
  }

  /**
   * Takes an object, with this hand or any. The page may just be making room for a panel: then the
   * click goes past the object, and another follows.
   */
  async grasp(id, hand = null) {
    const isIt = () => (hand === null ? this.witness.isHeld(id) : this.witness.state.hands[hand].object === id);
    for (let k = 0; k < MAX_CLICKS && !isIt(); ++k) {
      await this.look();
      await this.click(await this.pointOf(id));
      await this.witness.within(CLICK_MS, isIt);
    }
    await this.witness.until(isIt, `${id} is in ${hand ?? "a"} hand`);
  }

  /** The menu of what is at a place of the world, by a right click, or another if that one went past it. */
  async menuAt(place) {
    for (let k = 1; k < MAX_CLICKS; ++k) {
      await this.look();
      await this.click(await this.placeOnPage(place), { button: "right" });
      const menu = await this.openMenu(CLICK_MS).catch(() => null);
      if (menu !== null) return menu;
    }
    throw new Error(`there is no menu at ${place}`);
  }

  async openMenu(timeout) {
    const menu = this.page.getByRole("menu", { name: /^(Actions for|Aktionen für)/ });
    await menu.waitFor({ timeout });
    return menu;
  }

  entry(name, menu) {
    return menu.getByRole("menuitem", { name: new RegExp(`^${name}`) });
  }

  /** Puts mouse or finger onto what is held, and presses. */
  async take(id) {
    await this.look();
    const point = await this.pointOf(id);
    await this.pointer.press(point);
    return point;
  }

  /**
   * Drags what is held until it is where it must be, as far as that is possible in the plane in
   * which it moves: [x, y, z], null where it does not matter.
   */
  async dragTo(id, wanted) {
    await this.liftIfPressed(await this.dragOn(id, wanted, null));
  }

  /** Continues from where the pointer is pressed, null if it is not yet; returns where it is pressed then. */
  async dragOn(id, wanted, pressed) {
    let [at, before] = [pressed, null];
    for (let k = 0; k < MAX_CORRECTIONS; ++k) {
      const place = await this.restOf(id);
      if (at !== null && isDeepStrictEqual(place, before)) {
        // It was missed: the page may just have made room for a panel.
        await this.pointer.lift();
        at = null;
      }
      before = place;
      const goal = wanted.map((value, axis) => value ?? place[axis]);
      if (Math.hypot(...goal.map((value, axis) => value - place[axis])) < CLOSE) return at;
      const [from, to] = await Promise.all([this.placeOnPage(place), this.placeOnPage(goal)]);
      at ??= await this.take(id);
      at = { x: at.x + to.x - from.x, y: at.y + to.y - from.y };
      await this.pointer.moveTo(at);
    }
    throw new Error(`${id} does not come to ${wanted}`);
  }

  async liftIfPressed(pressed) {
    if (pressed !== null) await this.pointer.lift();
  }

  /** The page reports mouse input to the program with the next picture, and shows the effect in the one after it. */
  async look() {
    const picture = () => new Promise(requestAnimationFrame);
    for (let k = 0; k < 2; ++k) await this.page.evaluate(picture);
  }

  /** Waits until the program has done what was done at the page, and the witness has the state after it. */
  async untilDone() {
    await this.page.evaluate(async () => {
      while (!window.smileStudio.isAnswered()) await new Promise((resolve) => setTimeout(resolve, 4));
    });
    await this.witness.catchUp();
  }

  /** Where the hand wants a held object, after all that was done at the page. */
  async restOf(id) {
    await this.untilDone();
    const hand = this.witness.handOf(id);
    if (hand === undefined) throw new Error(`${id} is not held`);
    return hand.place;
  }

  /** Lifts a held object, then carries it level. */
  async carryAbove(id, place) {
    await this.liftIfPressed(await this.carryOn(id, place));
  }

  /** Lifts, carries and lowers a held object, as people stack: in one drag. */
  async carryOnto(id, [x, y, z], clearance = CLEARANCE) {
    const pressed = await this.carryOn(id, [x, y, z + clearance]);
    await this.liftIfPressed(await this.dragOn(id, [null, null, z], pressed));
  }

  async carryOn(id, [x, y, z]) {
    const pressed = await this.dragOn(id, [null, null, z], null);
    await this.page.keyboard.down("Control");
    const above = await this.dragOn(id, [x, y, null], pressed);
    await this.page.keyboard.up("Control");
    return above;
  }

  /** Types where the held object must be, number after number with Tab between them: { x?, y?, z? }. */
  async typePlace(place) {
    const fields = this.page.getByRole("group", { name: /^Position/ });
    const [first] = Object.keys(place);
    await fields.getByRole("spinbutton", { name: first, exact: true }).focus();
    await this.page.keyboard.press("Control+A");
    for (const value of Object.values(place)) {
      await this.page.keyboard.type(`${value}`);
      await this.page.keyboard.press("Tab");
    }
  }

  /** Takes hold of the ring about an axis at one angle and drags it to another [degrees]. */
  async turnRing(axis, from, to) {
    const pointAt = (degrees) => this.page.evaluate(([a, d]) => window.smileStudio.ringPointOf(a, d), [axis, degrees]);
    await this.pointer.press(await pointAt(from));
    for (let degrees = from; degrees <= to; degrees += 10) await this.pointer.moveTo(await pointAt(degrees));
    await this.pointer.lift();
  }

  /** Drags the thumb of a slider until it has the wanted value, to a step of it. */
  async slideTo(slider, wanted) {
    const step = Number(await slider.getAttribute("step"));
    const isThere = async () => Math.abs(wanted - (await numberOf(slider))) <= step;
    // The page may just be making room: then the hand misses the slider, and takes it again.
    for (let k = 0; k < MAX_CLICKS && !(await isThere()); ++k) await this.dragThumb(slider, wanted, isThere);
    if (!(await isThere())) throw new Error(`the slider does not come to ${wanted}`);
  }

  async dragThumb(slider, wanted, isThere) {
    const { x, y, width, height } = await slider.boundingBox();
    const [min, max] = await slider.evaluate((input) => [input.min, input.max].map(Number));
    const scale = width / (max - min);
    // At both ends half of the thumb is within the slider.
    let at = Math.min(x + width - 4, Math.max(x + 4, x + ((await numberOf(slider)) - min) * scale));
    await this.page.mouse.move(at, y + height / 2);
    await this.page.mouse.down();
    for (let k = 0; k < MAX_CORRECTIONS && !(await isThere()); ++k) {
      // At its ends a slider begins half a thumb further in: there it continues by pixels.
      const way = (wanted - (await numberOf(slider))) * scale;
      at += Math.sign(way) * Math.max(1, Math.abs(way));
      await this.page.mouse.move(at, y + height / 2, { steps: k === 0 ? 8 : 1 });
      await this.look();
    }
    await this.page.mouse.up();
  }

  /** Records what is done; the recording it becomes. */
  async record(deed) {
    await this.press("Record");
    await this.witness.until(() => this.witness.state.recording !== null, "a recording");
    const { id } = this.witness.state.recording;
    await deed();
    await this.finish();
    return id;
  }

  /** Afterwards the recording is open in the timeline. */
  async finish() {
    await this.press("Finish");
    await this.witness.until(() => this.witness.state.recording === null, "the end of the recording");
    await this.button("Play", this.timeline).waitFor();
  }

  get timeline() {
    return this.page.getByRole("region", { name: "Timeline" });
  }

  get segments() {
    return this.timeline.getByRole("list", { name: "Segments" }).getByRole("button");
  }

  async release() {
    await this.press("Release");
    await this.witness.until(() => !this.witness.isHolding, "the hands are empty");
  }
}

/** What a slider shows. */
async function numberOf(slider) {
  return Number(await slider.inputValue());
}
