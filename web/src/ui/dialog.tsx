import type { ComponentChildren } from "preact";
import { useEffect, useId, useRef } from "preact/hooks";
import { signal } from "@preact/signals";
import { texts } from "../texts";
import { Button } from "./buttons";
import { Notices } from "./notices";

/** The open ones, the uppermost last: what lies behind it can neither be used nor heard. */
export const openDialogs = signal<string[]>([]);

/** The browser's own dialog: it keeps the focus inside, closes with Escape and gives the focus back. */
export function Dialog(props: {
  title: string;
  onClose: () => void;
  class?: string;
  /** It is for reading: the keyboard scrolls it. */
  isForReading?: boolean;
  children: ComponentChildren;
  actions?: ComponentChildren;
}) {
  const element = useRef<HTMLDialogElement>(null);
  const titleId = useId();
  useEffect(() => {
    const before = document.activeElement;
    openDialogs.value = [...openDialogs.value, titleId];
    element.current?.showModal();
    element.current
      ?.querySelector<HTMLElement>(".dialog-body input, .dialog-body textarea, .dialog-actions button")
      ?.focus();
    return () => {
      openDialogs.value = openDialogs.value.filter((id) => id !== titleId);
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <dialog
      ref={element}
      class={`dialog ${props.class ?? ""}`}
      aria-labelledby={titleId}
      onCancel={(event) => {
        event.preventDefault();
        props.onClose();
      }}
      onKeyDown={(event) => event.stopPropagation()}
    >
      <header class="dialog-head">
        <h2 id={titleId}>{props.title}</h2>
        <Button label={texts.close} icon="cross" kind="quiet" isIconOnly onClick={props.onClose} />
      </header>
      <div class="dialog-body" tabIndex={props.isForReading ? 0 : undefined}>{props.children}</div>
      {openDialogs.value.at(-1) === titleId && <Notices />}
      {props.actions && <footer class="dialog-actions">{props.actions}</footer>}
    </dialog>
  );
}
