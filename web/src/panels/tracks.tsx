import { useEffect, useRef } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import { HANDS, type Conflict, type HandName, type Timeline } from "../protocol";
import { may } from "../allowed";
import { handColors } from "../colors";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { editedClip, editsOf, roomOf, tracksOf, withMore, type Clip, type ClipEdit, type ClipPart } from "./clips";
import { Effect, useTrial, type Trial } from "./effect";
import { chosenSegment, titleOf } from "./recordings";
import { useSaving, Waiting } from "./simulated";

const { tracks: words } = texts;

/** What an arrow key moves a clip, or one end of it; the second one with Shift [s]. */
const KEY_STEPS = [0.1, 1];

const HALF_TICK = 1 / 120; // [s]

/** A press that moves less is a click [px]. */
const CLICK_PIXELS = 4;

/** A clip of a track, where it is drawn now. */
interface DrawnClip {
  clip: Clip;
  /** As the recording has it. */
  recorded: Clip;
  name: string;
}

/** The change of clips by mouse and keys. */
interface ClipMoves {
  isAllowed: boolean;
  seconds: number;
  /** The edits that move this part of a clip later [s]. */
  editsFor: (clip: Clip, part: ClipPart, later: number) => ClipEdit[];
  /** Shows edits while a clip is dragged. */
  preview: (edits: ClipEdit[]) => void;
  commit: (edits: ClipEdit[]) => void;
  /** Selects the segment in which the clip is taken. */
  choose: (clip: Clip) => void;
}

/** The clip itself, or one of its ends: dragged, or moved by arrow keys; a click or Enter selects the clip. */
function ClipHandle(props: { drawn: DrawnClip; part: ClipPart; moves: ClipMoves }) {
  const { drawn, part, moves } = props;
  const { clip, name } = drawn;
  const grabbed = useSignal<{ x: number; clip: Clip; secondsPerPixel: number } | null>(null);
  const wasDragged = useRef(false);
  const editsAt = (x: number) => {
    const { clip: from, x: at, secondsPerPixel } = grabbed.value!;
    return moves.editsFor(from, part, (x - at) * secondsPerPixel);
  };
  const grab = (event: PointerEvent & { currentTarget: HTMLElement }) => {
    wasDragged.current = false;
    if (!moves.isAllowed || event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const track = event.currentTarget.closest("ol")!.getBoundingClientRect();
    grabbed.value = { x: event.clientX, clip, secondsPerPixel: moves.seconds / Math.max(track.width, 1) };
  };
  const drag = (x: number) => {
    if (grabbed.value === null) return;
    wasDragged.current ||= Math.abs(x - grabbed.value.x) >= CLICK_PIXELS;
    if (wasDragged.current) moves.preview(editsAt(x));
  };
  const leave = (edits: ClipEdit[]) => {
    grabbed.value = null;
    moves.preview([]);
    moves.commit(edits);
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key === "Escape" && grabbed.value !== null) leave([]);
    else if (event.key === "Enter") moves.choose(clip);
    else if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    else if (moves.isAllowed) {
      const step = KEY_STEPS[event.shiftKey ? 1 : 0]!;
      moves.commit(moves.editsFor(clip, part, event.key === "ArrowLeft" ? -step : step));
    }
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div
      class={`clip-${part}`}
      role="slider"
      tabIndex={0}
      aria-label={words.parts[part](name)}
      aria-valuemin={0}
      aria-valuemax={moves.seconds}
      aria-valuenow={part === "end" ? clip.end : clip.begin}
      aria-valuetext={words.clip(clip.what, clip.begin, clip.end)}
      aria-disabled={!moves.isAllowed}
      title={`${words.clip(clip.what, clip.begin, clip.end)}${moves.isAllowed ? `. ${words.how[part]}` : ""}`}
      onClick={() => !wasDragged.current && moves.choose(clip)}
      onPointerDown={grab}
      onPointerMove={(event) => drag(event.clientX)}
      onPointerUp={(event) => grabbed.value && leave(wasDragged.current ? editsAt(event.clientX) : [])}
      onPointerCancel={() => grabbed.value && leave([])}
      onKeyDown={onKey}
    >
      {part === "whole" && name}
    </div>
  );
}

/** A conflict of an edit that is tried; one that the recording contains; or a command that it was recorded without. */
type ConflictKind = "tried" | "kept" | "leftOut";

interface ShownConflict {
  conflict: Conflict;
  kind: ConflictKind;
}

/** What a hand does at a conflict begins a segment, unless it was left out. */
function kindOf({ hand, seconds }: Conflict, segments: Timeline["segments"]): ConflictKind {
  const isDone = segments.some(({ deed, begin }) => deed?.hand === hand && Math.abs(begin - seconds) < HALF_TICK);
  return isDone ? "kept" : "leftOut";
}

/** Where a hand does not find what it found when it was recorded; the reason shows on hover and focus. */
function ConflictMark({ conflict, kind, left, isRight }: ShownConflict & { left: string; isRight: boolean }) {
  const reason = words.conflicts[kind](conflict.seconds, conflict.message ?? conflict.reason);
  return (
    <li class={`conflict ${kind === "leftOut" ? "left-out" : ""}`} style={{ left }}>
      <span role="img" tabIndex={0} aria-label={reason}>
        {kind === "leftOut" ? "i" : "!"}
      </span>
      <span class={`conflict-reason ${isRight ? "right" : ""}`} aria-hidden="true">
        {reason}
      </span>
    </li>
  );
}

function Track(props: { hand: HandName; clips: DrawnClip[]; conflicts: ShownConflict[]; moves: ClipMoves }) {
  const { moves } = props;
  const percent = (time: number) => `${(100 * time) / Math.max(moves.seconds, 1e-9)}%`;
  const isConflicting = ({ begin, end }: Clip) =>
    props.conflicts.some(
      ({ kind, conflict: { seconds } }) => kind !== "leftOut" && seconds >= begin - 1e-6 && seconds <= end + 1e-6,
    );
  return (
    <li class="track" style={{ "--hand": handColors[props.hand] }}>
      <ol>
        {props.clips.map((drawn) => {
          const { first, last, begin, end, isOpen } = drawn.clip;
          const isChosen = chosenSegment.value === first || (chosenSegment.value === last && !isOpen);
          const isEdited = begin !== drawn.recorded.begin || end !== drawn.recorded.end;
          return (
            <li
              key={first}
              class={`clip ${isEdited ? "edited" : ""} ${isConflicting(drawn.clip) ? "conflicting" : ""} ${isChosen ? "chosen" : ""}`}
              style={{ left: percent(begin), width: percent(end - begin) }}
            >
              <ClipHandle drawn={drawn} part="whole" moves={moves} />
              <ClipHandle drawn={drawn} part="begin" moves={moves} />
              {!isOpen && <ClipHandle drawn={drawn} part="end" moves={moves} />}
            </li>
          );
        })}
        {props.conflicts.map(({ conflict, kind }) => (
          <ConflictMark
            key={`${conflict.seconds} ${conflict.reason}`}
            conflict={conflict}
            kind={kind}
            left={percent(conflict.seconds)}
            isRight={conflict.seconds > moves.seconds / 2}
          />
        ))}
      </ol>
    </li>
  );
}

/** The effect of shifted clips, and what becomes of them. */
function ClipEffect(props: { recording: string; edits: Signal<ClipEdit[]>; trial: Trial }) {
  const { recording, edits, trial } = props;
  const { isSaving, save, cancel } = useSaving(() => (edits.value = []));
  const drop = () => {
    cancel();
    edits.value = [];
  };
  return (
    <section class="clip-effect" aria-label={texts.edit.effect}>
      <div role="status">
        <Effect trial={trial} />
        {isSaving.value && <Waiting what="edit" label={texts.edit.saving} />}
      </div>
      <Button label={words.discard} onClick={drop} />
      <Button
        label={texts.edit.save}
        kind="accent"
        isBusy={isSaving.value}
        disabled={trial.state !== "simulated"}
        onClick={() => void save(recording, edits.value, texts.edit.nameOf(titleOf(recording)))}
      />
    </section>
  );
}

/** One row for each hand, one above another: who held what, and what happened at the same time. Clips can be moved. */
export function Tracks(props: { id: string; timeline: Timeline; onChoose: (segment: Timeline["segments"][number]) => void }) {
  const { id, timeline } = props;
  const { segments, seconds } = timeline;
  const edits = useSignal<ClipEdit[]>([]);
  const dragged = useSignal<ClipEdit[]>([]);
  useEffect(() => {
    edits.value = dragged.value = [];
  }, [id, timeline]);
  const all = withMore(edits.value, dragged.value);
  const trial = useTrial(id, all, [id, JSON.stringify(all)]).value;
  const tracks = tracksOf(segments, seconds);
  const clipsOf = (hand: HandName) => tracks.get(hand) ?? [];
  const movesOf = (hand: HandName): ClipMoves => ({
    isAllowed: may("edit") === true,
    seconds,
    editsFor: (clip, part, later) => {
      const now = clipsOf(hand).map((one) => editedClip(one, edits.value));
      return editsOf(clip, part, later, roomOf(clip, hand, segments, now));
    },
    preview: (next) => (dragged.value = next),
    commit: (next) => (edits.value = withMore(edits.value, next)),
    choose: ({ first }) => segments.filter(({ number }) => number === first).forEach(props.onChoose),
  });
  const tried = trial.state === "simulated" ? trial.report.conflicts : [];
  const conflicts = all.length === 0 ? timeline.conflicts : tried;
  const hands = HANDS.filter((hand) => tracks.has(hand) || conflicts.some((one) => one.hand === hand));
  return (
    <>
      <ul class="tracks" aria-label={texts.timeline.tracks}>
        {hands.map((hand) => (
          <Track
            key={hand}
            hand={hand}
            clips={clipsOf(hand).map((recorded) => ({
              recorded,
              clip: editedClip(recorded, all),
              name: `${texts.hands.names[hand]}: ${recorded.what}`,
            }))}
            conflicts={conflicts
              .filter((one) => one.hand === hand)
              .map((conflict) => ({ conflict, kind: all.length > 0 ? "tried" : kindOf(conflict, segments) }))}
            moves={movesOf(hand)}
          />
        ))}
      </ul>
      {all.length > 0 && <ClipEffect recording={id} edits={edits} trial={trial} />}
    </>
  );
}
