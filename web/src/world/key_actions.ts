import type { KeyActions } from "../keys";
import { heldObject } from "../studio";
import type { Hands } from "./hands";
import { switchMeasuring } from "./measured";
import type { Pointers } from "./pointers";
import { copySelected, paste, select } from "./selection";
import { areAidsFixed, contextMenu, guides, hovered, PRESETS, type Preset } from "./signals";
import type { ViewCamera } from "./view_camera";

const PLANE_STEP = 5;
const QUARTER = 90; // [degrees]

/** What the keys of the table do in the world. */
export function actionsOf(
  hands: Hands,
  camera: ViewCamera,
  pointers: Pointers,
  focus: (object: string) => void,
  showPreset: (preset: Preset) => void,
): KeyActions {
  const actions: KeyActions = {
    "view.focus": () => {
      const object = heldObject.value ?? hovered.value;
      if (object !== null) focus(object);
    },
    "fly.forward": (isDown) => camera.fly("x", +isDown),
    "fly.back": (isDown) => camera.fly("x", -isDown),
    "fly.left": (isDown) => camera.fly("y", +isDown),
    "fly.right": (isDown) => camera.fly("y", -isDown),
    "fly.up": (isDown) => camera.fly("z", +isDown),
    "fly.down": (isDown) => camera.fly("z", -isDown),
    "look.left": (isDown) => camera.look("yaw", +isDown),
    "look.right": (isDown) => camera.look("yaw", -isDown),
    "look.up": (isDown) => camera.look("pitch", +isDown),
    "look.down": (isDown) => camera.look("pitch", -isDown),
    "hand.next": () => hands.takeNext(),
    "hand.grasp": () => {
      if (hovered.value !== null && heldObject.value === null) void hands.grasp(hovered.value, null);
    },
    "hand.stop": () => {
      contextMenu.value = null;
      if (!pointers.isBusy) select([]);
      pointers.stop();
    },
    "hand.release": () => hands.release(),
    "hand.destroy": () => hands.destroy(),
    "plane.left": () => hands.turnPlane(PLANE_STEP),
    "plane.right": () => hands.turnPlane(-PLANE_STEP),
    "plane.quarter": () => hands.turnPlane(QUARTER),
    "move.up": (_, isBig) => hands.nudge(0, 0, 1, isBig),
    "move.down": (_, isBig) => hands.nudge(0, 0, -1, isBig),
    "move.left": (_, isBig) => hands.nudge(-1, 0, 0, isBig),
    "move.right": (_, isBig) => hands.nudge(1, 0, 0, isBig),
    "move.away": (_, isBig) => hands.nudge(0, 1, 0, isBig),
    "move.nearer": (_, isBig) => hands.nudge(0, -1, 0, isBig),
    "objects.copy": copySelected,
    "objects.paste": () => void (hands.canAct && paste()),
    measure: switchMeasuring,
    guides: () => {
      if (!areAidsFixed.value) guides.value = !guides.value;
    },
  };
  for (const preset of PRESETS) actions[`view.${preset}`] = () => showPreset(preset);
  return actions;
}
