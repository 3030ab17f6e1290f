import { computed, type ReadonlySignal } from "@preact/signals";

/** A value computed from the state twenty times a second that notifies its readers only when it changes. */
export function settled<T>(read: () => T): ReadonlySignal<T> {
  let last: { text: string; value: T } | null = null;
  return computed(() => {
    const value = read();
    const text = JSON.stringify(value) ?? "";
    if (last?.text !== text) last = { text, value };
    return last.value;
  });
}
