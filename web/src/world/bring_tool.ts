// Brings a held tool to the place where it can work, as a person would: up, over, down in front of the work, and along
// its axis onto it. Straight ahead, the tool would push things such as strings away.

import { Vector3 } from "three";
import { command, currentHand, heldObject, scene, state } from "../studio";
import type { Point } from "../protocol";
import { rounded } from "./hands";
import type { Models } from "./models";

/** From the work to the tool before it goes there along its axis; and above both ends on the way [units]. */
const ROOM = 0.5;
const HEADROOM = 1.5;
/** Where it is to be within, and for how long it may take to get there. */
const NEAR = 0.05; // [units]
const LONGEST_MS = 6000;
const POLL_MS = 40;

/** Returns whether the tool has got there; on its way, something may be in the way. */
export async function bringToWork(models: Models): Promise<boolean> {
  const hand = currentHand.value;
  const tool = toolInHand();
  const group = tool && models.groupOf(tool.object);
  if (tool === null || group === null) return false;
  const axis = new Vector3(...tool.axis).applyQuaternion(group.quaternion);
  const goes = async (to: Vector3) => {
    const from = state.value?.hands[hand];
    if (!from?.goal || !from.place) return false;
    const by = to.clone().sub(new Vector3(...from.goal));
    const place = new Vector3(...from.place).add(by);
    if ((await command({ do: "move_to", hand, position: rounded(to) })) === null) return false;
    return isSoon(() => heldObject.value === tool.object && group.position.distanceTo(place) < NEAR);
  };

  const start = goalOf(hand);
  const work = start && workOf(hand)?.add(start);
  if (start === null || !work) return false;
  const before = work.clone().addScaledVector(axis, -tool.edge - ROOM);
  const height = Math.max(start.z, before.z + HEADROOM);
  for (const stop of [start.clone().setZ(height), before.clone().setZ(height), before]) {
    if (!(await goes(stop))) return false;
  }
  // Seen from there, the tip is what is nearest; the work is to be in the middle of the blades.
  const end = goalOf(hand);
  const last = workOf(hand);
  return end !== null && last !== null && goes(end.add(last).addScaledVector(axis, tool.edge / 2));
}

function toolInHand(): { object: string; axis: Point; edge: number } | null {
  const object = heldObject.value;
  const tool = scene.value?.objects.find(({ id }) => id === object)?.tool;
  return object === null || tool === undefined ? null : { object, axis: tool.axis, edge: tool.edge };
}

function goalOf(hand: typeof currentHand.value): Vector3 | null {
  const goal = state.value?.hands[hand].goal;
  return goal ? new Vector3(...goal) : null;
}

/** How far the working point of the tool in a hand is from where it can work. */
function workOf(hand: typeof currentHand.value): Vector3 | null {
  const work = state.value?.hands[hand].work;
  return work ? new Vector3(...work.by) : null;
}

async function isSoon(isIt: () => boolean): Promise<boolean> {
  const end = performance.now() + LONGEST_MS;
  while (!isIt()) {
    if (performance.now() > end) return false;
    await new Promise((done) => setTimeout(done, POLL_MS));
  }
  return true;
}
