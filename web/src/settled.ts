import { computed, type ReadonlySignal } from "@preact/signals";

/** What is computed of the state twenty times a second, but tells its readers only when it is another. */
export function settled<T>(read: () => T): ReadonlySignal<T> {
  let last: { text: string; value: T } | null = null;
  return computed(() => {
    const value = read();
    const text = JSON.stringify(value) ?? "";
    if (last?.text !== text) last = { text, value };
    return last.value;
  });
}
