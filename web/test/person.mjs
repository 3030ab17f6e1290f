// What a person does at the page, with a real mouse: looks, moves, looks again.

import { isDeepStrictEqual } from "node:util";

const CLOSE = 0.04; // [units]
const CLEARANCE = 0.8; // [units]
const MAX_CORRECTIONS = 12;
const MAX_CLICKS = 5;
const CLICK_MS = 2000; // for a click to reach the program, and its news to come back

/** Whoever sits before a page. The witness is told what the program says; the page is what is clicked. */
export class Person {
  constructor(page, witness) {
    Object.assign(this, { page, witness });
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

  /** Where an object is to be seen [px]. */
  async pointOf(id) {
    const point = await this.page.evaluate((object) => window.smileStudio.screenPointOf(object), id);
    if (point === null) throw new Error(`${id} is not to be seen`);
    return point;
  }

  async placeOnPage(point) {
    return this.page.evaluate((place) => window.smileStudio.screenPlaceOf(place), point);
  }

  async click({ x, y }, options) {
    await this.page.mouse.move(x, y);
    await this.page.mouse.click(x, y, options);
  }

  /** The page may just be making room for a panel: then the click goes past the object, and another follows. */
  async grasp(id) {
    for (let k = 0; k < MAX_CLICKS && !this.witness.isHeld(id); ++k) {
      await this.look();
      await this.click(await this.pointOf(id));
      await this.witness.within(CLICK_MS, () => this.witness.isHeld(id));
    }
    await this.witness.until(() => this.witness.isHeld(id), `${id} is in a hand`);
  }

  /** Puts the mouse onto what is held, and presses. */
  async take(id) {
    const { x, y } = await this.pointOf(id);
    await this.page.mouse.move(x, y);
    await this.page.mouse.down();
    return { x, y };
  }

  /**
   * Drags what is held until it is where it shall be, as far as that is possible in the plane in
   * which it moves: [x, y, z], null where it does not matter.
   */
  async dragTo(id, wanted) {
    let mouse = await this.take(id);
    let before = null;
    for (let k = 0; k < MAX_CORRECTIONS; ++k) {
      const place = await this.restOf(id);
      if (isDeepStrictEqual(place, before)) {
        // It was missed: the page may just have made room for a panel.
        await this.page.mouse.up();
        mouse = await this.take(id);
      }
      before = place;
      const goal = wanted.map((value, axis) => value ?? place[axis]);
      if (Math.hypot(...goal.map((value, axis) => value - place[axis])) < CLOSE) {
        await this.page.mouse.up();
        return;
      }
      const [from, to] = [await this.placeOnPage(place), await this.placeOnPage(goal)];
      mouse = { x: mouse.x + to.x - from.x, y: mouse.y + to.y - from.y };
      await this.page.mouse.move(mouse.x, mouse.y, { steps: k === 0 ? 8 : 2 });
      await this.look();
    }
    throw new Error(`${id} does not come to ${wanted}`);
  }

  /** What the mouse did is told to the program with the next picture, and seen in the one after it. */
  async look() {
    const picture = () => new Promise(requestAnimationFrame);
    for (let k = 0; k < 2; ++k) await this.page.evaluate(picture);
  }

  /** Where the hand wants a held object, as soon as that stays the same. */
  restOf(id) {
    return this.witness.settled(() => this.witness.handOf(id)?.place, `${id} is held still`, 150);
  }

  /** Lifts a held object, then carries it level. */
  async carryAbove(id, [x, y, z]) {
    await this.dragTo(id, [null, null, z]);
    await this.page.keyboard.down("Control");
    await this.dragTo(id, [x, y, null]);
    await this.page.keyboard.up("Control");
  }

  /** Lifts, carries and lowers a held object, as people stack. */
  async carryOnto(id, [x, y, z]) {
    await this.carryAbove(id, [x, y, z + CLEARANCE]);
    await this.dragTo(id, [null, null, z]);
  }

  /** Takes hold of the ring about an axis at one angle and drags it to another [degrees]. */
  async turnRing(axis, from, to) {
    const pointAt = (degrees) => this.page.evaluate(([a, d]) => window.smileStudio.ringPointOf(a, d), [axis, degrees]);
    const begin = await pointAt(from);
    await this.page.mouse.move(begin.x, begin.y);
    await this.page.mouse.down();
    for (let degrees = from; degrees <= to; degrees += 10) {
      const { x, y } = await pointAt(degrees);
      await this.page.mouse.move(x, y);
    }
    await this.page.mouse.up();
  }

  /** Drags the thumb of a slider until it stands where it shall, to a step of it. */
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
    let at = x + ((await numberOf(slider)) - min) * scale;
    await this.page.mouse.move(at, y + height / 2);
    await this.page.mouse.down();
    for (let k = 0; k < MAX_CORRECTIONS && !(await isThere()); ++k) {
      // At its ends a slider begins half a thumb further in: there one goes on by pixels.
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
