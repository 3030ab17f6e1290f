import { useEffect } from "preact/hooks";
import { computed, signal, type Signal } from "@preact/signals";
import { ask, isConnected } from "../studio";
import type { Requests } from "../protocol";
import { texts } from "../texts";

type Program = Requests["brains"]["answer"]["brains"][number];

/** The programs that may be started; null until they are known. */
export const brains = signal<Program[] | null>(null);
export const imitators = computed(() => (brains.value ?? []).filter(({ imitates }) => imitates));
export const chosenBrain = signal("");
export const chosenImitator = signal("");

/** What is chosen of the programs, or the first of them. */
function chosenOf(programs: Program[], chosen: string): string {
  return programs.some(({ name }) => name === chosen) ? chosen : (programs[0]?.name ?? "");
}

export function useBrains(): void {
  useEffect(() => {
    if (!isConnected.value) return;
    void ask("brains").then((reply) => {
      if (reply === null) return;
      brains.value = reply.brains;
      chosenBrain.value = chosenOf(brains.value, chosenBrain.value);
      chosenImitator.value = chosenOf(imitators.value, chosenImitator.value);
    });
  }, [isConnected.value]);
}

/** A list of programs to choose from; while one is running, which one. */
export function ProgramChoice(props: { label: string; programs: Program[]; chosen: Signal<string>; running?: string | null }) {
  const running = props.programs.find(({ name }) => name === props.running)?.name;
  return (
    <select
      aria-label={props.label}
      value={running ?? props.chosen.value}
      disabled={running !== undefined}
      onChange={(event) => (props.chosen.value = event.currentTarget.value)}
    >
      {props.programs.map(({ name, kind }) => (
        <option key={name} value={name}>
          {texts.brain.program(name, kind)}
        </option>
      ))}
    </select>
  );
}
