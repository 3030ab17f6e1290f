// The one table of keys and their actions. Each component listens to its actions by name; the help shows all.

export interface Key {
  /** As KeyboardEvent.key has them, letters small; with "Shift+" or "Control+" before it. */
  keys: string[];
  what: string;
  does: string;
  /** It continues as long as the key is down. */
  isHeld?: boolean;
  /** It is done again and again as long as the key is down. */
  repeats?: boolean;
}

export const keys: Key[] = [
  { keys: ["1"], what: "view.front", does: "view from the front, toward the robot" },
  { keys: ["2"], what: "view.robot", does: "view from the robot" },
  { keys: ["3"], what: "view.top", does: "view from above" },
  { keys: ["4"], what: "view.left", does: "view from the left" },
  { keys: ["5"], what: "view.right", does: "view from the right" },
  { keys: ["f"], what: "view.focus", does: "focus on the held object, or on the object under the mouse" },
  { keys: ["w"], what: "fly.forward", does: "fly forward", isHeld: true },
  { keys: ["s"], what: "fly.back", does: "fly back", isHeld: true },
  { keys: ["a"], what: "fly.left", does: "fly to the left", isHeld: true },
  { keys: ["d"], what: "fly.right", does: "fly to the right", isHeld: true },
  { keys: ["q"], what: "fly.up", does: "fly up", isHeld: true },
  { keys: ["z"], what: "fly.down", does: "fly down", isHeld: true },
  { keys: ["arrowleft"], what: "look.left", does: "look to the left", isHeld: true },
  { keys: ["arrowright"], what: "look.right", does: "look to the right", isHeld: true },
  { keys: ["arrowup"], what: "look.up", does: "look up", isHeld: true },
  { keys: ["arrowdown"], what: "look.down", does: "look down", isHeld: true },
  { keys: ["r"], what: "record.toggle", does: "start or finish recording" },
  { keys: ["Control+z"], what: "record.undo", does: "undo the last action" },
  { keys: ["Control+y", "Control+Shift+z"], what: "record.redo", does: "redo the action undone last" },
  { keys: ["space"], what: "time.pause", does: "pause or resume time" },
  { keys: ["h"], what: "help", does: "show all keys" },
  { keys: ["e"], what: "hand.next", does: "select the next hand" },
  { keys: ["enter"], what: "hand.grasp", does: "grasp the object under the mouse" },
  { keys: ["escape"], what: "hand.stop", does: "end the drag; deselect" },
  { keys: ["backspace"], what: "hand.release", does: "release the held object" },
  { keys: ["delete"], what: "hand.destroy", does: "remove the held object from the world" },
  { keys: ["/"], what: "plane.left", does: "turn the motion plane by 5 degrees", repeats: true },
  { keys: ["Shift+/", "Shift+?"], what: "plane.right", does: "turn the motion plane back by 5 degrees", repeats: true },
  { keys: ["\\"], what: "plane.quarter", does: "turn the motion plane by 90 degrees" },
  { keys: ["i", "Shift+i"], what: "move.up", does: "move the held or selected objects up; with Shift farther", repeats: true },
  { keys: ["k", "Shift+k"], what: "move.down", does: "move them down; with Shift farther", repeats: true },
  { keys: ["j", "Shift+j"], what: "move.left", does: "move them to the left; with Shift farther", repeats: true },
  { keys: ["l", "Shift+l"], what: "move.right", does: "move them to the right; with Shift farther", repeats: true },
  { keys: ["u", "Shift+u"], what: "move.away", does: "move them away; with Shift farther", repeats: true },
  { keys: ["o", "Shift+o"], what: "move.nearer", does: "move them nearer; with Shift farther", repeats: true },
  { keys: ["Control+c"], what: "objects.copy", does: "copy the selected objects" },
  { keys: ["Control+v"], what: "objects.paste", does: "add copies beside them" },
  { keys: ["m"], what: "measure", does: "measure distances and angles, or stop measuring" },
  { keys: ["g"], what: "guides", does: "show or hide the resting place of the held object" },
];

/** The keys that sliders, lists and tabs use themselves. */
const OWN_KEYS = /^(Arrow.*|Home|End|PageUp|PageDown|Enter| )$/;

/** What a pressed key means; null where it means nothing, or where what has the focus uses it. */
export function keyOf(event: KeyboardEvent): Key | null {
  if (event.altKey || event.metaKey || isUsedByFocus(event)) return null;
  if (event.ctrlKey && getSelection()?.isCollapsed === false) return null; // text is to be copied
  const name = event.key === " " ? "space" : event.key.toLowerCase();
  const pressed = `${event.ctrlKey ? "Control+" : ""}${event.shiftKey ? "Shift+" : ""}${name}`;
  return keys.find((key) => key.keys.includes(pressed)) ?? null;
}

function isUsedByFocus(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target.closest("dialog, [role=dialog], [role=menu]")) return true;
  if (target.matches("input[type=range], [role=slider], [role=listbox], [role=tablist] *")) return OWN_KEYS.test(event.key);
  if (target instanceof HTMLInputElement) return !["checkbox", "radio", "button"].includes(target.type);
  if (target.matches("textarea, select")) return true;
  // Buttons and links have the keys that press them.
  return target.matches("button, a, summary, [role=button]") && ["Enter", " "].includes(event.key);
}

export type KeyActions = Record<string, (isDown: boolean, isShift: boolean) => void>;

/** Carries out what keys mean, by the names in the table; held keys are reported twice, down and up. */
export function listenToKeys(actions: KeyActions): () => void {
  const down = new Map<string, Key>();
  const release = (code: string) => {
    const key = down.get(code);
    down.delete(code);
    if (key) actions[key.what]?.(false, false);
  };
  const onDown = (event: KeyboardEvent) => {
    const key = keyOf(event);
    const action = key && actions[key.what];
    if (!action || event.defaultPrevented) return;
    event.preventDefault();
    if (event.repeat && !key.repeats) return;
    if (key.isHeld) down.set(event.code, key);
    action(true, event.shiftKey);
  };
  const onUp = (event: KeyboardEvent) => release(event.code);
  const onBlur = () => [...down.keys()].forEach(release);
  window.addEventListener("keydown", onDown);
  window.addEventListener("keyup", onUp);
  window.addEventListener("blur", onBlur);
  return () => {
    window.removeEventListener("keydown", onDown);
    window.removeEventListener("keyup", onUp);
    window.removeEventListener("blur", onBlur);
  };
}
