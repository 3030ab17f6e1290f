import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { Icon, type IconName } from "./icons";

export interface ButtonProps {
  label: string;
  onClick: () => void;
  icon?: IconName;
  kind?: "plain" | "accent" | "danger" | "quiet";
  /** Shows the icon only; the label is its tooltip and its accessible name. */
  isIconOnly?: boolean;
  /** The key that does the same; shown in small, in the tooltip, and announced. */
  keys?: string | undefined;
  /** The key stands in the tooltip only. */
  isKeyHidden?: boolean;
  title?: string | undefined;
  disabled?: boolean;
  /** A button that stays down. */
  isPressed?: boolean;
  isBusy?: boolean;
  class?: string;
  tour?: string;
  children?: ComponentChildren;
}

export function Button(props: ButtonProps) {
  const hint = props.title ?? (props.isIconOnly || props.keys ? props.label : undefined);
  const title = hint !== undefined && props.keys ? `${hint} (${props.keys})` : hint;
  return (
    <button
      type="button"
      class={`button ${props.kind ?? "plain"} ${props.isIconOnly ? "icon-only" : ""} ${props.class ?? ""}`}
      aria-label={props.isIconOnly ? props.label : undefined}
      aria-pressed={props.isPressed}
      aria-busy={props.isBusy}
      aria-keyshortcuts={props.keys}
      title={title}
      disabled={props.disabled || props.isBusy}
      data-tour={props.tour}
      onClick={props.onClick}
    >
      {props.isBusy ? <span class="spinner" /> : props.icon && <Icon name={props.icon} />}
      {!props.isIconOnly && <span class="button-label">{props.label}</span>}
      {props.keys && !props.isIconOnly && !props.isKeyHidden && <kbd aria-hidden="true">{props.keys}</kbd>}
      {props.children}
    </button>
  );
}

/** Acts while it is held down, by mouse, finger or key; `onRelease` comes always. */
export function HoldButton(props: {
  label: string;
  icon: IconName;
  disabled?: boolean;
  onPress: () => void;
  onRelease: () => void;
}) {
  const isHeld = useRef(false);
  const onRelease = useRef(props.onRelease);
  onRelease.current = props.onRelease;
  const press = () => {
    if (isHeld.current) return;
    isHeld.current = true;
    props.onPress();
  };
  const release = () => {
    if (!isHeld.current) return;
    isHeld.current = false;
    onRelease.current();
  };
  useEffect(() => release, []);
  const isPressingKey = (event: KeyboardEvent) => event.key === " " || event.key === "Enter";
  return (
    <button
      type="button"
      class="button plain icon-only hold"
      aria-label={props.label}
      title={props.label}
      disabled={props.disabled}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        press();
      }}
      onPointerUp={release}
      onPointerCancel={release}
      onLostPointerCapture={release}
      onKeyDown={(event) => isPressingKey(event) && (event.preventDefault(), press())}
      onKeyUp={(event) => isPressingKey(event) && release()}
      onBlur={release}
      onContextMenu={(event) => event.preventDefault()}
    >
      <Icon name={props.icon} />
    </button>
  );
}

/** Some of several, each on or off. */
export function Chips<T extends string>(props: {
  label: string;
  choices: readonly { value: T; label: string; title?: string }[];
  chosen: readonly string[];
  disabled?: boolean;
  onToggle: (value: T) => void;
}) {
  return (
    <div class="chips" role="group" aria-label={props.label}>
      {props.choices.map(({ value, label, title }) => (
        <button
          key={value}
          type="button"
          class="chip"
          title={title}
          aria-pressed={props.chosen.includes(value)}
          disabled={props.disabled}
          onClick={() => props.onToggle(value)}
        >
          {label}
        </button>
      ))}
    </div>
  );
}
