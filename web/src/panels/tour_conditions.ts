import { mayCommand } from "../allowed";
import { eventListeners, request, state } from "../studio";
import { HANDS, type EventMessage, type Point } from "../protocol";

/** What a step of the tour waits for: calls `onDone` when it is met, and returns a function that stops watching. */
export type Condition = (onDone: () => void) => () => void;

const LIFT = 0.8; // [units]
/** A drag that turns the view visibly [px]. */
const VISIBLE_DRAG = 12;

function heldNow(): { object: string; goal: Point; angles: Point } | null {
  for (const name of HANDS) {
    const hand = state.value?.hands[name];
    if (hand?.object && hand.goal) return { object: hand.object, goal: hand.goal, angles: hand.angles ?? [0, 0, 0] };
  }
  return null;
}

/** Done as soon as this is true of the state. */
function once(isDone: () => boolean): Condition {
  return (onDone) =>
    state.subscribe(() => {
      if (isDone()) onDone();
    });
}

export const grasped: Condition = once(() => heldNow() !== null);

export const lifted: Condition = (onDone) => {
  let lowest = Infinity;
  return once(() => {
    const height = heldNow()?.goal[2];
    if (height === undefined) return false;
    lowest = Math.min(lowest, height);
    return height - lowest > LIFT;
  })(onDone);
};

export const turned: Condition = (onDone) => {
  let before: Point | null = null;
  return once(() => {
    const angles = heldNow()?.angles ?? null;
    before ??= angles;
    return angles !== null && angles.some((angle, k) => Math.abs(angle - before![k]!) > 3);
  })(onDone);
};

/** What was let go of last has come to rest on another object. */
export const stacked: Condition = (onDone) => {
  let released: string | null = null;
  let isAsking = false;
  let isOver = false;
  const ask = async (object: string) => {
    isAsking = true;
    const support = await request("support", { object }).catch(() => null);
    isAsking = false;
    if (isOver || released !== object || support === null) return;
    if (support.on) onDone();
    if (support.on !== undefined || support.into !== undefined) released = null;
  };
  const listener = (event: EventMessage) => {
    if (event.kind === "released") released = event.object ?? null;
  };
  eventListeners.add(listener);
  const unsubscribe = state.subscribe((now) => {
    const isFree = released !== null && released !== heldNow()?.object;
    if (isFree && now?.still && !isAsking) void ask(released!);
  });
  return () => {
    isOver = true;
    eventListeners.delete(listener);
    unsubscribe();
  };
};

export const recording: Condition = once(() => (state.value?.recording ?? null) !== null);

/** There comes to be something to redo, or no longer is. */
function onceRedo(isThere: boolean): Condition {
  return (onDone) => {
    let wasThere = mayCommand("redo") === true;
    return once(() => {
      const isNow = mayCommand("redo") === true;
      const hasChanged = isNow !== wasThere;
      wasThere = isNow;
      return hasChanged && isNow === isThere;
    })(onDone);
  };
}

export const undone: Condition = onceRedo(true);
export const redone: Condition = onceRedo(false);

export const finished: Condition = once(() => (state.value?.recording ?? null) === null);

/** The view was turned or came nearer, by mouse, finger or wheel in the world, or a key anywhere. */
export const lookedAround: Condition = (onDone) => {
  const world = document.querySelector(".world");
  /** Where it was pressed in the world, and not beside it [px]. */
  let pressed: { x: number; y: number } | null = null;
  const onDown = (event: Event) => (pressed = event instanceof PointerEvent ? { x: event.clientX, y: event.clientY } : null);
  const onUp = () => (pressed = null);
  const onMove = (event: Event) => {
    if (!(event instanceof PointerEvent) || event.buttons === 0 || pressed === null) return;
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) >= VISIBLE_DRAG) onDone();
  };
  const onWheel = () => onDone();
  const onKey = (event: KeyboardEvent) => {
    if (/^([1-5wasdqz]|Arrow.*)$/.test(event.key)) onDone();
  };
  world?.addEventListener("pointerdown", onDown, true);
  window.addEventListener("pointerup", onUp, true);
  world?.addEventListener("pointermove", onMove, true);
  world?.addEventListener("wheel", onWheel, { capture: true, passive: true });
  window.addEventListener("keydown", onKey);
  return () => {
    world?.removeEventListener("pointerdown", onDown, true);
    window.removeEventListener("pointerup", onUp, true);
    world?.removeEventListener("pointermove", onMove, true);
    world?.removeEventListener("wheel", onWheel, true);
    window.removeEventListener("keydown", onKey);
  };
};
