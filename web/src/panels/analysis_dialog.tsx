import { useEffect } from "preact/hooks";
import { type Signal, useSignal } from "@preact/signals";
import { may } from "../allowed";
import type { ActionSummary } from "../protocol";
import { cancelableRequest } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { analyzed } from "./page";
import { titleOf } from "./recordings";
import { type Edits, useSaving, Waiting } from "./simulated";

const { analysis: words } = texts;

/** What matters in a recording, as docs/analysis.md has it. */
interface Analysis {
  goals: { id: string; words: string; counts: boolean }[];
  properties: { property: "color" | "place"; object: string | null; tried: string | null; harm: string | null }[];
  why_not_moved: string | null;
  subtasks: { number: number; segments: [number, number]; parts: ActionSummary[]; without: string | null }[];
  order: { before: number; after: number; otherwise: string }[];
  sufficient: number[];
}
type Trial =
  | { state: "simulating" }
  | { state: "refused"; error: string }
  | { state: "analyzed"; analysis: Analysis; graph: string };

function useAnalysis(recording: string, ignored: string[]) {
  const trial = useSignal<Trial>({ state: "simulating" });
  useEffect(() => {
    trial.value = { state: "simulating" };
    const { answer, cancel } = cancelableRequest("analyze", { recording, ignored });
    answer.then(
      ({ analysis, graph }) => (trial.value = { state: "analyzed", analysis: analysis as Analysis, graph }),
      (error: Error) => (trial.value = { state: "refused", error: error.message }),
    );
    return cancel;
  }, [recording, ignored]);
  return trial;
}

/** Deletes what is not sufficient, the last first: numbers of segments before it stay as they are. */
function shorteningOf({ subtasks, sufficient }: Analysis): Edits {
  const rest = subtasks.filter(({ number }) => !sufficient.includes(number));
  return rest.reverse().map(({ segments: [first, last] }) => ({ do: "drop", first, last }));
}

/** What the demonstration achieved; a person ticks what counts. The last one that counts stays. */
function Goals({ goals, ignored }: { goals: Analysis["goals"]; ignored: Signal<string[]> }) {
  const { value } = ignored;
  const toggle = (id: string) =>
    (ignored.value = value.includes(id) ? value.filter((one) => one !== id) : [...value, id]);
  return (
    <fieldset class="goals">
      <legend>{words.goals}</legend>
      {goals.map(({ id, words: what }) => {
        const counts = !value.includes(id);
        return (
          <label key={id}>
            <input
              type="checkbox"
              checked={counts}
              disabled={counts && value.length === goals.length - 1}
              onChange={() => toggle(id)}
            />
            <span>{what}</span>
          </label>
        );
      })}
    </fieldset>
  );
}

function Properties({ properties, why_not_moved: why }: Analysis) {
  return (
    <section>
      <h3>{words.properties}</h3>
      <ul>
        {properties.map(({ property, object, tried, harm }) => (
          <li key={`${property} ${object} ${tried}`}>{words.property(object, tried, harm)}</li>
        ))}
      </ul>
      <p class="hint">{words.propertiesHint}</p>
      {why !== null && <p class="hint">{words.notMoved(why)}</p>}
    </section>
  );
}

/** What came of a subtask. */
const partsIn = (parts: ActionSummary[]) => parts.map((part) => texts.action(part)).join(", ");

/** The graph with the names of its subtasks in the language of the page; the program drew it in English. */
function named(graph: string, subtasks: Analysis["subtasks"]): string {
  const drawing = new DOMParser().parseFromString(graph, "text/html").querySelector("svg")!;
  const letters = Number(drawing.dataset["letters"]);
  drawing.querySelectorAll("g").forEach((box, i) => {
    const { number, parts } = subtasks[i]!;
    const name = partsIn(parts);
    box.querySelector("title")!.textContent = `${number}. ${name}`;
    box.querySelector("text")!.textContent = `${number}. ${name.length > letters ? `${name.slice(0, letters - 1)}…` : name}`;
  });
  drawing.setAttribute("aria-label", words.graph);
  return drawing.outerHTML;
}

function Findings({ analysis, graph }: { analysis: Analysis; graph: string }) {
  const { subtasks, order, sufficient } = analysis;
  return (
    <>
      {/* The program drew it, with all texts escaped. */}
      <div class="order-graph" tabIndex={0} dangerouslySetInnerHTML={{ __html: named(graph, subtasks) }} />
      <section>
        <h3>{words.subtasks}</h3>
        <ul>
          {subtasks.map(({ number, parts, without }) => (
            <li key={number}>{words.subtask(number, partsIn(parts), without)}</li>
          ))}
        </ul>
        {sufficient.length < subtasks.length && <p>{words.enough(sufficient)}</p>}
      </section>
      <section>
        <h3>{words.orders}</h3>
        <ul>
          {order.map(({ before, after, otherwise }) => (
            <li key={`${before} ${after}`}>{words.order(after, before, otherwise)}</li>
          ))}
        </ul>
        <p>{words.anyOrder(order.length === 0)}</p>
      </section>
      <Properties {...analysis} />
    </>
  );
}

/** Simulates a recording in other ways, and shows which of its subtasks mattered, and in which order. */
export function AnalysisDialog({ recording }: { recording: string }) {
  const ignored = useSignal<string[]>([]);
  const trial = useAnalysis(recording, ignored.value);
  /** Of the last analysis, also while it is done again with other goals. */
  const goals = useSignal<Analysis["goals"]>([]);
  const { isSaving, save, cancel } = useSaving(() => (analyzed.value = null));
  const close = () => {
    cancel();
    analyzed.value = null;
  };
  const { value } = trial;
  useEffect(() => {
    if (value.state === "analyzed") goals.value = value.analysis.goals;
  }, [value]);
  const edits = value.state === "analyzed" ? shorteningOf(value.analysis) : [];
  return (
    <Dialog
      title={words.title(titleOf(recording))}
      class="is-wide"
      isForReading
      onClose={close}
      actions={
        <>
          {edits.length > 0 && (
            <Button
              label={words.shorten}
              isBusy={isSaving.value}
              disabled={may("edit") !== true}
              onClick={() => void save(recording, edits, words.nameOf(titleOf(recording)))}
            />
          )}
          <Button label={texts.close} kind="accent" onClick={close} />
        </>
      }
    >
      <p class="hint">{words.about}</p>
      {goals.value.length > 0 && <Goals goals={goals.value} ignored={ignored} />}
      <div class="findings" role="status">
        {value.state === "simulating" && <Waiting what="analyze" label={words.simulating} />}
        {value.state === "refused" && <p class="trouble">{value.error}</p>}
        {value.state === "analyzed" && <Findings analysis={value.analysis} graph={value.graph} />}
      </div>
      {isSaving.value && <Waiting what="edit" label={texts.edit.saving} />}
    </Dialog>
  );
}
