import { useEffect, useState } from "preact/hooks";

const TICK_MS = 250;

/** Counts down from a number of seconds; whole seconds, never below 0. */
export function useSecondsLeft(seconds: number): number {
  const [end] = useState(() => performance.now() + 1000 * seconds);
  return useSecondsUntil(end);
}

/** @param end by performance.now() [ms] */
export function useSecondsUntil(end: number): number {
  const read = () => Math.max(0, Math.ceil((end - performance.now()) / 1000));
  const [left, setLeft] = useState(read);
  useEffect(() => {
    setLeft(read());
    const timer = setInterval(() => setLeft(read()), TICK_MS);
    return () => clearInterval(timer);
  }, [end]);
  return left;
}
