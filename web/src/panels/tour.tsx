import { useEffect } from "preact/hooks";
import { computed, signal } from "@preact/signals";
import { isOffered } from "../allowed";
import { isController, scene } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { cameraKind } from "../world/signals";
import { isTourKnown, showPanel } from "./page";
import * as conditions from "./tour_conditions";

interface Step {
  name: string;
  /** Absent: the user presses a button to continue. */
  condition?: conditions.Condition;
  /** What it is about: the element with this data-tour. */
  about?: string;
}

/** It asks where things come to rest. */
export const hasTour = computed(() => isOffered("support"));
const STEPS: Step[] = [
  { name: "welcome" },
  { name: "look", condition: conditions.lookedAround },
  { name: "record", condition: conditions.recording, about: "record" },
  { name: "grasp", condition: conditions.grasped, about: "objects" },
  { name: "lift", condition: conditions.lifted, about: "nudge" },
  { name: "turn", condition: conditions.turned, about: "turn" },
  { name: "stack", condition: conditions.stacked, about: "release" },
  { name: "undo", condition: conditions.undone, about: "undo" },
  { name: "redo", condition: conditions.redone, about: "redo" },
  { name: "finish", condition: conditions.finished, about: "record" },
  { name: "end" },
];
/** Duration of the praise. */
const PRAISE_MS = 1100;

const { tour: words } = texts;
const at = signal<number | null>(null);
const isPraised = signal(false);
const step = computed(() => (at.value === null ? null : (STEPS[at.value] ?? null)));

export function startTour(): void {
  isPraised.value = false;
  at.value = 0;
}

function leave(): void {
  at.value = null;
  isTourKnown.value = true;
}

function next(): void {
  isPraised.value = false;
  if (at.value === null) return;
  if (at.value + 1 < STEPS.length) at.value += 1;
  else leave();
}

/** What was not undone cannot be done again either. */
function skip(): void {
  const isUndo = step.value?.name === "undo";
  next();
  if (isUndo) next();
}

/** Watches the condition of the step, praises the user when it is met, and continues. */
function useCondition(): void {
  useEffect(() => {
    const condition = step.value?.condition;
    if (!condition) return;
    let timer = 0;
    const stop = condition(() => {
      if (timer !== 0) return;
      isPraised.value = true;
      timer = window.setTimeout(next, PRAISE_MS);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [step.value]);
}

/** What the step is about is marked on the page. */
function useMark(): void {
  useEffect(() => {
    const name = step.value?.about;
    if (name === "objects") showPanel("objects");
    if (name === "nudge" || name === "turn" || name === "release") showPanel("hands");
    const style = document.createElement("style");
    if (name) style.textContent = `[data-tour="${name}"] { outline: 3px solid var(--accent); outline-offset: 3px; }`;
    document.head.append(style);
    return () => style.remove();
  }, [step.value]);
}

function useFirstStart(): void {
  const isThere = scene.value !== null;
  useEffect(() => {
    if (isThere && !isTourKnown.value) startTour();
  }, [isThere]);
}

function TourButtons({ now }: { now: Step }) {
  if (now.name === "welcome") {
    return (
      <>
        <Button label={words.later} onClick={leave} />
        <Button label={words.begin} kind="accent" onClick={next} />
      </>
    );
  }
  if (!now.condition) return <Button label={words.done} kind="accent" onClick={next} />;
  return (
    <>
      <Button label={words.leave} kind="quiet" onClick={leave} />
      <Button label={words.skip} onClick={skip} />
    </>
  );
}

/** Two minutes with a block, recorded from the first grasp on: every step waits for its condition. */
export function Tour() {
  useFirstStart();
  useCondition();
  useMark();
  const now = step.value;
  if (now === null) return null;
  const [title, sentence] = words.steps[now.name]!;
  const number = at.value!;
  // Over the robot; seen from the top, over the near end of the table: not over the blocks.
  const place = cameraKind.value === "top" ? "low" : "high";
  return (
    <section class={`tour ${place}`} role="region" aria-label={words.title}>
      <div class="tour-words" role="status">
        <small>{words.step(number + 1, STEPS.length)}</small>
        <h2>{isPraised.value ? words.well : title}</h2>
        <p>{sentence}</p>
        {now.condition && !isController.value && <p class="trouble">{words.needsControl}</p>}
      </div>
      <progress aria-hidden="true" value={number} max={STEPS.length - 1} />
      <div class="row end">
        <TourButtons now={now} />
      </div>
    </section>
  );
}
