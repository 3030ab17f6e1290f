import { eventListeners, poseListeners, scene, state } from "../studio";
import { HANDS, type EventMessage, type Point } from "../protocol";

/** What a step of the tour waits for: calls `onDone` at the deed itself, and returns how to stop watching. */
export type Deed = (onDone: () => void) => () => void;

const LIFT = 0.8; // [units]
/** What stands on another is that much higher, and not farther aside [units]. */
const ABOVE = 0.4;
const ASIDE = 1;

function heldNow(): { object: string; goal: Point; angles: Point } | null {
  for (const name of HANDS) {
    const hand = state.value?.hands[name];
    if (hand?.object && hand.goal) return { object: hand.object, goal: hand.goal, angles: hand.angles ?? [0, 0, 0] };
  }
  return null;
}

/** Done as soon as this is true of the state. */
function once(isDone: () => boolean): Deed {
  return (onDone) =>
    state.subscribe(() => {
      if (isDone()) onDone();
    });
}

function afterEvent(isIt: (event: EventMessage) => boolean): Deed {
  return (onDone) => {
    const listener = (event: EventMessage) => {
      if (isIt(event)) onDone();
    };
    eventListeners.add(listener);
    return () => eventListeners.delete(listener);
  };
}

/** Where every frame is; the world has the same, but draws it. */
const places = new Map<number, Point>();
poseListeners.add(({ isKey, frames }) => {
  if (isKey) places.clear();
  for (const { frame, pose } of frames) places.set(frame, [pose[0], pose[1], pose[2]]);
});

export const grasped: Deed = once(() => heldNow() !== null);

export const lifted: Deed = (onDone) => {
  let lowest = Infinity;
  return once(() => {
    const height = heldNow()?.goal[2];
    if (height === undefined) return false;
    lowest = Math.min(lowest, height);
    return height - lowest > LIFT;
  })(onDone);
};

export const turned: Deed = (onDone) => {
  let before: Point | null = null;
  return once(() => {
    const angles = heldNow()?.angles ?? null;
    before ??= angles;
    return angles !== null && angles.some((angle, k) => Math.abs(angle - before![k]!) > 3);
  })(onDone);
};

/** Something was let go of, and something rests on something else that no hand holds. */
export const stacked: Deed = (onDone) => {
  let isReleased = false;
  const stops = [
    afterEvent((event) => event.kind === "released")(() => (isReleased = true)),
    once(() => isReleased && (state.value?.still ?? false) && isAnythingStacked())(onDone),
  ];
  return () => stops.forEach((stop) => stop());
};

function isAnythingStacked(): boolean {
  const held = heldNow()?.object;
  const free = (scene.value?.objects ?? []).filter((object) => object.id !== held);
  const points = free.map((object) => places.get(object.frame)).filter((point) => point !== undefined);
  return points.some((high) =>
    points.some((low) => high[2] - low[2] > ABOVE && Math.hypot(high[0] - low[0], high[1] - low[1]) < ASIDE),
  );
}

export const recording: Deed = once(() => (state.value?.recording ?? null) !== null);

/** There comes to be something to redo, or no longer is. */
function onceRedo(isThere: boolean): Deed {
  return (onDone) => {
    let wasThere = state.value?.redo ?? false;
    return once(() => {
      const isNow = state.value?.redo ?? false;
      const hasChanged = isNow !== wasThere;
      wasThere = isNow;
      return hasChanged && isNow === isThere;
    })(onDone);
  };
}

export const undone: Deed = onceRedo(true);
export const redone: Deed = onceRedo(false);

export const finished: Deed = once(() => (state.value?.recording ?? null) === null);

/** The view was turned or came nearer, by mouse, finger or wheel in the world, or a key anywhere. */
export const lookedAround: Deed = (onDone) => {
  const world = document.querySelector(".world");
  let moved = 0;
  /** It was pressed in the world, and not beside it. */
  let isPressed = false;
  const onDown = () => (isPressed = true);
  const onUp = () => (isPressed = false);
  const onMove = (event: Event) => {
    if (!(event instanceof PointerEvent) || event.buttons === 0 || !isPressed) return;
    moved += Math.abs(event.movementX) + Math.abs(event.movementY);
    if (moved > 60) onDone();
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
