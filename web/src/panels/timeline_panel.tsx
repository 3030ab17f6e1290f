import { useEffect, useRef } from "preact/hooks";
import { signal, useSignal } from "@preact/signals";
import type { Allowed, Timeline } from "../protocol";
import { may, mayControlNow, when } from "../allowed";
import { ask, notify, state } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { isSmall } from "../ui/media";
import { Menu } from "../ui/menu";
import { endOfClip, otherEndOfClip } from "./clips";
import { EditDialog, type EditKind } from "./edit_dialog";
import { isRecording, liveSegments, mayControl, recordingId } from "./derived_signals";
import { isTimelineOpen, renamed, shared, sheet } from "./page";
import { Over, RecordOverButton } from "./record_over";
import { attemptOf, chosenSegment, opened, pictureOfSegment } from "./recordings";
import { RateChoice, Scrubber } from "./scrubber";
import { SegmentCard, wordsOf } from "./segment_card";
import { TitleInPlace } from "./title_in_place";
import { Tracks } from "./tracks";

const { timeline: words } = texts;
const HALF_TICK = 1 / 120; // [s]
const rate = signal(1);
/** The moment of the opened recording that is looked at [s]. */
const moment = signal(0);
const edited = signal<{ kind: EditKind; segment: number } | null>(null);

/** The recording in the making: segments come as they are done. */
function LiveTimeline({ id }: { id: string }) {
  const list = useRef<HTMLOListElement>(null);
  const segments = liveSegments.value;
  useEffect(() => list.current?.scrollTo({ left: list.current.scrollWidth }), [segments.length]);
  if (segments.length === 0) return <p class="timeline-empty">{words.none}</p>;
  const control = mayControlNow();
  const whyFixed = control === true ? words.finishFirst : control;
  return (
    <ol class="segments" aria-label={words.segments} ref={list}>
      {segments.map((segment, k) => (
        <SegmentCard
          key={segment.number}
          picture={pictureOfSegment(id, segment.number)}
          segment={segment}
          isNow={k === segments.length - 1}
          isChosen={false}
          whyFixed={whyFixed}
          onChoose={() => notify(whyFixed, true)}
        />
      ))}
    </ol>
  );
}

/** Moments that we asked to be shown and that are not shown yet. */
let numOnTheWay = 0;

async function show(id: string, seconds: number): Promise<void> {
  moment.value = seconds;
  if (!mayControl.value) return;
  numOnTheWay += 1;
  await ask("show", { recording: id, seconds });
  numOnTheWay -= 1;
}

/** The step that was going on at a moment, for a branch to begin at. What is done at that very moment is not done yet. */
function stepAt(timeline: Timeline, seconds: number): { step: number; after: number } | null {
  const begun = (step: Timeline["steps"][number]) => step.parent === null || step.begin < seconds - HALF_TICK;
  const last = timeline.steps.filter((step) => step.on_way && begun(step)).pop();
  return last ? { step: last.step, after: Math.max(0, seconds - last.begin) } : null;
}

/** What belongs to a generated set stays as it was made. */
function mayContinue(id: string): Allowed {
  return attemptOf(id) === null ? may("branch") : texts.attempts.staysAsMade;
}

async function branch(id: string, step: number, after?: number): Promise<void> {
  const reply = await ask("branch", { recording: id, step, ...(after === undefined ? {} : { after }) });
  if (reply !== null) opened.value = null;
}

async function correct(id: string, seconds: number): Promise<void> {
  const reply = await ask("correct", { recording: id, seconds });
  if (reply !== null) opened.value = null;
}

/** Where playback begins: a segment or recording played to its end starts again, else it continues from the moment. */
function beginOfPlay({ segments, seconds }: Timeline): number {
  const chosen = segments.find(({ number }) => number === chosenSegment.value);
  const isAt = (end: number) => Math.abs(moment.value - end) < 0.05;
  if (chosen !== undefined && isAt(chosen.end)) return chosen.begin;
  return isAt(seconds) ? 0 : moment.value;
}

function PlayButtons({ id, timeline }: { id: string; timeline: Timeline }) {
  const playback = state.value?.playback ?? null;
  const isShown = playback?.recording === id;
  const isPlaying = isShown && playback.rate > 0;
  const play = async () => {
    const begin = beginOfPlay(timeline);
    if (!isShown || begin !== moment.value) await ask("show", { recording: id, seconds: begin });
    await ask("play", { rate: rate.value });
  };
  const chooseRate = (next: number) => {
    rate.value = next;
    if (isPlaying) void ask("play", { rate: next });
  };
  return (
    <>
      <Button
        label={isPlaying ? words.stop : words.play}
        icon={isPlaying ? "pause" : "play"}
        kind="accent"
        {...when(may("show"))}
        onClick={() => void (isPlaying ? ask("play", { rate: 0 }) : play())}
      />
      <RateChoice rate={rate.value} onChoose={chooseRate} />
    </>
  );
}

/** All actions, including undone ones; a recording can continue from each of them. */
function HistoryButton({ id, timeline }: { id: string; timeline: Timeline }) {
  const at = useSignal<{ x: number; y: number } | null>(null);
  const holder = useRef<HTMLSpanElement>(null);
  const open = () => {
    const box = holder.current!.getBoundingClientRect();
    at.value = { x: box.left, y: box.top };
  };
  const entries = timeline.steps.map((step) => {
    const undone = step.on_way ? "" : ` (${words.undone})`;
    return {
      label: `${step.step}: ${wordsOf(step)}${undone}`,
      onChoose: () => void branch(id, step.step),
    };
  });
  return (
    <span ref={holder}>
      <Button label={words.history} {...when(mayContinue(id), words.historyTitle)} onClick={open} />
      {at.value && (
        <Menu label={`${words.historyTitle}. ${words.branch}`} {...at.value} entries={entries} onClose={() => (at.value = null)} />
      )}
    </span>
  );
}

function EditButtons({ id, timeline }: { id: string; timeline: Timeline }) {
  const chosen = chosenSegment.value;
  const allowed = may("edit");
  const isBlocked = allowed !== true || chosen === null;
  const edit = (kind: EditKind) => () => chosen !== null && (edited.value = { kind, segment: chosen });
  const here = stepAt(timeline, moment.value);
  const why = (sentence: string) => when(allowed, chosen === null ? words.chooseFirst : sentence).title;
  return (
    <>
      <Button
        label={words.branch}
        icon="branch"
        title={when(mayContinue(id), words.branchWhy).title}
        disabled={mayContinue(id) !== true || here === null}
        onClick={() => here && void branch(id, here.step, here.after)}
      />
      <Button
        label={words.correct}
        title={when(may("correct"), words.correctWhy).title}
        disabled={may("correct") !== true}
        onClick={() => void correct(id, moment.value)}
      />
      <RecordOverButton
        id={id}
        timeline={timeline}
        seconds={moment.value}
        onStarted={() => (opened.value = null)}
      />
      <Button label={words.trim} icon="cut" title={why(words.trimWhy)} disabled={isBlocked} onClick={edit("trim")} />
      <Button
        label={words.shift}
        title={why(words.shiftWhy)}
        disabled={isBlocked || !timeline.segments.some(({ number, deed }) => number === chosen && deed?.hand)}
        onClick={edit("shift")}
      />
      <Button label={words.drop} icon="trash" title={why(words.dropWhy)} disabled={isBlocked} onClick={edit("drop")} />
      <HistoryButton id={id} timeline={timeline} />
    </>
  );
}

/** The moment is the one that is shown, but while we go to another. */
function useMoment(id: string): void {
  useEffect(() => {
    moment.value = 0;
    return state.subscribe((now) => {
      const playback = now?.playback;
      if (playback?.recording === id && numOnTheWay === 0) moment.value = playback.seconds;
    });
  }, [id]);
}

function OpenedTimeline({ id, timeline }: { id: string; timeline: Timeline }) {
  useMoment(id);
  const now = moment.value;
  const choose = (number: number | null, end: number) => {
    chosenSegment.value = number;
    void show(id, end);
  };
  const paired = chosenSegment.value === null ? null : otherEndOfClip(timeline.segments, chosenSegment.value);
  return (
    <>
      <Scrubber
        seconds={now}
        length={timeline.seconds}
        marks={timeline.segments.slice(1).map(({ begin }) => begin)}
        disabled={may("show") !== true}
        onMoment={(seconds) => void show(id, seconds)}
      />
      <Tracks id={id} timeline={timeline} onChoose={({ number, end }) => choose(number, end)} />
      <ol class="segments" aria-label={words.segments}>
        {timeline.segments.map(({ number, deed, begin, end }) => (
          <SegmentCard
            key={number}
            picture={pictureOfSegment(id, number)}
            segment={{ number, deed, seconds: end - begin }}
            {...(timeline.segments.length === 1 ? { title: words.whole } : {})}
            isNow={now > begin && now <= end}
            isChosen={chosenSegment.value === number}
            isPaired={paired === number}
            onChoose={() => choose(chosenSegment.value === number ? null : number, end)}
          />
        ))}
      </ol>
    </>
  );
}

function EditOf({ id, timeline }: { id: string; timeline: Timeline }) {
  const edit = edited.value;
  const segment = timeline.segments.find((one) => one.number === edit?.segment);
  if (edit === null || segment === undefined) return null;
  const other = timeline.segments.find(({ number }) => number === otherEndOfClip(timeline.segments, segment.number));
  return (
    <EditDialog
      key={`${edit.kind} ${edit.segment}`}
      kind={edit.kind}
      recording={id}
      segment={{
        number: segment.number,
        title: wordsOf(segment),
        seconds: segment.end - segment.begin,
        last: endOfClip(timeline.segments, segment.number),
        otherEnd: other === undefined ? null : { number: other.number, title: wordsOf(other) },
      }}
      onClose={() => (edited.value = null)}
    />
  );
}

function Head() {
  const recording = state.value?.recording;
  const open = isRecording.value ? null : opened.value;
  return (
    <header class="timeline-head">
      <h2>
        <button
          type="button"
          aria-expanded={isTimelineOpen.value}
          onClick={() => (isSmall.value ? (sheet.value = null) : (isTimelineOpen.value = !isTimelineOpen.value))}
        >
          {words.title}
        </button>
      </h2>
      {recording && <span class="timeline-name">{recording.title || recording.id}</span>}
      {open && (
        <span class="timeline-name">
          <TitleInPlace key={open.id} id={open.id} isFixed={attemptOf(open.id) !== null} />
        </span>
      )}
      {recording && (
        <span class="eye-records">
          {words.recording} · {texts.seconds(recording.seconds)}
        </span>
      )}
      {recording?.corrects && (
        <span class="timeline-moment">{words.corrects(recording.corrects.title, recording.corrects.seconds)}</span>
      )}
      <Over />
      {open && isTimelineOpen.value && (
        <>
          <span class="timeline-moment">{words.of(moment.value, open.timeline.seconds)}</span>
          <Button
            label={words.rename}
            icon="pencil"
            kind="quiet"
            isIconOnly
            disabled={!mayControl.value || attemptOf(open.id) !== null}
            onClick={() => (renamed.value = open.id)}
          />
          <Button
            label={texts.sharing.entry}
            icon="share"
            kind="quiet"
            isIconOnly
            {...when(may("share"))}
            onClick={() => (shared.value = open.id)}
          />
          <div class="timeline-buttons">
            <PlayButtons id={open.id} timeline={open.timeline} />
            <EditButtons id={open.id} timeline={open.timeline} />
          </div>
          <Button
            label={words.close}
            icon="cross"
            kind="quiet"
            isIconOnly
            onClick={() => {
              if (may("live") === true) void ask("live");
              opened.value = null;
            }}
          />
        </>
      )}
    </header>
  );
}

/** What is recorded, or was: its segments in words and pictures. */
export function TimelinePanel() {
  if (isSmall.value && sheet.value !== "timeline") return null;
  const live = recordingId.value;
  const open = opened.value;
  const isShown = isTimelineOpen.value || isSmall.value;
  return (
    <section class="timeline" aria-label={words.title} data-tour="timeline">
      <Head />
      {isShown &&
        (live !== null ? (
          <LiveTimeline id={live} />
        ) : open !== null ? (
          <OpenedTimeline id={open.id} timeline={open.timeline} />
        ) : (
          <p class="timeline-empty">{words.empty}</p>
        ))}
      {open !== null && live === null && <EditOf id={open.id} timeline={open.timeline} />}
    </section>
  );
}
