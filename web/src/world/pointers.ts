import type { Drag, Hands } from "./hands";
import { measuredAt } from "./measure_pick";
import { addMeasured, measured } from "./measured";
import type { Picked, Picker, PointerAt } from "./pick";
import { contextMenu } from "./signals";
import type { ViewCamera } from "./view_camera";

const CLICK_PIXELS = 4;
const TOUCH_CLICK_PIXELS = 9;
const LONG_PRESS_MS = 550;
const WHEEL_ZOOM = 0.0014; // per pixel of the wheel
const PIXELS_PER_LINE = 30;
const WHEEL_TURN = 3; // [degrees]
const WHEEL_TURN_PIXELS = 40;

const LEFT = 0;
const MIDDLE = 1;
const RIGHT = 2;

interface Gesture {
  from: PointerAt;
  last: PointerAt;
  button: number;
  isTouch: boolean;
  /** What it drags; null: the camera. */
  drag: Drag | null;
  hasMoved: boolean;
}

/**
 * Mouse, pen and fingers. The left button and one finger are a hand where there is something to take
 * hold of, else they go around, as the right button does anywhere; the middle one, Shift and two
 * fingers move sideways. Wheel and pinch: nearer. Right click and long press: a menu.
 */
export class Pointers {
  private readonly fingers = new Map<number, PointerAt>();
  private gesture: Gesture | null = null;
  private longPress: ReturnType<typeof setTimeout> | null = null;
  private wheelTurn = 0;
  private wasMenuOpen = false;
  private readonly quitting = new AbortController();

  constructor(
    private readonly host: HTMLElement,
    private readonly picker: Picker,
    private readonly hands: Hands,
    private readonly camera: ViewCamera,
    private readonly onHover: (at: PointerAt | null) => void,
  ) {
    const { signal } = this.quitting;
    // Before the menu hears of it and closes: whatever is clicked while it is open only closes it.
    window.addEventListener("pointerdown", (event) => this.lookForMenu(event), { signal, capture: true });
    host.addEventListener("pointerdown", (event) => this.down(event), { signal });
    host.addEventListener("mousedown", (event) => this.preventScrolling(event), { signal });
    host.addEventListener("pointermove", (event) => this.move(event), { signal });
    host.addEventListener("pointerup", (event) => this.up(event), { signal });
    host.addEventListener("pointercancel", (event) => this.cancel(event), { signal });
    host.addEventListener("pointerleave", () => this.onHover(null), { signal });
    host.addEventListener("wheel", (event) => this.wheel(event), { signal, passive: false });
    host.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  }

  get isBusy(): boolean {
    return this.gesture !== null;
  }

  /** Ends whatever is going on. */
  stop(): void {
    this.gesture?.drag?.end();
    this.gesture = null;
    this.forgetLongPress();
  }

  dispose(): void {
    this.stop();
    this.quitting.abort();
  }

  private down(event: PointerEvent): void {
    if (!this.isOnWorld(event)) return;
    const at = placeOf(event);
    this.host.setPointerCapture(event.pointerId);
    const isTouch = event.pointerType === "touch";
    if (isTouch) this.fingers.set(event.pointerId, at);
    if (this.fingers.size === 2) this.stop();
    if (this.fingers.size > 1 || this.gesture !== null) return;
    const isHand = event.button === LEFT && measured.value === null;
    const drag = isHand ? this.hands.press(at, this.pick(at)) : null;
    const isSideways = event.shiftKey && drag === null;
    this.gesture = {
      from: at,
      last: at,
      button: isSideways ? MIDDLE : event.button,
      isTouch,
      drag,
      hasMoved: false,
    };
    if (isTouch) this.longPress = setTimeout(() => this.showMenu(), LONG_PRESS_MS);
  }

  private lookForMenu(event: Event): void {
    this.wasMenuOpen = contextMenu.value !== null;
    if (this.isOnWorld(event)) contextMenu.value = null;
  }

  /** Which some browsers do with the middle button. */
  private preventScrolling(event: MouseEvent): void {
    if (event.button === MIDDLE && this.isOnWorld(event)) event.preventDefault();
  }

  private move(event: PointerEvent): void {
    const at = placeOf(event);
    if (this.fingers.has(event.pointerId) && this.fingers.size > 1) {
      this.pinch(event.pointerId, at);
    } else if (this.gesture !== null) {
      this.drag(this.gesture, at);
    } else if (this.isOnWorld(event)) {
      this.onHover(at);
    }
  }

  private drag(gesture: Gesture, at: PointerAt): void {
    const least = gesture.isTouch ? TOUCH_CLICK_PIXELS : CLICK_PIXELS;
    const way = Math.hypot(at.x - gesture.from.x, at.y - gesture.from.y);
    if (!gesture.hasMoved && way < least) return;
    gesture.hasMoved = true;
    this.forgetLongPress();
    const [right, down] = [at.x - gesture.last.x, at.y - gesture.last.y];
    gesture.last = at;
    if (gesture.drag) gesture.drag.move(at);
    else if (gesture.button === MIDDLE) this.camera.pan(right, down, this.host.clientHeight);
    else this.camera.orbit(right, down);
  }

  private up(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    const { gesture } = this;
    if (gesture === null) return;
    this.stop();
    if (gesture.hasMoved || this.wasMenuOpen) return;
    const at = placeOf(event);
    if (event.button === LEFT) this.click(at);
    if (event.button === RIGHT) this.hands.menu(at, this.pick(at));
  }

  /** Who measures takes nothing. */
  private click(at: PointerAt): void {
    if (measured.value === null) return this.hands.click(at, this.pick(at));
    const point = measuredAt(at, this.picker);
    if (point !== null) addMeasured(point);
  }

  private cancel(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.stop();
  }

  /** Two fingers: what was under their middle stays there, as far apart as they are. */
  private pinch(id: number, at: PointerAt): void {
    const other = [...this.fingers].find(([finger]) => finger !== id)?.[1];
    const before = this.fingers.get(id);
    this.fingers.set(id, at);
    if (!before || !other) return;
    const spread = Math.hypot(at.x - other.x, at.y - other.y);
    const spreadBefore = Math.hypot(before.x - other.x, before.y - other.y);
    this.camera.pan((at.x - before.x) / 2, (at.y - before.y) / 2, this.host.clientHeight);
    if (spread > 1) this.camera.zoom(spreadBefore / spread, null, true);
  }

  private wheel(event: WheelEvent): void {
    if (!this.isOnWorld(event)) return;
    event.preventDefault();
    const lines = event.deltaY || event.deltaX; // with Shift browsers report it sideways
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? lines : lines * PIXELS_PER_LINE;
    if (event.shiftKey) this.turnByWheel(pixels);
    else {
      const isPinch = event.ctrlKey; // touchpads report a pinch like this
      const point = this.pick(placeOf(event))?.point ?? null;
      this.camera.zoom(Math.exp(pixels * WHEEL_ZOOM * (isPinch ? 6 : 1)), point);
    }
  }

  private turnByWheel(pixels: number): void {
    this.wheelTurn += pixels / WHEEL_TURN_PIXELS;
    const steps = Math.trunc(this.wheelTurn);
    this.wheelTurn -= steps;
    if (steps !== 0) this.hands.turnPlane(WHEEL_TURN * steps);
  }

  private showMenu(): void {
    const at = this.gesture?.from;
    this.stop();
    if (at) this.hands.menu(at, this.pick(at));
  }

  private forgetLongPress(): void {
    if (this.longPress !== null) clearTimeout(this.longPress);
    this.longPress = null;
  }

  private pick(at: PointerAt): Picked | null {
    return this.picker.pick(at);
  }

  /** Panels may lie on the host, too. */
  private isOnWorld({ target }: Event): boolean {
    return target === this.host || target instanceof HTMLCanvasElement;
  }
}

function placeOf(event: MouseEvent): PointerAt {
  return { x: event.clientX, y: event.clientY, isShift: event.shiftKey };
}
