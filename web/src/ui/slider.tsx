import { useRef, useState } from "preact/hooks";
import { NumberField } from "./number_field";

/** Time for which a slider shows what its user wanted before it shows the actual value again. */
const SETTLE_MS = 400;

export interface SliderProps {
  label: string;
  /** The visible part of the label, if a title contains the rest. */
  shortLabel?: string;
  value: number;
  min: number;
  max: number;
  step: number;
  digits?: number;
  unit?: string;
  color?: string;
  disabled?: boolean;
  /** While it is moved, and at its end. */
  onInput: (value: number) => void;
}

/** A slider and its number. It never fights the hand that moves it: while it is moved it shows what is wanted. */
export function Slider(props: SliderProps) {
  const [wanted, setWanted] = useState<number | null>(null);
  const timer = useRef(0);
  const want = (value: number) => {
    setWanted(value);
    clearTimeout(timer.current);
    timer.current = window.setTimeout(() => setWanted(null), SETTLE_MS);
    props.onInput(value);
  };
  const shown = Math.min(props.max, Math.max(props.min, wanted ?? props.value));
  const share = (value: number) => (100 * (value - props.min)) / Math.max(props.max - props.min, 1e-9);
  // Filled from zero, where there is one.
  const zero = share(Math.min(props.max, Math.max(props.min, 0)));
  const filled = share(shown);
  const style = {
    "--from": `${Math.min(zero, filled)}%`,
    "--filled": `${Math.max(zero, filled)}%`,
    ...(props.color ? { "--track": props.color } : {}),
  };
  return (
    <div class="slider" style={style}>
      <span class="slider-label" aria-hidden="true">
        {props.shortLabel ?? props.label}
      </span>
      <input
        type="range"
        aria-label={props.unit ? `${props.label} (${props.unit})` : props.label}
        min={props.min}
        max={props.max}
        step={props.step}
        value={shown}
        disabled={props.disabled}
        onInput={(event) => want(event.currentTarget.valueAsNumber)}
      />
      <NumberField
        label={props.label}
        value={wanted ?? props.value}
        digits={props.digits ?? 0}
        min={props.min}
        max={props.max}
        step={props.step}
        unit={props.unit ?? ""}
        disabled={props.disabled ?? false}
        onCommit={want}
      />
    </div>
  );
}
