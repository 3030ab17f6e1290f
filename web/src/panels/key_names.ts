import { keys, type Key } from "../keys";

const NAMES: Record<string, string> = {
  Control: "Ctrl",
  arrowleft: "←",
  arrowright: "→",
  arrowup: "↑",
  arrowdown: "↓",
  space: "Space",
  enter: "Enter",
  escape: "Esc",
  backspace: "Backspace",
  delete: "Del",
};

/** "Control+z" as it stands on keyboards: "Ctrl+Z". */
export function keyName(key: string): string {
  return key
    .split("+")
    .map((part) => NAMES[part] ?? (part.length === 1 ? part.toUpperCase() : part))
    .join("+");
}

/** The key that does this, for the button that does it, too. */
export function keyFor(what: string): string {
  return keyName(rowOf(what).keys[0]!);
}

/** For an element that does what a key does: its tooltip, in these words or in the table's, with the key. */
export function keyHint(what: string, words?: string): { title: string; "aria-keyshortcuts": string } {
  const key = keyFor(what);
  const { does } = rowOf(what);
  return { title: `${words ?? does.charAt(0).toUpperCase() + does.slice(1)} (${key})`, "aria-keyshortcuts": key };
}

function rowOf(what: string): Key {
  const row = keys.find((one) => one.what === what);
  if (row === undefined) throw new Error(`no key does ${what}`);
  return row;
}
