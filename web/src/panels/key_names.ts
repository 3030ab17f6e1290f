import { keys, type Key } from "../keys";
import { texts } from "../texts";

const NAMES: Record<string, string> = {
  ...texts.keyNames,
  arrowleft: "←",
  arrowright: "→",
  arrowup: "↑",
  arrowdown: "↓",
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
  const does = meaningOf(what);
  return { title: `${words ?? does.charAt(0).toUpperCase() + does.slice(1)} (${key})`, "aria-keyshortcuts": key };
}

/** The words for what a key does. */
export function meaningOf(what: string): string {
  const meaning = texts.keys[what as keyof typeof texts.keys];
  if (meaning === undefined) throw new Error(`no text for the key that does ${what}`);
  return meaning;
}

function rowOf(what: string): Key {
  const row = keys.find((one) => one.what === what);
  if (row === undefined) throw new Error(`no key does ${what}`);
  return row;
}
