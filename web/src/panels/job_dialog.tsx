import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import { may, when } from "../allowed";
import type { Allowed, Job } from "../protocol";
import { jobs } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Dialog } from "../ui/dialog";
import { dismiss, isOpen, stopJob } from "./datasets";
import { JobProgress } from "./job_progress";

const { datasets: words } = texts;

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

/** Starts a job; shows why not, and how far it is. */
function useJob() {
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

function StopButton({ job }: { job: Job }) {
  return (
    <Button
      label={words.stop}
      icon="stop"
      kind="danger"
      {...when(job.status === "stopping" ? words.stopping : may("stop_job"), words.stopWhy(job))}
      onClick={() => stopJob(job)}
    />
  );
}

/** The dialog of a job: first what it is to do, which the children ask; then how far it is. */
export function JobDialog(props: {
  title: string;
  /** The button that starts it. */
  start: { label: string; allowed: Allowed; begin: () => Promise<{ job: number }> };
  /** A sentence below its progress; null: none. */
  hint: (job: Job) => string | null;
  onClose: () => void;
  children: ComponentChildren;
}) {
  const { job, error, isBusy, start } = useJob();
  const { label, allowed, begin } = props.start;
  const hint = job === undefined ? null : props.hint(job);
  const actions =
    job === undefined ? (
      <>
        <Button label={texts.cancel} onClick={props.onClose} />
        <Button label={label} kind="accent" {...when(allowed)} isBusy={isBusy.value} onClick={() => void start(begin())} />
      </>
    ) : (
      <>
        {isOpen(job) && <StopButton job={job} />}
        <Button label={isOpen(job) ? words.inBackground : texts.close} kind="accent" onClick={props.onClose} />
      </>
    );
  return (
    <Dialog title={props.title} onClose={props.onClose} actions={actions}>
      {job === undefined ? props.children : <JobProgress job={job} />}
      {hint !== null && <p class="hint">{hint}</p>}
      {job === undefined && error.value !== null && (
        <p class="said trouble" role="alert">
          {error.value}
        </p>
      )}
    </Dialog>
  );
}
