import { world } from "../panels/page";
import type { InputLine } from "./messages";
import { send } from "./server";

const MOVE_MS = 50;
const CAMERA_MS = 100;
const SEND_MS = 2000;
const MAX_LINES = 400;

/**
 * Logs mouse, keys, camera, focus and size of the page while a participant demonstrates. It is sent to be kept
 * beside the recording, which it never changes.
 */
export class InputLog {
  private lines: InputLine[] = [];
  private readonly began = performance.now();
  private lastMove = -MOVE_MS;
  private lastCamera = "";
  private readonly end = new AbortController();
  private readonly timers: number[];

  constructor() {
    const add = (kind: string, detail: Omit<InputLine, "ms" | "kind"> = {}) => this.add(kind, detail);
    const listen = (name: string, listener: (event: never) => void) =>
      window.addEventListener(name, listener as EventListener, { capture: true, passive: true, signal: this.end.signal });
    const pointer = (kind: string) => (event: PointerEvent) =>
      add(kind, { x: event.clientX, y: event.clientY, button: event.button, pointer: event.pointerType });
    listen("pointermove", (event: PointerEvent) => this.move(event));
    listen("pointerdown", pointer("down"));
    listen("pointerup", pointer("up"));
    listen("wheel", (event: WheelEvent) => add("wheel", { x: event.clientX, y: event.clientY, turn: event.deltaY }));
    listen("keydown", (event: KeyboardEvent) => !event.repeat && add("key", { key: event.key }));
    listen("keyup", (event: KeyboardEvent) => add("key_up", { key: event.key }));
    listen("blur", (event: Event) => event.target === window && add("blur"));
    listen("focus", (event: Event) => event.target === window && add("focus"));
    listen("resize", () => this.size());
    this.size();
    this.timers = [window.setInterval(() => this.camera(), CAMERA_MS), window.setInterval(() => this.flush(), SEND_MS)];
  }

  /** Sends what is left, and listens no longer. */
  close(): void {
    this.end.abort();
    this.timers.forEach((timer) => clearInterval(timer));
    this.flush();
  }

  private add(kind: string, detail: Omit<InputLine, "ms" | "kind">): void {
    this.lines.push({ ms: Math.round(performance.now() - this.began), kind, ...detail });
    if (this.lines.length >= MAX_LINES) this.flush();
  }

  private move(event: PointerEvent): void {
    const now = performance.now();
    if (now - this.lastMove < MOVE_MS) return;
    this.lastMove = now;
    this.add("move", { x: event.clientX, y: event.clientY });
  }

  private size(): void {
    this.add("size", { width: innerWidth, height: innerHeight });
  }

  private camera(): void {
    const place = world.value?.cameraPlace.map((value) => Math.round(1000 * value) / 1000) ?? [];
    const text = place.join(" ");
    if (text === this.lastCamera || place.length === 0) return;
    const isFirst = this.lastCamera === "";
    this.lastCamera = text;
    this.add(isFirst ? "camera_start" : "camera", { place });
  }

  private flush(): void {
    if (this.lines.length > 0) send({ do: "log", lines: this.lines });
    this.lines = [];
  }
}
