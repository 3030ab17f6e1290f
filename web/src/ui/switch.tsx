import type { LabelHTMLAttributes } from "preact";

interface SwitchProps {
  label: string;
  isOn: boolean;
  disabled?: boolean;
  onChange: (isOn: boolean) => void;
  /** Attributes of the whole, such as the hint of a key. */
  more?: LabelHTMLAttributes<HTMLLabelElement>;
}

export function Switch({ label, isOn, disabled = false, onChange, more = {} }: SwitchProps) {
  return (
    <label class="switch" {...more}>
      <input
        type="checkbox"
        role="switch"
        checked={isOn}
        disabled={disabled}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
      <span>{label}</span>
    </label>
  );
}
