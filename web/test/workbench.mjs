// What the browser tests stand on: a studio of their own, with its own folder of recordings, and
// pages of a real browser in it. The tests ask the program for the truth, not the page.

import assert from "node:assert/strict";
import { spawn, execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { isDeepStrictEqual } from "node:util";
import { chromium } from "playwright-core";
import WebSocket from "ws";
import { Person } from "./person.mjs";

export const SMILE = process.env.SMILE ?? "build/dev/bin/smile";
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const PATIENCE_MS = 20_000;
const BROWSER_OPTIONS = [
  "--use-gl=angle",
  "--use-angle=gl-egl",
  "--ignore-gpu-blocklist",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/** Two blocks that stand alike, 2 units apart. */
export const SIDE_BY_SIDE = `<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="Resting" location="(-1.5,-2,0.5)" color="red"/>
  <block id="Coming" location="(1.5,-2.1,0.5)" color="blue"/>
</tabletop>
`;

/** A file with a scene, as long as the test lasts. */
export function sceneFile(t, name, xml) {
  const folder = mkdtempSync(join(tmpdir(), "smile-scene-"));
  t.after(() => rmSync(folder, { recursive: true }));
  const path = join(folder, `${name}.xml`);
  writeFileSync(path, xml);
  return path;
}

/** What the program answers to a command that prints JSON. */
export function programSays(words) {
  const printed = execFileSync(SMILE, [...words, "--json"], { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
  return JSON.parse(printed);
}

/** Runs a recording again; what the program has to say of it. */
export function replay(recording) {
  return programSays(["replay", recording, "--verify"]);
}

/** A running studio. `close()` ends it and takes its recordings away. */
export class Studio {
  /** @param maxFileBytes  larger files cannot be written, as if the disk were full */
  static async start(words = [], { maxFileBytes = null } = {}) {
    const folder = mkdtempSync(join(tmpdir(), "smile-studio-"));
    const recordings = join(folder, "recordings");
    const command = [SMILE, "studio", ...words, "--no-open", "--recordings", recordings];
    // The shell's blocks are of 512 bytes; the signal, once ignored, stays so.
    const limited = `trap '' XFSZ; ulimit -f ${Math.floor(maxFileBytes / 512)}; exec "$0" "$@"`;
    const [program, ...args] = maxFileBytes === null ? command : ["/bin/sh", "-c", limited, ...command];
    const child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
    const link = await firstLink(child);
    return new Studio(child, link, folder, recordings);
  }

  constructor(child, link, folder, recordings) {
    Object.assign(this, { child, link, folder, recordings });
    this.whenClosed = [];
  }

  /** Where a WebSocket may come in, with the token if there is one. */
  get door() {
    const door = new URL("/ws", this.link);
    door.protocol = "ws:";
    door.search = new URL(this.link).search;
    return door.href;
  }

  async close() {
    for (const close of this.whenClosed) await close();
    const ended = new Promise((resolve) => this.child.once("exit", resolve));
    this.child.kill("SIGINT");
    const code = await ended;
    rmSync(this.folder, { recursive: true });
    return code;
  }
}

/** The first link that the child prints. */
function firstLink(child) {
  return new Promise((resolve, reject) => {
    let printed = "";
    const read = (line) => {
      printed += `${line}\n`;
      const link = /https?:\/\/\S+/.exec(line)?.[0];
      if (link) resolve(link);
    };
    createInterface({ input: child.stdout }).on("line", read);
    createInterface({ input: child.stderr }).on("line", read);
    child.once("exit", (code) => reject(new Error(`the studio ended with ${code}:\n${printed}`)));
  });
}

/** The browser of a file of tests: each of them has a studio of its own in it. */
export class Browser {
  /** @param isComposedByGl  as in people's browsers; without a graphics card each picture then takes twice the time */
  async start({ isComposedByGl = false } = {}) {
    this.browser = await chromium.launch({
      executablePath: CHROMIUM,
      chromiumSandbox: process.getuid() !== 0,
      args: isComposedByGl ? BROWSER_OPTIONS : [...BROWSER_OPTIONS, "--disable-gpu-compositing"],
    });
  }

  close() {
    return this.browser.close();
  }

  /** A studio, a person at its page, and a witness; at the end of the test all go, and the page has not complained. */
  async workplace(t, { studio: words = [], maxFileBytes = null, page: options = {}, likes = {} } = {}) {
    const studio = await Studio.start(words, { maxFileBytes });
    t.after(() => studio.close());
    const witness = await Witness.of(studio);
    const page = await this.open(studio, options, likes);
    t.after(() => assert.deepEqual(page.complaints, []));
    const person = new Person(page, witness);
    return { studio, page, witness, person };
  }

  /** A page of a user with these preferences; it is connected and shows its world. */
  async open(studio, options = {}, likes = {}) {
    const context = await this.browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: "reduce",
      ...options,
    });
    studio.whenClosed.push(() => context.close());
    await context.addInitScript((known) => {
      for (const [name, value] of Object.entries(known)) {
        const key = `smile-studio.${name}`;
        if (localStorage.getItem(key) === null) localStorage.setItem(key, JSON.stringify(value));
      }
    }, { "tour-known": true, ...likes });
    await context.addInitScript(() => {
      const look = () => {
        if (window.smileStudio?.stats().isShown) window.firstPictureAt = performance.now();
        else requestAnimationFrame(look);
      };
      look();
    });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE_MS);
    page.complaints = [];
    page.on("pageerror", (error) => page.complaints.push(String(error)));
    page.on("console", (message) => {
      const { url } = message.location();
      // A segment may be taken back while its picture is on the way.
      const isOfSegment = /\/segments\/\d+\.png/.test(url);
      if (message.type() === "error" && !isOfSegment) page.complaints.push(`${message.text()} ${url}`);
    });
    await page.goto(studio.link);
    await page.waitForFunction(() => window.firstPictureAt !== undefined);
    return page;
  }
}

/** The program's own view of things: a watcher of the studio without a page. */
export class Witness {
  static async of(studio) {
    const witness = new Witness(new WebSocket(studio.door));
    await new Promise((resolve, reject) => {
      witness.socket.onopen = resolve;
      witness.socket.onerror = reject;
    });
    await witness.request("hello", { version: 1 });
    await witness.until(() => witness.state !== null && witness.poses.size > 0, "the state of the world");
    studio.whenClosed.push(() => witness.socket.close());
    return witness;
  }

  constructor(socket) {
    this.socket = socket;
    this.scene = null;
    this.state = null;
    this.poses = new Map();
    this.events = [];
    this.replies = new Map();
    this.seq = 0;
    socket.binaryType = "arraybuffer";
    socket.onmessage = ({ data }) => this.receive(data);
  }

  receive(data) {
    if (typeof data !== "string") return this.receivePoses(new DataView(data));
    const news = JSON.parse(data);
    if (news.t === "reply") this.replies.get(news.seq)?.(news);
    if (news.t === "scene") this.enter(news);
    if (news.t === "state") this.state = news;
    if (news.t === "event") this.events.push(news);
  }

  /** The scene has other frames; the next message contains their poses. */
  enter(scene) {
    this.scene = scene;
    this.poses.clear();
  }

  receivePoses(data) {
    if (data.getUint8(0) !== 1 || data.getUint32(4, true) !== this.scene?.scene) return;
    for (let k = 0; k < data.getUint16(2, true); ++k) {
      const at = 16 + 32 * k;
      const numbers = [0, 1, 2, 3, 4, 5, 6].map((i) => data.getFloat32(at + 4 + 4 * i, true));
      this.poses.set(data.getUint32(at, true), numbers);
    }
  }

  request(what, fields = {}) {
    const seq = ++this.seq;
    this.socket.send(JSON.stringify({ ...fields, seq, do: what }));
    return new Promise((resolve) => this.replies.set(seq, resolve));
  }

  /** Of the objects that are there. */
  get ids() {
    return this.scene.objects.map(({ id }) => id).filter((id) => !this.state.gone.includes(id));
  }

  /** Position of an object, in units; NaN until it is reported. */
  positionOf(id) {
    const { frame } = this.scene.objects.find((object) => object.id === id);
    return this.poses.get(frame)?.slice(0, 3) ?? [NaN, NaN, NaN];
  }

  /** How far an upright object is turned about the vertical [degrees]. */
  yawOf(id) {
    const { frame } = this.scene.objects.find((object) => object.id === id);
    const [z, w] = this.poses.get(frame).slice(5, 7);
    return (2 * Math.atan2(z, w) * 180) / Math.PI;
  }

  /** The hand that holds an object, according to the state. */
  handOf(id) {
    return Object.values(this.state.hands).find((hand) => hand.object === id);
  }

  isHeld(id) {
    return this.handOf(id) !== undefined;
  }

  get isHolding() {
    return Object.values(this.state.hands).some((hand) => hand.object !== null);
  }

  /** Waits until a condition holds; else fails and reports what was awaited. */
  async until(holds, what = holds.toString()) {
    if (!(await this.within(PATIENCE_MS, holds))) throw new Error(`this never came: ${what}`);
  }

  /** Waits for the state after all that the program has answered so far: one of the next three frames ends with it. */
  async catchUp() {
    // Each request is refused, as a witness does not control, but not in the frame of the one before.
    for (let k = 0; k < 3; ++k) await this.request("allowed", { requests: [] });
  }

  /** What is read, as soon as it is there and stays the same for this time. */
  async settled(read, what, milliseconds) {
    let [before, since] = [null, 0];
    await this.until(() => {
      const now = read() ?? null;
      if (!isDeepStrictEqual(now, before)) [before, since] = [now, Date.now()];
      return before !== null && Date.now() - since > milliseconds;
    }, what);
    return before;
  }

  /** Whether something came to hold in this time. */
  async within(milliseconds, holds) {
    const deadline = Date.now() + milliseconds;
    while (!holds()) {
      if (Date.now() > deadline) return false;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    return true;
  }
}
