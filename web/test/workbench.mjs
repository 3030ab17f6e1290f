// What the browser tests stand on: a studio of their own, with its own folder of recordings, and
// pages of a real browser in it. Whoever asks what is true asks the program, not the page.

import { spawn, execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { chromium } from "playwright-core";
import WebSocket from "ws";

const SMILE = process.env.SMILE ?? "build/dev/bin/smile";
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

/** Runs the program to its end; what it prints, or an error with all of it. */
export function smile(...words) {
  return execFileSync(SMILE, words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}

/** A running studio. `close()` ends it and takes its recordings away. */
export class Studio {
  static async start(...words) {
    const folder = mkdtempSync(join(tmpdir(), "smile-studio-"));
    const recordings = join(folder, "recordings");
    const child = spawn(SMILE, ["studio", ...words, "--no-open", "--recordings", recordings], {
      stdio: ["ignore", "pipe", "pipe"],
    });
    const link = await firstLink(child);
    return new Studio(child, link, folder, recordings);
  }

  constructor(child, link, folder, recordings) {
    Object.assign(this, { child, link, folder, recordings });
  }

  async close() {
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

export function startBrowser() {
  return chromium.launch({
    executablePath: CHROMIUM,
    chromiumSandbox: process.getuid() !== 0,
    args: BROWSER_OPTIONS,
  });
}

/** A page that is connected and shows its world. Its console must stay free of errors. */
export async function openPage(browser, studio, { tour = false, ...options } = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    reducedMotion: "reduce",
    ...options,
  });
  if (!tour) await context.addInitScript(() => localStorage.setItem("smile.tour", "seen"));
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") page.complaints.push(message.text());
  });
  await page.goto(studio.link);
  await page.waitForFunction(() => window.smileStudio?.stats().numFramesDrawn > 0);
  return page;
}

/** The program's own view of things: a watcher of the studio without a page. */
export class Witness {
  static async of(studio) {
    const witness = new Witness(new WebSocket(studio.link.replace(/^http/, "ws") + "ws"));
    await new Promise((resolve, reject) => {
      witness.socket.onopen = resolve;
      witness.socket.onerror = reject;
    });
    await witness.request("hello", { version: 1 });
    await witness.until(() => witness.state !== null);
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
    if (news.t === "scene") this.scene = news;
    if (news.t === "state") this.state = news;
    if (news.t === "event") this.events.push(news);
  }

  receivePoses(data) {
    if (data.getUint8(0) !== 1) return;
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

  /** Where an object is, in units. */
  positionOf(id) {
    const { frame } = this.scene.objects.find((object) => object.id === id);
    return this.poses.get(frame)?.slice(0, 3);
  }

  poseOf(id) {
    const { frame } = this.scene.objects.find((object) => object.id === id);
    return this.poses.get(frame);
  }

  /** Waits until something holds; else fails and tells what was awaited. */
  async until(holds, what = holds.toString()) {
    const deadline = Date.now() + PATIENCE_MS;
    while (!holds()) {
      if (Date.now() > deadline) throw new Error(`this never came: ${what}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  close() {
    this.socket.close();
  }
}
