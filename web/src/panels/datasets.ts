// Generated sets, datasets, and the jobs that make them.

import { effect, signal } from "@preact/signals";
import type { Job, Requests, GeneratedSet } from "../protocol";
import { ask, isConnected, jobs, notify, numLibraryUpdates, request } from "../studio";
import { texts } from "../texts";

const { datasets: words } = texts;

/** Newest first; null until they are known. */
export const sets = signal<GeneratedSet[] | null>(null);
/** What jobs may be given; null until it is known. */
export const choices = signal<Requests["jobs"]["answer"] | null>(null);
/** Jobs whose end has been seen. */
export const dismissed = signal<number[]>([]);

export async function refreshSets(): Promise<void> {
  const reply = await request("sets").catch(() => null);
  if (reply !== null) sets.value = reply.sets;
}

export async function refreshJobs(): Promise<void> {
  const reply = await ask("jobs");
  if (reply === null) return;
  choices.value = reply;
  jobs.value = reply.jobs;
}

export function isOpen({ status }: Job): boolean {
  return status === "waiting" || status === "running" || status === "stopping";
}

/** The job that makes a set now. */
export function jobOfSet(name: string): Job | undefined {
  return jobs.value.find((job) => job.do === "generate" && job.name === name && isOpen(job));
}

/** Where a film is on the server. */
export function filmOf(name: string): string {
  return `/films/${encodeURIComponent(name)}.mp4`;
}

export function dismiss(job: Job): void {
  dismissed.value = [...dismissed.value, job.job];
}

export function stopJob(job: Job): void {
  void ask("stop_job", { job: job.job });
}

/** A name like this title that no other has. */
export function freeName(title: string, taken: string[]): string {
  const name = title.replace(/[^A-Za-z0-9 ._-]+/g, "_").replace(/^[. ]+/, "").slice(0, 80) || "set";
  let free = name;
  for (let number = 2; taken.includes(free); ++number) free = `${name}-${number}`;
  return free;
}

/** Sets may be made and deleted by others. */
numLibraryUpdates.subscribe((number) => {
  if (number > 0 && sets.peek() !== null) void refreshSets();
});

/** Announces the ends of jobs, whatever is open; then the sets have changed. */
let before = new Map<number, Job>();
effect(() => {
  const now = jobs.value;
  let isAnyNew = false;
  for (const job of now) {
    const last = before.get(job.job);
    if (last !== undefined && isOpen(last) && !isOpen(job)) notify(words.ended(job), job.status === "failed");
    if (job.status !== last?.status) isAnyNew = true;
  }
  before = new Map(now.map((job) => [job.job, job]));
  if (isAnyNew && isConnected.peek()) void refreshSets();
});
