import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may, when } from "../allowed";
import { request } from "../studio";
import { texts } from "../texts";
import { Dialog } from "../ui/dialog";
import { choices, freeName, isOpen, refreshJobs } from "./datasets";
import { Choice, JobActions, NameField, useJob } from "./generate_dialog";
import { JobProgress } from "./job_progress";
import { filmed } from "./page";
import { titleOf } from "./recordings";

const { filming: words } = texts;

const SIZES = ["320x240", "640x480", "1280x720", "1920x1080"];

/** Makes a film of a recording, to be downloaded. */
export function FilmDialog({ recording }: { recording: string }) {
  const form = {
    name: useSignal(freeName(titleOf(recording), [])),
    camera: useSignal("nice"),
    size: useSignal("1280x720"),
    rate: useSignal("30"),
  };
  useEffect(() => void refreshJobs(), []);
  const { job, error, isBusy, start } = useJob();
  const close = () => (filmed.value = null);
  const film = () => {
    const [width, height] = form.size.value.split("x").map(Number) as [number, number];
    const { name, camera, rate } = form;
    return start(request("film", { recording, name: name.value, camera: camera.value, width, height, rate: Number(rate.value) }));
  };
  const { cameras = [], rates = [] } = choices.value ?? {};
  return (
    <Dialog
      title={words.title(titleOf(recording))}
      onClose={close}
      actions={
        <JobActions
          job={job}
          start={{ label: words.film, ...when(may("film")), isBusy: isBusy.value, onClick: () => void film() }}
          onClose={close}
        />
      }
    >
      {job === undefined ? (
        <>
          <NameField label={words.name} name={form.name} />
          <Choice
            label={words.camera}
            chosen={form.camera}
            of={cameras.map((value) => ({ value, label: words.cameraOf(value) }))}
          />
          <div class="numbers">
            <Choice
              label={texts.exporting.size}
              chosen={form.size}
              of={SIZES.map((value) => ({ value, label: value.replace("x", " × ") }))}
            />
            <Choice
              label={texts.exporting.rate}
              chosen={form.rate}
              of={rates.map((rate) => ({ value: `${rate}`, label: `${rate}` }))}
            />
          </div>
          {error.value !== null && (
            <p class="said trouble" role="alert">
              {error.value}
            </p>
          )}
        </>
      ) : (
        <>
          <JobProgress job={job} />
          <p class="hint">{isOpen(job) ? words.staysWhenClosed : words.place(choices.value?.folder ?? "", job.name)}</p>
        </>
      )}
    </Dialog>
  );
}
