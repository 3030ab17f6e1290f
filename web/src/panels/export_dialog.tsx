import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may } from "../allowed";
import { request } from "../studio";
import { texts } from "../texts";
import { Chips } from "../ui/buttons";
import { Switch } from "../ui/switch";
import { choices, freeName, isOpen, refreshJobs } from "./datasets";
import { Choice, JobDialog, NameField } from "./job_dialog";
import { exported } from "./page";
import { titleOf } from "./recordings";

const { exporting: words } = texts;

const SIZES = ["96x96", "160x120", "224x224", "320x240", "640x480"];
type Source = { recording: string } | { set: string };

function titleOfSource(source: Source): string {
  return "set" in source ? source.set : titleOf(source.recording);
}

function useForm(source: Source) {
  const form = {
    name: useSignal(freeName(titleOfSource(source), [])),
    format: useSignal("lerobot-v3.0"),
    cameras: useSignal<string[]>(["eye"]),
    size: useSignal("320x240"),
    rate: useSignal("30"),
    withFailures: useSignal(false),
    withoutConstant: useSignal(false),
  };
  useEffect(() => void refreshJobs(), []);
  return form;
}
type Form = ReturnType<typeof useForm>;

function wantedOf(source: Source, form: Form) {
  const [width, height] = form.size.value.split("x").map(Number);
  return {
    ...source,
    name: form.name.value,
    format: form.format.value,
    cameras: form.cameras.value,
    width: width!,
    height: height!,
    rate: Number(form.rate.value),
    include_failed: form.withFailures.value,
    drop_constant: form.withoutConstant.value,
  };
}

function Fields({ form, isSet }: { form: Form; isSet: boolean }) {
  const { cameras } = form;
  const same = (value: string) => ({ value, label: value });
  const toggle = (camera: string) =>
    (cameras.value = cameras.value.includes(camera)
      ? cameras.value.filter((one) => one !== camera)
      : [...cameras.value, camera]);
  return (
    <>
      <NameField label={words.name} name={form.name} />
      <Choice
        label={words.format}
        chosen={form.format}
        of={(choices.value?.formats ?? []).map((format) => ({ value: format, label: words.formatOf(format) }))}
      />
      <div class="field">
        <span class="field-label">{words.cameras}</span>
        <Chips
          label={words.cameras}
          choices={(choices.value?.cameras ?? []).map((camera) => same(camera))}
          chosen={cameras.value}
          onToggle={toggle}
        />
      </div>
      <div class="numbers">
        <Choice label={words.size} chosen={form.size} of={SIZES.map((size) => ({ value: size, label: size.replace("x", " × ") }))} />
        <Choice label={words.rate} chosen={form.rate} of={(choices.value?.rates ?? []).map((rate) => same(`${rate}`))} />
      </div>
      {isSet && (
        <Switch
          label={words.withFailures}
          isOn={form.withFailures.value}
          onChange={(isOn) => (form.withFailures.value = isOn)}
        />
      )}
      <Switch
        label={words.withoutConstant}
        isOn={form.withoutConstant.value}
        onChange={(isOn) => (form.withoutConstant.value = isOn)}
      />
    </>
  );
}

/** Makes a dataset of a recording or a generated set, and checks it. */
export function ExportDialog({ source }: { source: Source }) {
  const form = useForm(source);
  const place = (name: string) => words.place(choices.value?.folder ?? "", name);
  return (
    <JobDialog
      title={words.title(titleOfSource(source))}
      start={{ label: words.export, allowed: may("export"), begin: () => request("export", wantedOf(source, form)) }}
      hint={(job) => (isOpen(job) ? words.staysWhenClosed : place(job.name))}
      onClose={() => (exported.value = null)}
    >
      <Fields form={form} isSet={"set" in source} />
      <p class="hint">{place(form.name.value)}</p>
    </JobDialog>
  );
}
