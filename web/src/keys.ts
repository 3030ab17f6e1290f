// The one table of keys and their actions. Each component listens to its actions by name; the help shows all.

export interface Key {
  /** As KeyboardEvent.key has them, letters small; with "Shift+" or "Control+" before it. */
  keys: string[];
  what: string;
  /** It continues as long as the key is down. */
  isHeld?: boolean;
  /** It is done again and again as long as the key is down. */
  repeats?: boolean;
}

export const keys: Key[] = [
  { keys: ["1"], what: "view.front" },
  { keys: ["2"], what: "view.robot" },
  { keys: ["3"], what: "view.top" },
  { keys: ["4"], what: "view.left" },
  { keys: ["5"], what: "view.right" },
  { keys: ["f"], what: "view.focus" },
  { keys: ["w"], what: "fly.forward", isHeld: true },
  { keys: ["s"], what: "fly.back", isHeld: true },
  { keys: ["a"], what: "fly.left", isHeld: true },
  { keys: ["d"], what: "fly.right", isHeld: true },
  { keys: ["q"], what: "fly.up", isHeld: true },
  { keys: ["z"], what: "fly.down", isHeld: true },
  { keys: ["arrowleft"], what: "look.left", isHeld: true },
  { keys: ["arrowright"], what: "look.right", isHeld: true },
  { keys: ["arrowup"], what: "look.up", isHeld: true },
  { keys: ["arrowdown"], what: "look.down", isHeld: true },
  { keys: ["r"], what: "record.toggle" },
  { keys: ["Control+z"], what: "record.undo" },
  { keys: ["Control+y", "Control+Shift+z"], what: "record.redo" },
  { keys: ["space"], what: "time.pause" },
  { keys: ["h"], what: "help" },
  { keys: ["e"], what: "hand.next" },
  { keys: ["enter"], what: "hand.grasp" },
  { keys: ["escape"], what: "hand.stop" },
  { keys: ["backspace"], what: "hand.release" },
  { keys: ["delete"], what: "hand.destroy" },
  { keys: ["/"], what: "plane.left", repeats: true },
  { keys: ["Shift+/", "Shift+?"], what: "plane.right", repeats: true },
  { keys: ["\\"], what: "plane.quarter" },
  { keys: ["i", "Shift+i"], what: "move.up", repeats: true },
  { keys: ["k", "Shift+k"], what: "move.down", repeats: true },
  { keys: ["j", "Shift+j"], what: "move.left", repeats: true },
  { keys: ["l", "Shift+l"], what: "move.right", repeats: true },
  { keys: ["u", "Shift+u"], what: "move.away", repeats: true },
  { keys: ["o", "Shift+o"], what: "move.nearer", repeats: true },
  { keys: ["Control+c"], what: "objects.copy" },
  { keys: ["Control+v"], what: "objects.paste" },
  { keys: ["m"], what: "measure" },
  { keys: ["g"], what: "guides" },
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
