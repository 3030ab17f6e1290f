// Messages of the program arrive as an id with arguments, and become text in the language of the page.

import type { Arguments } from "./message_format";
import { texts } from "./texts";

/** A message as the program sends it; messages among its arguments are text already. */
interface Said {
  say: string;
  with?: Arguments;
}

function isSaid(value: unknown): value is Said {
  return typeof value === "object" && value !== null && "say" in value && typeof value.say === "string";
}

/** Parses what the program sends: each of its messages for people becomes a text. */
export function parse(json: string): unknown {
  return JSON.parse(json, (_key, value: unknown) => (isSaid(value) ? texts.ofProgram(value.say, value.with ?? {}) : value));
}
