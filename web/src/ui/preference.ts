import { effect, signal, type Signal } from "@preact/signals";

const PREFIX = "smile-studio.";

function stored<T>(name: string, otherwise: T, isValid: (value: unknown) => value is T): T {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(PREFIX + name) ?? "null");
    return isValid(value) ? value : otherwise;
  } catch {
    return otherwise;
  }
}

/** For each preference, how it returns to what a first visit shows. */
const returns = new WeakMap<object, () => void>();
const layout = new Set<() => void>();

/** What this browser's user likes or has begun; kept from visit to visit where the browser allows it. */
export function preference<T>(name: string, otherwise: T, isValid: (value: unknown) => value is T): Signal<T> {
  const liked = signal(stored(name, otherwise, isValid));
  returns.set(liked, () => (liked.value = otherwise));
  effect(() => {
    const text = JSON.stringify(liked.value);
    try {
      localStorage.setItem(PREFIX + name, text);
    } catch {
      // A browser that keeps nothing still shows the page.
    }
  });
  return liked;
}

export function switchPreference(name: string, otherwise: boolean): Signal<boolean> {
  return preference(name, otherwise, (value) => typeof value === "boolean");
}

export function numberPreference(name: string, otherwise: number, lower: number, upper: number): Signal<number> {
  return preference(
    name,
    otherwise,
    (value): value is number => typeof value === "number" && value >= lower && value <= upper,
  );
}

export function choicePreference<T extends string>(name: string, otherwise: T, choices: readonly T[]): Signal<T> {
  return preference(name, otherwise, (value): value is T => choices.some((choice) => choice === value));
}

/** A preference that is a part of the page's layout. */
export function inLayout<T>(liked: Signal<T>): Signal<T> {
  layout.add(returns.get(liked)!);
  return liked;
}

/** A part of the layout that is open or folded. */
export function layoutSwitch(name: string, otherwise: boolean): Signal<boolean> {
  return inLayout(switchPreference(name, otherwise));
}

/** The layout is that of a first visit again. */
export function resetLayout(): void {
  for (const toDefault of layout) toDefault();
}
