import { useEffect } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import { may } from "../allowed";
import { request, scene } from "../studio";
import { texts } from "../texts";
import { NumberField } from "../ui/number_field";
import { chosenImitator, imitators, ProgramChoice, useBrains } from "./brains";
import { choices, freeName, isOpen, refreshJobs, refreshSets, sets } from "./datasets";
import { Choice, JobDialog, NameField } from "./job_dialog";
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

/** Makes many recordings of the robot from one demonstration. */
export function GenerateDialog({ recording }: { recording: string }) {
  useBrains();
  const form = useForm(recording);
  const begin = () =>
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
    });
  const allowed = imitators.value.length > 0 ? may("generate") : texts.brain.noImitators;
  return (
    <JobDialog
      title={words.generateTitle(titleOf(recording))}
      start={{ label: words.generate, allowed, begin }}
      hint={(job) => (isOpen(job) ? words.staysWhenClosed : null)}
      onClose={() => (generated.value = null)}
    >
      <p class="hint">{words.generateAbout}</p>
      <Fields form={form} />
      {allowed !== true && <p class="trouble">{allowed}</p>}
    </JobDialog>
  );
}
