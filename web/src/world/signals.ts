import { computed, signal } from "@preact/signals";
import type { Point } from "../protocol";
import { currentHand, state } from "../studio";
import { choicePreference, inLayout } from "../ui/preference";

export const PRESETS = ["front", "robot", "top", "left", "right"] as const;
export type Preset = (typeof PRESETS)[number];
/** The view that was chosen last, with which the next visit begins; "default": none, so the scene decides. */
export const chosenView = inLayout(choicePreference<Preset | "default">("view", "default", ["default", ...PRESETS]));

/** How fast pictures come while something moves [1/s]. */
export const fps = signal(0);
export const isLowDetail = signal(false);
/** The object under the mouse. */
export const hovered = signal<string | null>(null);
/** What was asked for a menu, and where on the page [px]; the component that draws it sets it back to null. */
export const contextMenu = signal<{
  x: number;
  y: number;
  object: string;
  part: string | null;
  button: string | null;
  point: Point;
} | null>(null);
/** Of the plane in which the current hand drags, from the x axis [degrees]. */
export const planeAngle = computed(() => state.value?.hands[currentHand.value].plane ?? 0);
/** Whether to show where a released object will rest. */
export const guides = signal(true);
/** Whether to show the rings that turn the held object. */
export const hasRings = signal(true);
/** Keys change none of the aids: a study prescribes them. */
export const areAidsFixed = signal(false);
/** The held object follows its rail, whatever the plane in which it is dragged. */
export const isOnRail = computed(() => (state.value?.hands[currentHand.value].on_rail ?? false) && (state.value?.snap.includes("rails") ?? false));
/** Height of the origin of the held object where it would come to rest [units]; null: it is there, or nobody knows. */
export const restHeight = signal<number | null>(null);
/** A held tool is on its way to where it can work. */
export const isBringing = signal(false);
export const cameraKind = signal<Preset | "free">("front");
/** False where the browser has no WebGL2: all but the world works. */
export const canDraw = signal(true);
