// Messages of texts/ with their arguments, in the part of ICU's message syntax that docs/translating.md lists.

import { language } from "./language";

type Argument = string | number;
export type Arguments = Record<string, Argument>;

/** Decimals of `{x, number, STYLE}`. */
const DECIMALS: Record<string, number> = { whole: 0, tenths: 1, hundredths: 2 };
const plurals = new Intl.PluralRules(language);
const conjunction = new Intl.ListFormat(language, { type: "conjunction" });
const disjunction = new Intl.ListFormat(language, { type: "disjunction" });

/** Returns the message with these arguments. Throws if the message names one that is missing. */
export function say(message: string, given: Arguments): string {
  return render(message, given, "");
}

/** The number with this many digits after the decimal separator, and a true minus, but none before a rounded zero. */
export function decimal(value: number, digits: number): string {
  // -0 + 0 is 0.
  return formatted(Number(value.toFixed(digits)) + 0, { minimumFractionDigits: digits, maximumFractionDigits: digits });
}

const SEPARATOR = decimal(0.1, 1).charAt(1);

/** The number as it is typed: with a hyphen for a minus. Rounding turns -0.001 into "-0.00": without its minus. */
export function typed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace(".", SEPARATOR);
}

/** The number that was typed, with a point or a comma; null if it is none. */
export function numberIn(text: string): number | null {
  const value = Number(text.trim().replace(",", ".").replace("−", "-"));
  return text.trim() === "" || !Number.isFinite(value) ? null : value;
}

export function allOf(names: readonly Argument[]): string {
  return conjunction.format(names.map(String));
}

export function anyOf(names: readonly string[]): string {
  return disjunction.format(names);
}

/** The entry of a table for a name that the program sends; the name itself if the table has none. */
export function named(table: Record<string, string>, name: string): string {
  return Object.hasOwn(table, name) ? table[name]! : name;
}

/** Arguments with each text among them replaced. */
export function mapped(given: Arguments, replace: (text: string) => string): Arguments {
  return Object.fromEntries(
    Object.entries(given).map(([name, value]) => [name, typeof value === "string" ? replace(value) : value]),
  );
}

function formatted(value: number, options: Intl.NumberFormatOptions): string {
  return value.toLocaleString(language, { useGrouping: false, ...options }).replace("-", "−");
}

/** @param counted  stands for # */
function render(message: string, given: Arguments, counted: string): string {
  let text = "";
  for (let k = 0; k < message.length; k++) {
    if (message[k] === "{") {
      const end = closing(message, k);
      text += insert(message.slice(k + 1, end), given, counted);
      k = end;
    } else {
      text += message[k] === "#" && counted !== "" ? counted : message[k];
    }
  }
  return text;
}

/** The place of the brace that closes the one at `open`. */
function closing(message: string, open: number): number {
  let depth = 0;
  for (let k = open; k < message.length; k++) {
    if (message[k] === "{") depth++;
    if (message[k] === "}" && --depth === 0) return k;
  }
  throw new Error(`message without end of argument: ${message}`);
}

/** What stands for `name`, `name, number, STYLE`, `name, plural, CASES` or `name, select, CASES`. */
function insert(field: string, given: Arguments, counted: string): string {
  const [, name = "", kind, rest = ""] = /^\s*(\w+)\s*(?:,\s*(\w+)\s*(?:,\s*(.*))?)?$/s.exec(field) ?? [];
  const value = given[name];
  if (value === undefined) throw new Error(`message without its argument: {${field}}`);
  if (kind === undefined) return String(value);
  if (kind === "number") return styledNumber(rest, Number(value));
  const cases = casesOf(rest);
  const word = kind === "plural" ? plurals.select(Number(value)) : String(value);
  const chosen = cases.get(word) ?? cases.get("other");
  if (chosen === undefined) throw new Error(`message without a case for ${word}: {${field}}`);
  return render(chosen, given, kind === "plural" ? formatted(Number(value), {}) : counted);
}

function styledNumber(style: string, value: number): string {
  if (style === "") return formatted(value, {});
  const digits = DECIMALS[style];
  if (digits === undefined) throw new Error(`message with the unknown style of numbers ${style}`);
  return decimal(value, digits);
}

/** `one {…} other {…}` as a map. */
function casesOf(text: string): Map<string, string> {
  const cases = new Map<string, string>();
  for (let k = 0; ; ) {
    const open = text.indexOf("{", k);
    if (open < 0) return cases;
    const end = closing(text, open);
    cases.set(text.slice(k, open).trim(), text.slice(open + 1, end));
    k = end + 1;
  }
}
