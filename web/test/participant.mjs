// Participants of a study in a real browser, and the program that serves them.

import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { Person } from "./person.mjs";
import { SMILE, Witness } from "./workbench.mjs";

const PATIENCE_MS = 60_000; // sessions, a browser and the participants share a few cores

/** The program that serves a study, and the links of its participants. */
export class StudyServer {
  /** @param file  the definition of the study */
  static async start(file, data, participants, port = 0, more = []) {
    const words = ["study", file, "--data", data, "--participants", `${participants}`, "--port", `${port}`, ...more];
    const child = spawn(SMILE, words, { stdio: ["ignore", "pipe", "inherit"] });
    const links = [];
    for await (const line of createInterface({ input: child.stdout })) {
      links.push(line.split(" ")[1]);
      if (links.length === participants) return new StudyServer(child, links);
    }
    throw new Error("the server ended");
  }

  constructor(child, links) {
    Object.assign(this, { child, links });
  }

  /** @param signal  SIGINT, or SIGKILL as when the machine loses power */
  async stop(signal = "SIGINT") {
    const ended = new Promise((resolve) => this.child.once("exit", resolve));
    this.child.kill(signal);
    await ended;
  }
}

/** A participant at a page. */
export class Participant {
  static async at(browser, link, options = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE_MS);
    await page.goto(link);
    return new this(context, page, link);
  }

  constructor(context, page, link) {
    Object.assign(this, { context, page, link });
  }

  async press(name) {
    await this.page.getByRole("button", { name, exact: true, disabled: false }).click();
  }

  async sees(heading) {
    await this.page.getByRole("heading", { name: heading, exact: true }).waitFor();
  }

  /** The table of a trial, once it is recorded. @param door  the link of the server itself, if a proxy is before it */
  async table(door = this.link) {
    await this.page.getByRole("button", { name: "I am done", disabled: false }).waitFor();
    const link = new URL(door);
    this.whenClosed = [];
    const witness = await Witness.of({ door: `ws://${link.host}${link.pathname}/session/ws`, whenClosed: this.whenClosed });
    // A recording that begins has a scene of its own, whose poses come after it.
    await witness.until(() => witness.state.recording !== null && witness.poses.size > 0, "a recording");
    await this.page.waitForFunction(() => window.smileStudio?.stats().isShown);
    return new Person(this.page, witness);
  }

  /** The witness leaves first: the page alone controls. */
  async dismissWitness() {
    this.whenClosed.forEach((close) => close());
  }

  async leaveTable() {
    await this.dismissWitness();
    await this.press("I am done");
  }

  /** Does what ends a step of the study, and waits until the step has left the page: the next one may look the same. */
  async leaveStep(deed) {
    const step = await this.page.locator(".study-step > *").elementHandle();
    await deed();
    await step.waitForElementState("hidden");
  }

  /** Answers all questions, each as `choose` says: a share of the way from the first answer to the last. */
  async answer(choose) {
    for (const slider of await this.page.getByRole("slider").all()) await slider.fill(`${5 * Math.round(20 * choose())}`);
    for (const question of await this.page.locator(".study-choices").all()) {
      const choices = await question.getByRole("radio").all();
      await choices[Math.min(choices.length - 1, Math.floor(choices.length * choose()))].check();
    }
    await this.leaveStep(() => this.press("Continue"));
  }
}
