import { signal, type ReadonlySignal } from "@preact/signals";

function media(query: string): ReadonlySignal<boolean> {
  const list = matchMedia(query);
  const matches = signal(list.matches);
  list.addEventListener("change", () => (matches.value = list.matches));
  return matches;
}

/** Panels are sheets here; styles/small.css has the same width. */
export const isSmall = media("(max-width: 760px)");
/** People point with fingers. */
export const isTouch = media("(pointer: coarse)");
export const prefersDark = media("(prefers-color-scheme: dark)");
