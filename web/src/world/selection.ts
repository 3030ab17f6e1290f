import { computed, signal } from "@preact/signals";
import type { Point } from "../protocol";
import { command, scene, state } from "../studio";

/** The objects that were chosen together, in this order; some may be gone meanwhile. */
const chosen = signal<string[]>([]);
/** The ids of copied objects. */
export const copied = signal<string[]>([]);

/** The objects that are moved and copied together. */
export const selected = computed(() => {
  const gone = new Set(state.value?.gone ?? []);
  const here = new Set((scene.value?.objects ?? []).map(({ id }) => id).filter((id) => !gone.has(id)));
  return chosen.value.filter((id) => here.has(id));
});

export function select(objects: string[]): void {
  chosen.value = [...new Set(objects)];
}

/** Adds an object to those that are selected, or takes it out. */
export function toggleSelected(object: string): void {
  const before = selected.value;
  select(before.includes(object) ? before.filter((id) => id !== object) : [...before, object]);
}

/** Moves the selected objects together [units]. */
export function moveSelected(by: Point): void {
  if (selected.value.length === 0 || by.every((value) => value === 0)) return;
  void command({ do: "displace", objects: selected.value, by });
}

export function copySelected(): void {
  if (selected.value.length > 0) copied.value = selected.value;
}

/** Adds copies beside the copied objects; they are selected then. */
export async function paste(): Promise<void> {
  if (copied.value.length === 0) return;
  const reply = await command({ do: "duplicate", objects: copied.value });
  if (reply?.objects) select(reply.objects);
}
