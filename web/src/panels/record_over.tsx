import { useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { HANDS, type HandName, type Timeline } from "../protocol";
import { may, when } from "../allowed";
import { ask } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Menu } from "../ui/menu";
import { recordedOver } from "./derived_signals";

const { timeline: words } = texts;

/** Chooses the hands that act again while a new demonstration is recorded, from this moment on. */
export function RecordOverButton(props: { id: string; timeline: Timeline; seconds: number; onStarted: () => void }) {
  const at = useSignal<{ x: number; y: number } | null>(null);
  const holder = useRef<HTMLSpanElement>(null);
  const acting = HANDS.filter((hand) => props.timeline.segments.some(({ deed }) => deed?.hand === hand));
  const open = () => {
    const box = holder.current!.getBoundingClientRect();
    at.value = { x: box.left, y: box.top };
  };
  const start = async (hands: HandName[]) => {
    const reply = await ask("record_over", { recording: props.id, hands, seconds: props.seconds });
    if (reply !== null) props.onStarted();
  };
  const choices = acting.length > 1 ? [...acting.map((hand) => [hand]), acting] : [acting];
  const allowed = may("record_over");
  return (
    <span ref={holder}>
      <Button
        label={words.over}
        title={when(allowed, acting.length === 0 ? words.overNone : words.overWhy).title}
        disabled={allowed !== true || acting.length === 0}
        onClick={open}
      />
      {at.value && (
        <Menu
          label={words.overWhy}
          {...at.value}
          entries={choices.map((hands) => ({ label: words.overKeeps(hands), onChoose: () => void start(hands) }))}
          onClose={() => (at.value = null)}
        />
      )}
    </span>
  );
}

/** How far the hands are that act again, and what they could not do now. */
export function Over() {
  const over = recordedOver.value;
  if (over === null) return null;
  return (
    <>
      <span class="timeline-moment">{words.overLeft(over.actions_left)}</span>
      {over.conflicts.slice(0, 1).map(({ hand, reason, message = reason }) => (
        <span key={reason} class="timeline-skipped" role="alert">
          {words.overConflict(hand, message)}
        </span>
      ))}
    </>
  );
}
