// A program with the page on a MuJoCo model, in a folder of its own.

import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { createInterface } from "node:readline";

const SMILE = resolve(process.env.SMILE ?? "build/dev/bin/smile");
const PROJECT = resolve(import.meta.dirname, "../..");
const MUJOCO = join(PROJECT, "build/mujoco");
const PYTHON = "/usr/bin/python3";
const PYTHONPATH = [join(PROJECT, "python"), join(dirname(dirname(SMILE)), "python"), MUJOCO].join(":");
const REPLAY = `
import json, sys
from smile.adapters.mujoco import replay
on = replay(sys.argv[1], sys.argv[2])
print(json.dumps({"poses": {id: pose.tolist() for id, pose in on.poses.items()}, "done": [row["do"] for row in on.events]}))`;

/** Whether tools/get_mujoco.sh could install it. */
export const hasMujoco = existsSync(MUJOCO);

export class MujocoProgram {
  /** @param model text of an MJCF file */
  static async start(t, model) {
    const folder = mkdtempSync(join(tmpdir(), "smile-mujoco-"));
    const program = new MujocoProgram(folder, join(folder, "model.xml"));
    writeFileSync(program.model, model);
    const child = spawn(PYTHON, ["-B", "-m", "smile.adapters.mujoco", program.model], {
      cwd: folder,
      env: { ...process.env, PYTHONPATH },
      stdio: ["ignore", "pipe", "inherit"],
    });
    const ended = new Promise((done) => child.once("exit", done));
    t.after(async () => {
      for (const close of program.whenClosed) await close();
      child.kill("SIGINT");
      await ended;
      rmSync(folder, { recursive: true });
    });
    const { value } = await createInterface({ input: child.stdout })[Symbol.asyncIterator]().next();
    program.link = value;
    return program;
  }

  constructor(folder, model) {
    Object.assign(this, { folder, model, whenClosed: [] });
  }

  /** Where a WebSocket may come in. */
  get door() {
    return new URL("/ws", this.link).href.replace(/^http/, "ws");
  }

  get recordings() {
    return readdirSync(join(this.folder, "recordings")).map((file) => join(this.folder, "recordings", file));
  }

  /** Carries a recording out again in MuJoCo: where things are at its end, and what hands did. */
  replay(recording) {
    const options = { encoding: "utf8", cwd: this.folder, env: { ...process.env, PYTHONPATH } };
    return JSON.parse(execFileSync(PYTHON, ["-B", "-c", REPLAY, recording, this.model], options));
  }
}
