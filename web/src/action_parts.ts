import type { ActionSummary } from "./protocol";

/** The parts of an action that messages about it choose their words by; "none" without the part. */
export function partsOf(action: ActionSummary) {
  const { on, into } = action;
  const object = on ?? into ?? "";
  const preposition = on !== undefined ? "on" : into !== undefined ? "into" : "none";
  return {
    hand: action.hand ?? "none",
    tool: action.with ?? "none",
    object,
    /** The program names no object for the table. */
    where: preposition !== "none" && object === "" ? `${preposition}Table` : preposition,
  };
}

/** The place in a chain that the program names by both its sides, as `Rope between link 4 and 5`. */
export function placeInChain(name: string) {
  const [, chain, start, before, after] = /^(.+) between (?:(start)|link (\d+)) and (?:end|(?:link )?(\d+))$/.exec(name) ?? [];
  if (chain === undefined) return null;
  const place = start !== undefined ? "start" : after === undefined ? "end" : "inside";
  return { chain, place, before: before ?? "", after: after ?? "" };
}

/** How many objects, if the program names their number only. */
export function numberOfObjects(what: string): number | null {
  const [, number] = /^(\d+) objects$/.exec(what) ?? [];
  return number === undefined ? null : Number(number);
}
