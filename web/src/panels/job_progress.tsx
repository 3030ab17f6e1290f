import type { Job } from "../protocol";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { downloadFile } from "../ui/download";
import { filmOf, isOpen } from "./datasets";

const { datasets: words } = texts;

/** Numbers of failures for each cause, the most frequent first. */
export function Causes({ causes }: { causes: Record<string, number> }) {
  const all = Object.entries(causes).sort(([, a], [, b]) => b - a);
  if (all.length === 0) return null;
  return (
    <ul class="causes" aria-label={words.causes}>
      {all.map(([word, number]) => (
        <li key={word}>{words.cause(number, word)}</li>
      ))}
    </ul>
  );
}

/** What a program said: several lines, as it wrote them. */
function Said({ text, isTrouble }: { text: string; isTrouble: boolean }) {
  return <p class={`said ${isTrouble ? "trouble" : ""}`}>{text}</p>;
}

/** How far a job is, and how it ended. */
export function JobProgress({ job }: { job: Job }) {
  const { done, total, attempts } = job;
  return (
    <div class="job-progress">
      <p role="status">
        {job.status === "running" && <span class="spinner" />} {words.status(job)}
      </p>
      {isOpen(job) && <progress aria-label={words.progressOf(job.name)} value={done} max={total} />}
      {attempts !== undefined && <p class="hint">{words.yield(attempts, job.yield ?? null, job.interval ?? null)}</p>}
      <Causes causes={job.causes ?? {}} />
      {job.status === "failed" && <Said text={job.words} isTrouble />}
      {job.status === "running" && job.do === "export" && <p class="hint said">{job.words}</p>}
      {job.do === "film" && job.status === "done" && (
        <div class="row">
          <Button label={texts.filming.download} icon="download" title={texts.filming.downloadOf(job.name)} onClick={() => downloadFile(filmOf(job.name))} />
        </div>
      )}
      {job.verdict && <Said text={job.verdict.lines.join("\n")} isTrouble={!job.verdict.ok} />}
    </div>
  );
}
