import { keys } from "../keys";

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
export function keyFor(what: string): string | undefined {
  const key = keys.find((one) => one.what === what)?.keys[0];
  return key === undefined ? undefined : keyName(key);
}
