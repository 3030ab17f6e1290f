import { useLayoutEffect, useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { Button } from "./buttons";
import { Icon, type IconName } from "./icons";

export interface MenuEntry {
  label: string;
  icon?: IconName;
  disabled?: boolean;
  /** Why it is disabled. */
  reason?: string;
  isDanger?: boolean;
  onChoose: () => void;
}

const MARGIN = 8;

/** A list of things to do at a place of the window; arrow keys, Enter, Escape. */
export function Menu(props: { label: string; x: number; y: number; entries: MenuEntry[]; onClose: () => void }) {
  const list = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const menu = list.current!;
    const before = document.activeElement;
    // Above sheets and dialogs, whatever it was opened from.
    menu.showPopover();
    menu.style.left = `${Math.max(MARGIN, Math.min(props.x, innerWidth - menu.offsetWidth - MARGIN))}px`;
    menu.style.top = `${Math.max(MARGIN, Math.min(props.y, innerHeight - menu.offsetHeight - MARGIN))}px`;
    menu.querySelector<HTMLElement>("[role=menuitem]")?.focus();
    const closeOutside = (event: Event) => {
      if (event.target instanceof Node && !menu.contains(event.target)) props.onClose();
    };
    document.addEventListener("pointerdown", closeOutside, true);
    return () => {
      document.removeEventListener("pointerdown", closeOutside, true);
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  const go = (event: KeyboardEvent) => {
    const items = [...list.current!.querySelectorAll<HTMLElement>("[role=menuitem]")];
    const at = items.findIndex((item) => item === document.activeElement);
    const last = items.length - 1;
    const places: Record<string, number> = {
      ArrowDown: at === last ? 0 : at + 1,
      ArrowUp: at <= 0 ? last : at - 1,
      Home: 0,
      End: last,
    };
    if (event.key === "Escape" || event.key === "Tab") props.onClose();
    const next = places[event.key];
    if (next !== undefined) items[next]?.focus();
    if (next !== undefined || event.key === "Escape") event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div class="menu" role="menu" popover="manual" aria-label={props.label} ref={list} onKeyDown={go}>
      {props.entries.map((entry) => (
        <button
          key={entry.label}
          type="button"
          role="menuitem"
          class={entry.isDanger ? "danger" : ""}
          aria-disabled={entry.disabled}
          tabIndex={-1}
          onClick={() => {
            if (entry.disabled) return;
            props.onClose();
            entry.onChoose();
          }}
        >
          {entry.icon && <Icon name={entry.icon} size={18} />}
          <span>
            {entry.label}
            {entry.disabled && entry.reason && <small>{entry.reason}</small>}
          </span>
        </button>
      ))}
    </div>
  );
}

/** A button with three dots whose menu has what is done less often; or in words, with a choice of how it is done. */
export function MenuButton(props: { label: string; entries: MenuEntry[]; isInWords?: boolean }) {
  const at = useSignal<{ x: number; y: number } | null>(null);
  const holder = useRef<HTMLSpanElement>(null);
  const open = () => {
    const box = holder.current!.getBoundingClientRect();
    at.value = { x: box.left, y: box.bottom + 4 };
  };
  return (
    <span ref={holder} class="menu-button">
      {props.isInWords ? (
        <Button label={props.label} kind="accent" onClick={open} />
      ) : (
        <Button label={props.label} icon="more" kind="quiet" isIconOnly onClick={open} />
      )}
      {at.value && <Menu label={props.label} {...at.value} entries={props.entries} onClose={() => (at.value = null)} />}
    </span>
  );
}
