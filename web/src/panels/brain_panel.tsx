import { useEffect, useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, when } from "../allowed";
import { ask, consoleLines, lastScore, notify, scene } from "../studio";
import type { ConsoleLine } from "../protocol";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Card, Empty } from "../ui/card";
import { brains, chosenBrain, chosenImitator, imitators, ProgramChoice, useBrains } from "./brains";
import { sceneCatalog } from "./scene_catalog";
import { brain, isBrainAtWork } from "./derived_signals";
import { toImitate } from "./page";
import { recordings, titleOf } from "./recordings";

const { brain: words } = texts;

async function copyPlace(place: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(place);
  } catch {
    // Without permission to write to the clipboard, the notice still contains the place.
  }
  notify(words.copied(place));
}

function placeOf(file: string, line: number | undefined): string {
  return line ? `${file}:${line}` : file;
}

function Place({ file, line }: { file: string; line: number | undefined }) {
  const place = placeOf(file, line);
  return (
    <button type="button" class="place" title={words.copyPlace(place)} onClick={() => void copyPlace(place)}>
      {place}
    </button>
  );
}

function Status() {
  const now = brain.value;
  const status = now?.status || "none";
  const isOther = now !== null && now.name !== "" && now.name !== chosenBrain.value;
  return (
    <span class={`badge status-${status}`} role="status">
      {status === "starting" && <span class="spinner" />}
      {/* An imitating brain is chosen elsewhere. */}
      {isOther && `${now.name} `}
      {words.statuses[status] ?? status}
    </span>
  );
}

function StartProgram() {
  const now = brain.value;
  const name = now?.name || chosenBrain.value;
  const start = (program: string) => void ask("start_brain", { brain: program });
  const restart = async () => {
    if (isBrainAtWork.value) await ask("stop_brain");
    start(name);
  };
  return (
    <>
      <ProgramChoice
        label={words.choose}
        programs={brains.value ?? []}
        chosen={chosenBrain}
        running={isBrainAtWork.value ? now?.name ?? null : null}
      />
      <div class="row">
        {isBrainAtWork.value ? (
          <Button
            label={words.stop}
            icon="stop"
            kind="danger"
            class="grow"
            {...when(may("stop_brain"))}
            onClick={() => void ask("stop_brain")}
          />
        ) : (
          <Button
            label={words.start}
            icon="play"
            kind="accent"
            class="grow"
            {...when(chosenBrain.value === "" ? words.none : may("start_brain"))}
            onClick={() => start(chosenBrain.value)}
          />
        )}
        <Button
          label={words.restart}
          icon="reload"
          {...when(now?.name ? may(isBrainAtWork.value ? "stop_brain" : "start_brain") : words.noneYet)}
          onClick={() => void restart()}
        />
      </div>
      {now?.message && (
        <p class={now.status === "failed" ? "trouble" : "hint"}>
          {now.message} {now.file && <Place file={now.file} line={now.line} />}
        </p>
      )}
    </>
  );
}

/** Returns the cause of a failure in words: the brain may fail although all objects are in place. */
function causeOf(result: Record<string, unknown>): string {
  const cause = result.cause as { text?: unknown; message?: unknown } | null | undefined;
  const text = cause?.message ?? cause?.text;
  return typeof text === "string" ? text : words.notRebuilt;
}

function Score() {
  const result = lastScore.value;
  if (result === null) return null;
  // What was right before the robot began is no part of its work.
  const achieved = typeof result.gain === "number" ? result.gain : result.score;
  const score = typeof achieved === "number" ? achieved : 0;
  const error = typeof result.mean_error_mm === "number" ? words.meanError(result.mean_error_mm) : null;
  const took = typeof result.seconds === "number" ? words.took(result.seconds) : null;
  return (
    <div class={`score ${result.success === true ? "good" : ""}`} role="status" aria-label={words.score}>
      <strong>{words.scored(Math.round(100 * score))}</strong>
      <span>{result.success === true ? words.rebuilt : causeOf(result)}</span>
      <small>{[error, took].filter((text) => text !== null).join(" · ")}</small>
    </div>
  );
}

function Imitation() {
  const chosenPlace = useSignal<string | null>(null);
  const isBusy = useSignal(false);
  const choices = (recordings.value ?? []).filter((recording) => !recording.binned && !recording.error);
  if (choices.length === 0) return <p class="hint">{words.noRecordings}</p>;
  if (imitators.value.length === 0) return <p class="hint">{words.noImitators}</p>;
  const chosen = choices.some(({ id }) => id === toImitate.value) ? toImitate.value! : choices[0]!.id;
  // Where it was recorded, unless that scene comes from elsewhere.
  const scenes = sceneCatalog.value?.scenes ?? [];
  const recordedIn = choices.find(({ id }) => id === chosen)?.scene;
  const ownPlace = scenes.some(({ name }) => name === recordedIn) ? recordedIn! : "";
  const where = chosenPlace.value ?? ownPlace;
  const imitate = async () => {
    isBusy.value = true;
    lastScore.value = null;
    // The imitation becomes the newest recording: the demonstration stays the chosen one.
    toImitate.value = chosen;
    const place = where || (scene.value?.name ?? "");
    await ask("imitate", { recording: chosen, brain: chosenImitator.value, scene: place });
    isBusy.value = false;
  };
  return (
    <>
      <label class="field">
        <span class="field-label">{words.demonstration}</span>
        <select value={chosen} onChange={(event) => (toImitate.value = event.currentTarget.value)}>
          {choices.map(({ id }) => (
            <option key={id} value={id}>
              {titleOf(id)}
            </option>
          ))}
        </select>
      </label>
      <label class="field">
        <span class="field-label">{words.imitator}</span>
        <ProgramChoice label={words.imitator} programs={imitators.value} chosen={chosenImitator} />
      </label>
      <label class="field">
        <span class="field-label">{words.scene}</span>
        <select value={where} onChange={(event) => (chosenPlace.value = event.currentTarget.value)}>
          {ownPlace !== "" && <option value={ownPlace}>{words.sceneOfDemonstration(ownPlace)}</option>}
          <option value="">{words.sceneHere}</option>
          {scenes.map(({ name, title }) => (
            <option key={name} value={name} disabled={name === ownPlace}>
              {title} ({name})
            </option>
          ))}
        </select>
      </label>
      <Button
        label={words.imitate}
        icon="robot"
        kind="accent"
        isBusy={isBusy.value}
        {...when(may("imitate"), words.imitateWhy)}
        onClick={() => void imitate()}
      />
      <Score />
    </>
  );
}

function Line({ line }: { line: ConsoleLine }) {
  const place = line.file ? placeOf(line.file, line.line) : null;
  // Many lines begin with their place themselves.
  const text = place !== null && line.text.startsWith(`${place}: `) ? line.text.slice(place.length + 2) : line.text;
  return (
    <div>
      {line.file && (
        <>
          <Place file={line.file} line={line.line} />{" "}
        </>
      )}
      {text}
    </div>
  );
}

/** The output of the program; it stays at the end unless the user scrolls up. */
function Console() {
  const log = useRef<HTMLDivElement>(null);
  const isAtEnd = useRef(true);
  const lines = consoleLines.value;
  useEffect(() => {
    if (isAtEnd.current && log.current) log.current.scrollTop = log.current.scrollHeight;
  }, [lines]);
  return (
    <div
      class="console"
      role="log"
      aria-label={words.console}
      tabIndex={0}
      ref={log}
      onScroll={(event) => {
        const { scrollTop, scrollHeight, clientHeight } = event.currentTarget;
        isAtEnd.current = scrollHeight - scrollTop - clientHeight < 8;
      }}
    >
      {lines.length === 0 ? <p class="hint">{words.consoleEmpty}</p> : lines.map((line, k) => <Line key={k} line={line} />)}
    </div>
  );
}

export function BrainPanel() {
  useBrains();
  if (brains.value?.length === 0) return <Empty icon="brain" text={words.none} />;
  return (
    <>
      <Card title={words.title} aside={<Status />}>
        <StartProgram />
      </Card>
      <Card title={words.imitation}>
        <Imitation />
      </Card>
      <Card
        title={words.console}
        aside={
          <Button
            label={words.clear}
            icon="trash"
            kind="quiet"
            isIconOnly
            onClick={() => (consoleLines.value = [])}
          />
        }
      >
        <Console />
      </Card>
    </>
  );
}
