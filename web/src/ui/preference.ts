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

/** What this browser's user likes or has begun; kept from visit to visit where the browser allows it. */
export function preference<T>(name: string, otherwise: T, isValid: (value: unknown) => value is T): Signal<T> {
  const liked = signal(stored(name, otherwise, isValid));
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
