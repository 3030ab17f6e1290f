import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may } from "../allowed";
import { request } from "../studio";
import { texts } from "../texts";
import { choices, freeName, isOpen, refreshJobs } from "./datasets";
import { Choice, JobDialog, NameField } from "./job_dialog";
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
  const begin = () => {
    const [width, height] = form.size.value.split("x").map(Number) as [number, number];
    const { name, camera, rate } = form;
    return request("film", { recording, name: name.value, camera: camera.value, width, height, rate: Number(rate.value) });
  };
  const { cameras = [], rates = [], folder = "" } = choices.value ?? {};
  return (
    <JobDialog
      title={words.title(titleOf(recording))}
      start={{ label: words.film, allowed: may("film"), begin }}
      hint={(job) => (isOpen(job) ? words.staysWhenClosed : words.place(folder, job.name))}
      onClose={() => (filmed.value = null)}
    >
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
    </JobDialog>
  );
}
