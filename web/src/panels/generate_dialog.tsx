import { useEffect } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import { may, when } from "../allowed";
import { jobs, request, scene } from "../studio";
import type { Job } from "../protocol";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { NumberField } from "../ui/number_field";
import { chosenImitator, imitators, ProgramChoice, useBrains } from "./brains";
import { choices, dismiss, freeName, isOpen, refreshJobs, refreshSets, sets, stopJob } from "./datasets";
import { JobProgress } from "./job_progress";
import { generated } from "./page";
import { recordingOf, titleOf } from "./recordings";
import { sceneCatalog } from "./scene_catalog";

const { datasets: words } = texts;

const COUNT = 20;
const MAX_SEED = 1_000_000;

/** The robot's version of the scene of the demonstration, or else that scene. */
function likelyScene(recording: string): string {
  const known = (sceneCatalog.value?.scenes ?? []).map(({ name }) => name);
  const demonstrated = recordingOf(recording)?.scene ?? "";
  const [first] = [`${demonstrated}_robot`, demonstrated, scene.value?.name ?? ""].filter((name) => known.includes(name));
  return first ?? scene.value?.name ?? "";
}

/** The scenes of the gallery, and the one on the table if it is a file of one's own. */
function scenesToChoose(): { name: string; title: string }[] {
  const all = sceneCatalog.value?.scenes ?? [];
  const here = scene.value?.name ?? "";
  return all.some(({ name }) => name === here) ? all : [{ name: here, title: here }, ...all];
}

function useForm(recording: string) {
  const form = {
    name: useSignal(""),
    scene: useSignal(likelyScene(recording)),
    count: useSignal(COUNT),
    level: useSignal("scattered"),
    seed: useSignal(1),
    jobs: useSignal(1),
    variations: useSignal<Record<string, string>>({}),
  };
  useEffect(() => {
    void Promise.all([refreshJobs(), refreshSets()]).then(() => {
      form.name.value ||= freeName(titleOf(recording), (sets.value ?? []).map(({ name }) => name));
      // One core remains for the world.
      form.jobs.value = Math.max(1, (choices.value?.max_jobs ?? 2) - 1);
    });
  }, []);
  return form;
}
type Form = ReturnType<typeof useForm>;

export function Choice(props: { label: string; chosen: Signal<string>; of: { value: string; label: string }[] }) {
  return (
    <label class="field">
      <span class="field-label">{props.label}</span>
      <select value={props.chosen.value} onChange={(event) => (props.chosen.value = event.currentTarget.value)}>
        {props.of.map(({ value, label }) => (
          <option key={value} value={value}>
            {label}
          </option>
        ))}
      </select>
    </label>
  );
}

export function NameField({ label, name }: { label: string; name: Signal<string> }) {
  return (
    <label class="field">
      <span class="field-label">{label}</span>
      <input
        type="text"
        value={name.value}
        maxLength={100}
        onInput={(event) => (name.value = event.currentTarget.value)}
      />
    </label>
  );
}

function Fields({ form }: { form: Form }) {
  const number = (label: string, field: Signal<number>, min: number, max: number) => (
    <NumberField
      label={label}
      isLabelled
      digits={0}
      step={1}
      min={min}
      max={max}
      value={field.value}
      onCommit={(value) => (field.value = Math.round(value))}
    />
  );
  return (
    <>
      <NameField label={words.name} name={form.name} />
      <Choice
        label={words.scene}
        chosen={form.scene}
        of={scenesToChoose().map(({ name, title }) => ({ value: name, label: title }))}
      />
      <label class="field">
        <span class="field-label">{words.brain}</span>
        <ProgramChoice label={words.brain} programs={imitators.value} chosen={chosenImitator} />
      </label>
      <Choice
        label={words.level}
        chosen={form.level}
        of={(choices.value?.levels ?? []).map((level) => ({ value: level, label: words.levelOf(level) }))}
      />
      <div class="numbers">
        {number(words.count, form.count, 1, choices.value?.max_count ?? COUNT)}
        {number(words.seed, form.seed, 0, MAX_SEED)}
        {number(words.jobs, form.jobs, 1, choices.value?.max_jobs ?? 1)}
      </div>
      <Variations chosen={form.variations} />
    </>
  );
}

/** What differs between the attempts, beside the layout: a degree of each kind, or none. */
function Variations({ chosen }: { chosen: Signal<Record<string, string>> }) {
  const choose = (kind: string, degree: string) => {
    const { [kind]: _, ...others } = chosen.value;
    chosen.value = degree === "" ? others : { ...others, [kind]: degree };
  };
  return (
    <details class="variations">
      <summary>{texts.variations.title(Object.keys(chosen.value).map(texts.variations.kind))}</summary>
      <p class="hint">{texts.variations.about}</p>
      {(choices.value?.variations ?? []).map(({ kind, degrees }) => (
        <label class="field" key={kind}>
          <span class="field-label">{texts.variations.kind(kind)}</span>
          <select value={chosen.value[kind] ?? ""} onChange={(event) => choose(kind, event.currentTarget.value)}>
            <option value="">{texts.variations.none}</option>
            {degrees.map(({ name, ranges }) => (
              <option key={name} value={name}>
                {texts.variations.degree(name, ranges)}
              </option>
            ))}
          </select>
        </label>
      ))}
    </details>
  );
}

/** Starts a job; shows why not, and how far it is. */
export function useJob() {
  const number = useSignal<number | null>(null);
  const error = useSignal<string | null>(null);
  const isBusy = useSignal(false);
  const start = async (wanted: Promise<{ job: number }>) => {
    isBusy.value = true;
    error.value = null;
    try {
      number.value = (await wanted).job;
    } catch (reason) {
      error.value = (reason as Error).message;
    }
    isBusy.value = false;
  };
  const job = jobs.value.find((one) => one.job === number.value);
  useEffect(() => {
    // What failed can be corrected where it was entered.
    if (job?.status !== "failed") return;
    dismiss(job);
    number.value = null;
    error.value = job.words;
  }, [job?.status]);
  return { job, error, isBusy, start };
}

/** What the dialogs of jobs have at their end. */
export function JobActions(props: {
  job: Job | undefined;
  start: { label: string; disabled: boolean; title: string | undefined; isBusy: boolean; onClick: () => void };
  onClose: () => void;
}) {
  const { job } = props;
  if (job === undefined) {
    return (
      <>
        <Button label={texts.cancel} onClick={props.onClose} />
        <Button kind="accent" {...props.start} />
      </>
    );
  }
  return (
    <>
      {isOpen(job) && (
        <Button
          label={words.stop}
          icon="stop"
          kind="danger"
          {...when(job.status === "stopping" ? words.stopping : may("stop_job"), words.stopWhy(job))}
          onClick={() => stopJob(job)}
        />
      )}
      <Button label={isOpen(job) ? words.inBackground : texts.close} kind="accent" onClick={props.onClose} />
    </>
  );
}

/** Makes many recordings of the robot from one demonstration. */
export function GenerateDialog({ recording }: { recording: string }) {
  useBrains();
  const form = useForm(recording);
  const { job, error, isBusy, start } = useJob();
  const close = () => (generated.value = null);
  const hasBrain = imitators.value.length > 0 || texts.brain.noImitators;
  const generate = () =>
    start(
      request("generate", {
        recording,
        name: form.name.value,
        scene: form.scene.value,
        brain: chosenImitator.value,
        count: form.count.value,
        level: form.level.value,
        seed: form.seed.value,
        jobs: form.jobs.value,
        variations: form.variations.value,
      }),
    );
  const allowed = when(hasBrain === true ? may("generate") : hasBrain);
  return (
    <Dialog
      title={words.generateTitle(titleOf(recording))}
      onClose={close}
      actions={
        <JobActions
          job={job}
          start={{ label: words.generate, ...allowed, isBusy: isBusy.value, onClick: () => void generate() }}
          onClose={close}
        />
      }
    >
      {job === undefined ? (
        <>
          <p class="hint">{words.generateAbout}</p>
          <Fields form={form} />
          {allowed.disabled && allowed.title && <p class="trouble">{allowed.title}</p>}
          {error.value !== null && (
            <p class="said trouble" role="alert">
              {error.value}
            </p>
          )}
        </>
      ) : (
        <>
          <JobProgress job={job} />
          {isOpen(job) && <p class="hint">{words.staysWhenClosed}</p>}
        </>
      )}
    </Dialog>
  );
}
