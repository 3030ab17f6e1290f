// A participant who does all of a shipped study: reads, practices, demonstrates and answers; now and then takes the wrong
// object first, and undoes that. Answers are drawn by the participant's number and mean nothing.

import { Participant } from "./participant.mjs";

const STEP_MS = 240_000; // of the longest trial and break
const TURN_DEGREES = 5;
const STACKED = 1; // [units] from block to block

/** What the tables of the shipped studies ask for: what is put where, by an object that only this table has. */
const DEEDS = {
  GreenBlock: [
    { take: "GreenBlock", onto: "RedBlock", isAligned: true },
    { take: "BlueBlock", onto: "GreenBlock", isAligned: true },
  ],
  Case: [
    { take: "Cyan", to: [-1.4, 1.5, 0.71] },
    { take: "Yellow", to: [0, 1.5, 0.71] },
    { take: "Magenta", to: [1.4, 1.5, 0.71] },
  ],
  Plank: [
    { take: "Red", to: [-1.5, -2, 0.51] },
    { take: "Blue", to: [1.5, -2, 0.51] },
    { take: "Plank", to: [0, -2, 1.51] },
  ],
  Yellow: [{ take: "Red", onto: "Yellow" }],
};

/** Numbers from 0 to 1 that look random, the same ones for the same participant. */
export function numbersOf(participant) {
  let state = 0x9e3779b9 * (participant + 1);
  return () => {
    state = (Math.imul(state ^ (state >>> 15), 0x2c1b3c6d) + 0x297a2d39) >>> 0;
    return ((state ^ (state >>> 12)) >>> 0) / 2 ** 32;
  };
}

export class ScriptedParticipant extends Participant {
  /** Goes from step to step until the completion code, which is returned. */
  async takePart(choose) {
    this.choose = choose;
    const code = this.page.locator(".study-code");
    const agree = this.page.getByRole("button", { name: "I agree" });
    const begin = this.page.getByRole("button", { name: "Begin", disabled: false });
    const next = this.page.getByRole("button", { name: "Continue", disabled: false });
    for (;;) {
      await code.or(agree).or(begin).or(next).first().waitFor({ timeout: STEP_MS });
      if (await code.isVisible()) return code.textContent();
      if (await agree.isVisible()) await this.leaveStep(() => agree.click());
      else if (await begin.isVisible()) await this.leaveStep(() => this.doTrial(begin));
      else await this.answer(choose);
    }
  }

  async doTrial(begin) {
    await begin.click();
    const person = await this.table();
    const { ids } = person.witness;
    const [, deeds] = Object.entries(DEEDS).find(([id]) => ids.includes(id));
    if (this.choose() < 0.3) await this.takeWrongly(person, deeds.at(-1).take);
    for (const deed of deeds) await this.do(person, deed);
    await this.leaveTable();
  }

  async takeWrongly(person, id) {
    await person.grasp(id);
    await this.press("Undo");
    await person.witness.until(() => !person.witness.isHolding, "the hands are empty");
  }

  async do(person, { take, onto, to, isAligned = false }) {
    const place = to ?? person.witness.positionOf(onto).map((value, axis) => (axis === 2 ? value + STACKED : value));
    await person.grasp(take);
    if (isAligned) await this.align(person, take, person.witness.yawOf(onto));
    await person.carryOnto(take, place);
    await person.release();
  }

  /** Turns what is held by the buttons, until its sides are parallel to those of another one. */
  async align(person, id, yaw) {
    const steps = Math.round((yaw - person.witness.yawOf(id)) / TURN_DEGREES);
    const button = this.page.getByRole("button", { name: `Turn the held object by ${Math.sign(steps) * TURN_DEGREES} degrees` });
    for (let k = 0; k < Math.abs(steps); ++k) await button.click();
    await person.untilDone();
  }
}
