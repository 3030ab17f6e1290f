// A study with scripted participants: in a real browser, with a real mouse, side by side.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { connect, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, before, test } from "node:test";
import { Participant, StudyServer } from "./participant.mjs";
import { numbersOf, ScriptedParticipant } from "./scripted_participant.mjs";
import { Browser, replay, SMILE } from "./workbench.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const SHIPPED = fileURLToPath(new URL("../../studies/demonstrators/STUDY.json", import.meta.url));
const browser = new Browser();
before(() => browser.start());
after(() => browser.close());

const PAIR = `<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="Red" location="(-1.5,-2,0.5)" color="red"/>
  <block id="Blue" location="(1.5,-2,0.5)" color="blue"/>
</tabletop>
`;
const trial = { title: "Stack", text: "Put the red block on the blue one.", scene: "pair.xml", goal: [{ object: "Red", on: "Blue" }] };
const STUDY = {
  format: 1,
  name: "short",
  title: "A short study",
  consent: "consent.txt",
  conditions: [{ name: "plain", ghost: false, rings: false }, { name: "aided", snap: ["faces"] }],
  instructions: [{ title: "Welcome", text: "Read this." }],
  practice: { ...trial, max_attempts: 2 },
  tasks: [{ ...trial, name: "stack", limit_seconds: 300 }],
  break_seconds: 1,
  after_condition: [{ type: "nasa-tlx" }],
  at_end: [{ type: "survey-likert", name: "end", questions: [{ prompt: "It was easy.", name: "easy", labels: ["no", "yes"] }] }],
  thanks: "That was all.",
};

function smile(...words) {
  return execFileSync(SMILE, words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}

/** A study in a folder of its own, and its server, which may be started again. */
class Study {
  constructor(study) {
    this.folder = mkdtempSync(join(tmpdir(), "smile-study-"));
    this.data = join(this.folder, "data");
    writeFileSync(join(this.folder, "consent.txt"), "You may stop at any time.\n");
    writeFileSync(join(this.folder, "pair.xml"), PAIR);
    writeFileSync(join(this.folder, "STUDY.json"), JSON.stringify(study, null, 2));
  }

  async serve(participants, port = 0, more = []) {
    this.server = await StudyServer.start(join(this.folder, "STUDY.json"), this.data, participants, port, more);
    return this.server.links;
  }

  stop(signal) {
    return this.server.stop(signal);
  }

  remove() {
    rmSync(this.folder, { recursive: true });
  }

  eventsOf(id) {
    return readFileSync(join(this.data, id, "events.jsonl"), "utf8").trim().split("\n").map((line) => JSON.parse(line));
  }
}

/** A participant of this study. */
class Stacker extends Participant {
  async stack() {
    const person = await this.table();
    await person.grasp("Red");
    await person.carryOnto("Red", [1.5, -2, 1.5]);
    await person.release();
    await this.leaveTable();
  }

  async answerScales() {
    await this.sees("Questions");
    await this.answer(() => 0.35);
  }

  async beginStudy() {
    await this.press("I agree");
    await this.sees("Welcome");
    await this.press("Continue");
    await this.sees("Stack");
  }

  async doCondition() {
    await this.press("Begin");
    await this.stack();
    await this.answerScales();
  }

  async end() {
    await this.answer(() => 1);
    await this.sees("Thank you");
    return this.page.locator(".study-code").textContent();
  }
}

async function holdsNothingAgainst(page, state) {
  await page.evaluate(AXE);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await page.waitForFunction((theme) => document.documentElement.dataset.theme === theme, colorScheme);
    const violations = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }).then((found) => found.violations));
    const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
    assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), [], `${state}, ${colorScheme}`);
  }
}

/** All of a short study. */
async function takePart(link) {
  const participant = await Stacker.at(browser.browser, link);
  await participant.beginStudy();
  await participant.press("Begin");
  await participant.stack();
  await participant.doCondition();
  await participant.sees("A short break");
  await participant.press("Continue");
  await participant.doCondition();
  const code = await participant.end();
  await participant.context.close();
  return code;
}

test("participants take part side by side, from the consent to the completion code; their data is complete", async (t) => {
  const study = new Study(STUDY);
  t.after(() => study.remove());
  const links = await study.serve(2);
  const codes = await Promise.all(links.map(takePart)).finally(() => study.stop());
  assert.match(codes[0], /^[0-9A-F]{8}$/);
  assert.notEqual(codes[0], codes[1]);

  assert.match(smile("study", "check", study.data), /2 complete.*\nnothing is missing, and the order is balanced/);
  smile("study", "report", study.data);
  const [head, ...rows] = readFileSync(join(study.data, "report/trials.csv"), "utf8").trim().split("\r\n").map((line) => line.split(","));
  const column = (name) => rows.map((row) => row[head.indexOf(name)]);
  assert.deepEqual(column("participant"), ["P01", "P01", "P02", "P02"]);
  assert.deepEqual(column("condition"), ["plain", "aided", "aided", "plain"]);
  assert.deepEqual(column("success"), ["1", "1", "1", "1"]);
  assert.ok(column("path_meters").every((length) => Number(length) > 0.3), column("path_meters").join());
  for (const recording of column("recording")) {
    assert.equal(replay(join(study.data, recording)).identical, true, recording);
    assert.match(readFileSync(join(study.data, recording, "../input.jsonl"), "utf8"), /"kind":"move"/);
  }
  const answers = readFileSync(join(study.data, "report/answers.csv"), "utf8");
  assert.equal(answers.match(/nasa-tlx,score,35/g).length, 4);
  // Nothing says who they are.
  for (const id of ["P01", "P02"]) assert.doesNotMatch(JSON.stringify(study.eventsOf(id)), /127\.0\.0\.1|Mozilla/);

  assert.match(smile("study", "delete", study.data, "P02"), /nothing of the participant is left/);
  assert.equal(existsSync(join(study.data, "P02")), false);
  assert.match(smile("study", "report", study.data), /report\.html/);
});

test("the page is in the language of the study, whatever the browser prefers", async (t) => {
  const study = new Study({ ...STUDY, language: "de" });
  t.after(() => study.remove());
  const [link] = await study.serve(1);
  t.after(() => study.stop());
  const participant = await Stacker.at(browser.browser, link);
  await participant.press("Ich willige ein");
  await participant.sees("Welcome");
  await participant.press("Weiter");
  assert.equal(await participant.page.evaluate(() => `${document.documentElement.lang} ${navigator.language.slice(0, 2)}`), "de en");
  await participant.context.close();
});

test("a participant continues after closing the page, and after the server was killed", async (t) => {
  const study = new Study(STUDY);
  t.after(() => study.remove());
  const [link] = await study.serve(1);
  t.after(() => study.stop());
  const participant = await Stacker.at(browser.browser, link);
  await participant.beginStudy();
  await participant.press("Begin");
  // Practice is repeated until it succeeds.
  await participant.table();
  await participant.leaveTable();
  await participant.page.getByText("Not quite. Please try again: attempt 2 of 2.").waitFor();
  await participant.press("Begin");
  const person = await participant.table();
  await person.grasp("Red");
  // The page is closed in the middle of a trial: the block stays in the hand.
  await participant.dismissWitness();
  await participant.page.reload();
  const again = await participant.table();
  assert.equal(again.witness.isHeld("Red"), true);
  await again.carryOnto("Red", [1.5, -2, 1.5]);
  await again.release();
  await participant.leaveTable();
  await participant.press("Begin");
  await participant.table();
  await study.stop("SIGKILL");
  await study.serve(1, new URL(link).port);
  await participant.page.getByText("The last trial was interrupted, so please do it again.").waitFor();
  await participant.press("Begin");
  await participant.stack();
  await participant.sees("Questions");
  await participant.context.close();
  const trials = study.eventsOf("P01").filter(({ event }) => event === "trial_end");
  assert.deepEqual(
    trials.map(({ step, reason, success }) => [step, reason, success]),
    [
      ["practice", "done", false],
      ["practice", "done", true],
      ["task-stack-plain", "server", false],
      ["task-stack-plain", "done", true],
    ].map(([step, reason, success]) => [step, reason, reason === "server" ? undefined : success]),
  );
  assert.equal(readdirSync(join(study.data, "P01/trials")).length, 4);
});

/** A proxy as in front of public servers: it passes all bytes on. @returns where it listens */
async function startProxy(t, portBehind) {
  const proxy = createServer((socket) => {
    const behind = connect(portBehind, "127.0.0.1");
    for (const [one, other] of [[socket, behind], [behind, socket]]) one.pipe(other).on("error", () => one.destroy());
  });
  await new Promise((resolve) => proxy.listen(0, "127.0.0.1", resolve));
  t.after(() => proxy.close());
  return proxy.address().port;
}

test("participants come through a proxy with a public name", async (t) => {
  const study = new Study({ ...STUDY, practice: undefined });
  t.after(() => study.remove());
  const [own] = await study.serve(1);
  await study.stop();
  const { port } = new URL(own);
  const name = `http://lab.localhost:${await startProxy(t, Number(port))}`;
  const [link] = await study.serve(1, port, ["--public-url", name]);
  t.after(() => study.stop());
  assert.equal(link, `${name}${new URL(own).pathname}`);
  const participant = await Stacker.at(browser.browser, link);
  await participant.beginStudy();
  await participant.press("Begin");
  const { witness } = await participant.table(own);
  assert.deepEqual(witness.ids, ["Red", "Blue"]);
  await participant.leaveTable();
  await participant.sees("Questions");
  await participant.context.close();
});

test("a shipped study is done from its consent to its completion code", async (t) => {
  const data = mkdtempSync(join(tmpdir(), "smile-study-"));
  t.after(() => rmSync(data, { recursive: true }));
  const server = await StudyServer.start(SHIPPED, join(data, "data"), 1);
  t.after(() => server.stop());
  const participant = await ScriptedParticipant.at(browser.browser, server.links[0]);
  assert.match(await participant.takePart(numbersOf(0)), /^[0-9A-F]{8}$/);
  await participant.context.close();
  smile("study", "report", join(data, "data"));
  const [head, ...rows] = readFileSync(join(data, "data/report/trials.csv"), "utf8").trim().split("\r\n").map((line) => line.split(","));
  assert.deepEqual(rows.map((row) => row[head.indexOf("success")]), ["1", "1", "1"]);
});

test("axe-core finds no serious barrier, and a session does nothing that is not part of the study", async (t) => {
  const study = new Study({ ...STUDY, practice: undefined });
  t.after(() => study.remove());
  const [link] = await study.serve(1);
  t.after(() => study.stop());
  const participant = await Stacker.at(browser.browser, link, { viewport: { width: 390, height: 844 } });
  const { page } = participant;
  await participant.sees("Your consent");
  await holdsNothingAgainst(page, "consent");
  await participant.beginStudy();
  await holdsNothingAgainst(page, "task");
  await participant.press("Begin");
  const { witness } = await participant.table();
  await holdsNothingAgainst(page, "table");
  for (const what of ["load", "start_brain", "pause", "library", "generate"]) {
    assert.match((await witness.request(what)).error.say, /^(study.isNotPart|control.isMissing)$/, what);
  }
  const { allowed } = witness.state;
  assert.deepEqual(allowed.requests.load, { say: "study.isNotPart" });
  assert.equal(allowed.requests.command, true);
  await participant.leaveTable();
  await participant.sees("Questions");
  await participant.press("Continue");
  await page.getByText("6 answers are missing.").waitFor();
  await holdsNothingAgainst(page, "questions");
  await participant.answerScales();
  await participant.context.close();
  // Without a link there is no study.
  const stranger = await Stacker.at(browser.browser, new URL("/", link).href);
  await stranger.page.getByText("This is not a link of a participant.").waitFor();
  await stranger.page.goto(`${new URL("/p/", link).href}${"0".repeat(32)}`);
  await stranger.page.getByText("there is no such page").waitFor();
  await stranger.context.close();
});
