import { useState } from "preact/hooks";

/** A number to be typed: taken with Enter or when the field is left, forgotten with Escape. */
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
    const value = Number(draft.replace(",", "."));
    if (draft.trim() === "" || !Number.isFinite(value)) return;
    props.onCommit(Math.min(props.max ?? Infinity, Math.max(props.min ?? -Infinity, value)));
  };
  return (
    <label class="number-field">
      {props.isLabelled && <span aria-hidden="true">{props.label}</span>}
      <input
        type="number"
        inputMode="decimal"
        aria-label={props.unit ? `${props.label} (${props.unit})` : props.label}
        step={props.step ?? "any"}
        min={props.min}
        max={props.max}
        disabled={props.disabled}
        value={draft ?? withoutMinusZero(props.value.toFixed(digits))}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === "Enter") commit();
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

/** Rounding turns -0.001 into "-0.00": this removes the minus. */
function withoutMinusZero(text: string): string {
  return Number(text) === 0 ? text.replace("-", "") : text;
}
