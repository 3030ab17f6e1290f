import { HANDS, type ActionSummary, type HandName, type Timeline } from "../protocol";
import { handColors } from "../colors";
import { texts } from "../texts";

/** What a hand held, and from when to when [s]. */
export interface Clip {
  what: string;
  begin: number;
  end: number;
}

type Segment = Timeline["segments"][number];

const ENDS: ActionSummary["do"][] = ["put", "drop", "release", "destroy"];

/** The hands that did something, each with what it held, in order. */
export function tracksOf(segments: Segment[], end: number): Map<HandName, Clip[]> {
  const tracks = new Map<HandName, Clip[]>();
  for (const hand of HANDS) {
    const clips: Clip[] = [];
    const its = segments.filter(({ deed }) => deed?.hand === hand);
    for (const { deed, begin } of its) {
      const last = clips[clips.length - 1];
      const isHolding = last !== undefined && last.end === end;
      if (deed?.do === "take") clips.push({ what: deed.what, begin, end });
      else if (isHolding && deed !== null && ENDS.includes(deed.do)) last.end = begin;
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

/** One row for each hand, one above another: who held what, and what happened at the same time. */
export function Tracks({ segments, seconds }: { segments: Segment[]; seconds: number }) {
  const tracks = tracksOf(segments, seconds);
  const percent = (time: number) => `${(100 * time) / Math.max(seconds, 1e-9)}%`;
  return (
    <ul class="tracks" aria-label={texts.timeline.tracks}>
      {[...tracks].map(([hand, clips]) => (
        <li key={hand} class="track" style={{ "--hand": handColors[hand] }}>
          <ol>
            {clips.map(({ what, begin, end }) => (
              <li
                key={begin}
                class="clip"
                title={texts.timeline.clip(what, begin, end)}
                style={{ left: percent(begin), width: percent(end - begin) }}
              >
                {texts.hands.names[hand]}: {what}
              </li>
            ))}
          </ol>
        </li>
      ))}
    </ul>
  );
}
