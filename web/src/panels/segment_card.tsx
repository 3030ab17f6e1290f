import type { ActionSummary, Segment } from "../protocol";
import { texts } from "../texts";
import { Picture } from "../ui/card";

/** What a segment or a step of a history is, in words. */
export function wordsOf({ deed }: { deed: ActionSummary | null }): string {
  return deed === null ? texts.timeline.start : texts.action(deed);
}

/** One segment: how it ends, and what it is. */
export function SegmentCard(props: {
  picture: string;
  segment: Segment;
  /** Absent: what began it. */
  title?: string;
  isNow: boolean;
  isChosen: boolean;
  /** It is the other end of what the chosen segment begins, or ends. */
  isPaired?: boolean;
  /** Absent: it can be chosen. */
  whyFixed?: string;
  onChoose: () => void;
}) {
  const { segment } = props;
  const title = props.title ?? wordsOf(segment);
  const why = props.whyFixed ?? (props.isPaired ? texts.timeline.pairWhy : undefined);
  return (
    <li class={`segment ${props.isNow ? "now" : ""} ${props.isPaired ? "paired" : ""}`} style={{ flexGrow: Math.max(0.5, segment.seconds) }}>
      <button
        type="button"
        aria-pressed={props.isChosen}
        aria-current={props.isNow ? "time" : undefined}
        aria-disabled={props.whyFixed !== undefined}
        onClick={props.onChoose}
        title={why === undefined ? title : `${title}. ${why}`}
      >
        <Picture source={props.picture} alt="" />
        <span class="visually-hidden">{segment.number}: </span>
        <span class="segment-words">{title}</span>
        <small>{texts.seconds(segment.seconds)}</small>
      </button>
    </li>
  );
}
