// What hands held, and when: clips on the tracks of hands, and what shifting and stretching does to them.

import { HANDS, type ActionSummary, type HandName, type Timeline } from "../protocol";

/** What a hand held, and from when to when [s]. */
export interface Clip {
  what: string;
  begin: number;
  end: number;
  /** The segments of its first and its last action. */
  first: number;
  last: number;
  /** It was held to the end. */
  isOpen: boolean;
}

export type ClipEdit =
  | { do: "shift"; first: number; last: number; seconds: number }
  | { do: "stretch"; first: number; last: number; factor: number };

type Segment = Timeline["segments"][number];

const ENDS: ActionSummary["do"][] = ["put", "drop", "release", "destroy"];
/** [s] */
const SHORTEST = 0.1;
const TICKS = 60; // in a second

/** The hands that did something, each with what it held, in order. */
export function tracksOf(segments: Segment[], seconds: number): Map<HandName, Clip[]> {
  const tracks = new Map<HandName, Clip[]>();
  for (const hand of HANDS) {
    const clips: Clip[] = [];
    const its = segments.filter(({ deed }) => deed?.hand === hand);
    for (const { number, deed, begin } of its) {
      const held = clips.find(({ isOpen }) => isOpen);
      if (held !== undefined) held.last = number;
      if (deed?.do === "take") {
        clips.push({ what: deed.what, begin, end: seconds, first: number, last: number, isOpen: true });
      } else if (held !== undefined && deed !== null && ENDS.includes(deed.do)) {
        Object.assign(held, { end: begin, isOpen: false });
      }
    }
    if (its.length > 0) tracks.set(hand, clips);
  }
  return tracks;
}

/** The number of the segment in which a hand leaves what it took in this one; the same for other actions. */
export function endOfClip(segments: Segment[], number: number): number {
  const taken = segments.find((one) => one.number === number)?.deed;
  if (taken?.do !== "take") return number;
  const later = segments.filter((one) => one.number > number && one.deed?.hand === taken.hand);
  return later.find(({ deed }) => deed !== null && ENDS.includes(deed.do))?.number ?? number;
}

/** The number of the segment in which the same hand leaves what it takes in this one, or takes what it leaves; null without one. */
export function otherEndOfClip(segments: Segment[], number: number): number | null {
  const deed = segments.find((one) => one.number === number)?.deed;
  const isEnd = (one: Segment) => one.deed?.do === "take" || (one.deed !== null && ENDS.includes(one.deed.do));
  const ends = segments.filter((one) => one.deed?.hand === deed?.hand && isEnd(one));
  const at = ends.findIndex((one) => one.number === number);
  const isTake = deed?.do === "take";
  const other = at < 0 ? undefined : ends[isTake ? at + 1 : at - 1];
  return other !== undefined && (other.deed?.do === "take") !== isTake ? other.number : null;
}

/** A clip after edits; what is held to the end still is. */
export function editedClip(clip: Clip, edits: ClipEdit[]): Clip {
  let { begin, end } = clip;
  for (const edit of edits.filter(({ first }) => first === clip.first)) {
    if (edit.do === "shift") {
      begin += edit.seconds;
      end += edit.seconds;
    } else end = begin + (end - begin) * edit.factor;
  }
  return { ...clip, begin, end: clip.isOpen ? clip.end : end };
}

/** Between what the same hand does before and after a clip [s]. */
export function roomOf(clip: Clip, hand: HandName, segments: Segment[], clips: Clip[]): { from: number; to: number } {
  const others = clips.filter(({ first }) => first !== clip.first);
  const isSingle = ({ number, deed }: Segment) =>
    deed?.hand === hand && !clips.some(({ first, last }) => number >= first && number <= last);
  const singles = segments.filter(isSingle).map(({ number, begin }) => ({ first: number, begin, end: begin }));
  const all = [...others, ...singles];
  const end = segments[segments.length - 1]?.end ?? 0;
  return {
    from: Math.max(0, ...all.filter(({ first }) => first < clip.first).map((one) => one.end)),
    to: Math.min(end, ...all.filter(({ first }) => first > clip.first).map(({ begin }) => begin)),
  };
}

export type ClipPart = "whole" | "begin" | "end";

const toTicks = (seconds: number) => Math.round(seconds * TICKS) / TICKS;
const clamp = (value: number, low: number, high: number) => Math.min(Math.max(value, low), Math.max(low, high));

/** The edits that move a clip, or one end of it, later [s], as far as there is room. */
export function editsOf(clip: Clip, part: ClipPart, later: number, room: { from: number; to: number }): ClipEdit[] {
  const { first, last, begin, end } = clip;
  const shift = (seconds: number): ClipEdit[] =>
    Math.abs(seconds) < 0.5 / TICKS ? [] : [{ do: "shift", first, last, seconds: toTicks(seconds) }];
  const stretch = (length: number): ClipEdit[] => {
    const factor = length / (end - begin);
    return Math.abs(length - (end - begin)) < 0.5 / TICKS ? [] : [{ do: "stretch", first, last, factor }];
  };
  if (part === "end") return stretch(clamp(end + later, begin + SHORTEST, room.to) - begin);
  if (part === "whole" || clip.isOpen) {
    const latest = clip.isOpen ? room.to - SHORTEST - begin : room.to - end;
    return shift(clamp(later, room.from - begin, latest));
  }
  const moved = clamp(begin + later, room.from, end - SHORTEST) - begin;
  // A hand never acts before or after its room, so the clip becomes shorter first, and longer last.
  const steps = [shift(moved), stretch(end - begin - moved)];
  return (moved < 0 ? steps : steps.reverse()).flat();
}

/** Edits after others: shifts of the same clip, one after another, are one. */
export function withMore(edits: ClipEdit[], more: ClipEdit[]): ClipEdit[] {
  const all = [...edits];
  for (const edit of more) {
    const last = all[all.length - 1];
    if (edit.do === "shift" && last?.do === "shift" && last.first === edit.first) {
      all[all.length - 1] = { ...last, seconds: toTicks(last.seconds + edit.seconds) };
    } else all.push(edit);
  }
  return all.filter((edit) => edit.do !== "shift" || edit.seconds !== 0);
}
