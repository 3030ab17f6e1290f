import { useState } from "preact/hooks";
import { numberIn, typed } from "../message_format";

/**
 * A number to be typed, with a point or a comma: taken with Enter or when the field is left, forgotten with Escape. The arrow keys change it by a step.
 */
export function NumberField(props: {
  label: string;
  value: number;
  digits?: number;
  step?: number;
  min?: number;
  max?: number;
  unit?: string;
  disabled?: boolean;
  /** The label is seen, too. */
  isLabelled?: boolean;
  onCommit: (value: number) => void;
}) {
  const { digits = 2 } = props;
  const [draft, setDraft] = useState<string | null>(null);
  const commit = () => {
    if (draft === null) return;
    setDraft(null);
    const value = numberIn(draft);
    if (value !== null) props.onCommit(within(value));
  };
  const within = (value: number) => Math.min(props.max ?? Infinity, Math.max(props.min ?? -Infinity, value));
  const shown = draft ?? typed(props.value, digits);
  const changeBy = (steps: number) =>
    setDraft(typed(within((numberIn(shown) ?? props.value) + steps * (props.step ?? 1)), digits));
  return (
    <label class="number-field">
      {props.isLabelled && <span aria-hidden="true">{props.label}</span>}
      <input
        type="text"
        inputMode="decimal"
        role="spinbutton"
        aria-label={props.unit ? `${props.label} (${props.unit})` : props.label}
        aria-valuenow={numberIn(shown) ?? props.value}
        aria-valuetext={shown}
        aria-valuemin={props.min}
        aria-valuemax={props.max}
        autocomplete="off"
        disabled={props.disabled}
        value={shown}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === "Enter") commit();
          if (event.key === "ArrowUp" || event.key === "ArrowDown") {
            event.preventDefault();
            changeBy(event.key === "ArrowUp" ? 1 : -1);
          }
          if (event.key === "Escape" && draft !== null) {
            event.stopPropagation();
            setDraft(null);
          }
        }}
      />
      {props.unit && (
        <span class="unit" aria-hidden="true">
          {props.unit}
        </span>
      )}
    </label>
  );
}
