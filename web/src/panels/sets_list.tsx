import { useEffect } from "preact/hooks";
import { may } from "../allowed";
import type { Allowed, GeneratedSet, Job } from "../protocol";
import { ask, isConnected, jobs, notify, state } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { isFound, Picture } from "../ui/card";
import { Icon } from "../ui/icons";
import { MenuButton, type MenuEntry } from "../ui/menu";
import { dismiss, dismissed, isOpen, jobOfSet, refreshJobs, refreshSets, sets, stopJob } from "./datasets";
import { JobProgress } from "./job_progress";
import { exported, openedSet, renamedSet } from "./page";
import { eyePictureOf } from "./recordings";

const { datasets: words } = texts;

function JobCard({ job }: { job: Job }) {
  return (
    <li class="job">
      <div class="row">
        <strong class="grow" title={job.name}>
          {words.jobTitle(job)}
        </strong>
        {isOpen(job) ? (
          <Button
            label={words.stopNamed(job.name)}
            icon="stop"
            kind="quiet"
            isIconOnly
            disabled={job.status === "stopping" || may("stop_job") !== true}
            onClick={() => stopJob(job)}
          />
        ) : (
          <Button
            label={words.dismissNamed(job.name)}
            icon="cross"
            kind="quiet"
            isIconOnly
            onClick={() => dismiss(job)}
          />
        )}
      </div>
      <JobProgress job={job} />
    </li>
  );
}

/** The jobs whose end has not been seen, the newest first. */
export function JobList() {
  useEffect(() => {
    if (isConnected.value) void refreshJobs();
  }, [isConnected.value]);
  const shown = jobs.value.filter(({ job }) => !dismissed.value.includes(job)).reverse();
  if (shown.length === 0) return null;
  return (
    <ul class="jobs" aria-label={words.work}>
      {shown.map((job) => (
        <JobCard key={job.job} job={job} />
      ))}
    </ul>
  );
}

const unless = (allowed: Allowed) => (allowed === true ? {} : { disabled: true, reason: allowed });

function entriesOf(set: GeneratedSet): MenuEntry[] {
  const { name } = set;
  const allowed = set.is_complete
    ? words.isComplete
    : !set.can_continue
      ? words.madeElsewhere
      : jobOfSet(name) !== undefined
        ? words.isBeingMade
        : may("continue_set");
  return [
    {
      label: words.continue,
      icon: "play",
      ...unless(allowed),
      onChoose: () => void ask("continue_set", { set: name }),
    },
    {
      label: texts.exporting.entry,
      icon: "film",
      ...unless(may("export")),
      onChoose: () => (exported.value = { set: name }),
    },
    {
      label: words.rename,
      icon: "pencil",
      ...unless(jobOfSet(name) !== undefined ? words.isBeingMade : may("rename_set")),
      onChoose: () => (renamedSet.value = name),
    },
    {
      label: texts.library.toBin,
      icon: "trash",
      isDanger: true,
      ...unless(jobOfSet(name) !== undefined ? words.isBeingMade : may("bin_set")),
      onChoose: () => void bin(name),
    },
  ];
}

async function bin(name: string): Promise<void> {
  const shown = state.value?.playback?.recording ?? "";
  if (shown.startsWith(`${name}:`) && (await ask("live")) === null) return;
  if ((await ask("bin_set", { set: name })) === null) return;
  notify(texts.library.binned(name));
  await refreshSets();
}

async function takeBack(name: string): Promise<void> {
  const reply = await ask("unbin_set", { set: name });
  if (reply === null) return;
  notify(texts.library.isBack(reply.set));
  await refreshSets();
}

function SetCard({ set }: { set: GeneratedSet }) {
  const { name, picture } = set;
  return (
    <li class="recording">
      {picture === null ? (
        <span class="picture">
          <Icon name="robot" size={28} />
        </span>
      ) : (
        <Picture source={eyePictureOf(picture)} alt={words.pictureOf(name)} />
      )}
      <div class="recording-words">
        <strong title={name}>{name}</strong>
        <small>{words.episodes(set.episodes, set.wanted)}</small>
        <small>{words.yield(set.attempts, set.yield, null)}</small>
        <small>{[set.scene, set.level, set.brain].filter((text) => text).join(" · ")}</small>
        <div class="row tight">
          {set.binned ? (
            <Button
              label={texts.library.takeBack}
              disabled={may("unbin_set") !== true}
              onClick={() => void takeBack(name)}
            />
          ) : (
            <>
              <Button label={words.open} title={words.openWhy} onClick={() => (openedSet.value = name)} />
              <MenuButton label={texts.library.actions(name)} entries={entriesOf(set)} />
            </>
          )}
        </div>
      </div>
    </li>
  );
}

/** The generated sets, in the bin or outside, that a search finds. */
export function SetsList({ search, isBin }: { search: string; isBin: boolean }) {
  useEffect(() => {
    if (isConnected.value) void refreshSets();
  }, [isConnected.value]);
  const found = (sets.value ?? []).filter(
    ({ name, scene, level, brain, binned }) =>
      binned === isBin && isFound(search, name, scene ?? "", level ?? "", brain ?? ""),
  );
  if (found.length === 0) return null;
  return (
    <section aria-label={words.sets}>
      <h3 class="sets-title">{words.sets}</h3>
      <ul class="recordings">
        {found.map((set) => (
          <SetCard key={set.name} set={set} />
        ))}
      </ul>
    </section>
  );
}
