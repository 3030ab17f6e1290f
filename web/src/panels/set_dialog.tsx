import { useEffect } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import type { GeneratedSet, SetAttempt } from "../protocol";
import { jobs, request } from "../studio";
import { texts } from "../texts";
import { Button, Chips } from "../ui/buttons";
import { Picture } from "../ui/card";
import { Dialog } from "../ui/dialog";
import { Icon } from "../ui/icons";
import { Causes } from "./job_progress";
import { open } from "./library_panel";
import { openedSet } from "./page";
import { eyePictureOf } from "./recordings";

const { attempts: words } = texts;

/** Pictures are drawn on request: not thousands at once. */
const AT_ONCE = 60;
const OUTCOMES = ["success", "failure"] as const;
type Content = { set: GeneratedSet; attempts: SetAttempt[] };

/** Reads the set again whenever its job has made more of it. */
function useContent(name: string) {
  const content = useSignal<Content | null>(null);
  const error = useSignal<string | null>(null);
  const job = [...jobs.value].reverse().find((one) => one.do === "generate" && one.name === name);
  useEffect(() => {
    request("open_set", { set: name }).then(
      (reply) => (content.value = reply),
      (reason: Error) => (error.value = reason.message),
    );
  }, [name, job?.attempts, job?.status]);
  return { content, error };
}

/** `7` or `10-20`; null for all, undefined for what is neither. */
export function seedsIn(text: string): [number, number] | null | undefined {
  if (text.trim() === "") return null;
  const match = /^\s*(\d+)\s*(?:[-–]\s*(\d+)\s*)?$/.exec(text);
  if (match === null) return undefined;
  const low = Number(match[1]);
  return [low, match[2] === undefined ? low : Number(match[2])];
}

function useFilters() {
  const outcomes = useSignal<string[]>([...OUTCOMES]);
  const cause = useSignal("");
  const seeds = useSignal("");
  const passes = (attempt: SetAttempt) => {
    const range = seedsIn(seeds.value) ?? null;
    return (
      outcomes.value.includes(attempt.outcome) &&
      (cause.value === "" || attempt.cause?.word === cause.value) &&
      (range === null || (attempt.seed >= range[0] && attempt.seed <= range[1]))
    );
  };
  return { outcomes, cause, seeds, passes };
}
type Filters = ReturnType<typeof useFilters>;

function toggle(list: Signal<string[]>, value: string): void {
  list.value = list.value.includes(value) ? list.value.filter((one) => one !== value) : [...list.value, value];
}

function FilterRow({ filters, causes }: { filters: Filters; causes: string[] }) {
  const isWrong = seedsIn(filters.seeds.value) === undefined;
  return (
    <div class="filters">
      <Chips
        label={words.outcomes}
        choices={OUTCOMES.map((value) => ({ value, label: words.outcome[value] }))}
        chosen={filters.outcomes.value}
        onToggle={(value) => toggle(filters.outcomes, value)}
      />
      <label class="inline-field">
        <span>{words.cause}</span>
        <select value={filters.cause.value} onChange={(event) => (filters.cause.value = event.currentTarget.value)}>
          <option value="">{words.anyCause}</option>
          {causes.map((cause) => (
            <option key={cause} value={cause}>
              {texts.datasets.causeOf(cause)}
            </option>
          ))}
        </select>
      </label>
      <label class="inline-field">
        <span>{words.seeds}</span>
        <input
          type="text"
          class="seeds"
          placeholder="7, 10-20"
          value={filters.seeds.value}
          aria-invalid={isWrong}
          onInput={(event) => (filters.seeds.value = event.currentTarget.value)}
        />
      </label>
      {isWrong && <p class="trouble">{words.seedsWrong}</p>}
    </div>
  );
}

/** Opens the recording of an attempt, as others are opened. */
function show(recording: string): void {
  openedSet.value = null;
  void open(recording);
}

function AttemptCard({ attempt }: { attempt: SetAttempt }) {
  const { recording, seed, cause, outcome } = attempt;
  const about = cause?.message ?? cause?.text ?? words.outcome.success;
  return (
    <li>
      <button
        type="button"
        class={`attempt ${outcome}`}
        title={about}
        disabled={recording === null}
        onClick={() => recording !== null && show(recording)}
      >
        {recording === null ? (
          <span class="picture">
            <Icon name="warning" size={28} />
          </span>
        ) : (
          <Picture source={eyePictureOf(recording)} alt="" />
        )}
        <span class="attempt-words">
          <Icon name={outcome === "success" ? "check" : "warning"} size={16} />
          <strong>{words.seed(seed)}</strong>
          <span class="attempt-cause">{cause === null ? words.outcome.success : texts.datasets.causeOf(cause.word)}</span>
        </span>
      </button>
    </li>
  );
}

function Attempts({ attempts }: { attempts: SetAttempt[] }) {
  const shown = useSignal(AT_ONCE);
  return (
    <>
      <ul class="attempts" aria-label={words.title}>
        {attempts.slice(0, shown.value).map((attempt) => (
          <AttemptCard key={attempt.seed} attempt={attempt} />
        ))}
      </ul>
      {attempts.length > shown.value && (
        <Button label={words.more(attempts.length - shown.value)} onClick={() => (shown.value += AT_ONCE)} />
      )}
    </>
  );
}

function Grid({ content }: { content: Content }) {
  const filters = useFilters();
  const { set, attempts } = content;
  const found = attempts.filter(filters.passes);
  return (
    <>
      <p>
        {texts.datasets.episodes(set.episodes, set.wanted)} · {texts.datasets.yield(set.attempts, set.yield, set.interval)}
      </p>
      <Causes causes={set.causes} />
      <FilterRow filters={filters} causes={Object.keys(set.causes)} />
      <p class="hint" role="status">
        {words.found(found.length, attempts.length)}
      </p>
      <Attempts attempts={found} />
    </>
  );
}

/** The attempts of a generated set, each with its last picture. */
export function SetDialog({ name }: { name: string }) {
  const { content, error } = useContent(name);
  return (
    <Dialog title={words.of(name)} class="is-grid" isForReading onClose={() => (openedSet.value = null)}>
      {error.value !== null && <p class="trouble">{error.value}</p>}
      {content.value === null && error.value === null && <span class="spinner" />}
      {content.value !== null && <Grid content={content.value} />}
    </Dialog>
  );
}
