import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import type { Signal } from "@preact/signals";
import { texts } from "../texts";
import { Icon, type IconName } from "./icons";

/** A part of a panel with a title; collapsible if `isOpen` is given. */
export function Card(props: {
  title: string;
  isOpen?: Signal<boolean>;
  aside?: ComponentChildren;
  children: ComponentChildren;
}) {
  const bodyId = useId();
  const { isOpen } = props;
  const shown = isOpen?.value ?? true;
  return (
    <section class="card" aria-label={props.title}>
      <header class="card-head">
        <h3>
          {isOpen ? (
            <button type="button" aria-expanded={shown} aria-controls={bodyId} onClick={() => (isOpen.value = !shown)}>
              <Icon name={shown ? "down" : "right"} size={16} />
              {props.title}
            </button>
          ) : (
            props.title
          )}
        </h3>
        {props.aside}
      </header>
      <div class="card-body" id={bodyId} hidden={!shown}>
        {shown && props.children}
      </div>
    </section>
  );
}

/** Text in place of content that does not exist yet. */
export function Empty(props: { icon: IconName; text: string; children?: ComponentChildren }) {
  return (
    <div class="empty">
      <Icon name={props.icon} size={28} />
      <p>{props.text}</p>
      {props.children}
    </div>
  );
}

/** A picture that may not be there, or not yet. */
export function Picture({ source, alt }: { source: string; alt: string }) {
  return (
    <span class="picture">
      <Icon name="block" size={28} />
      <img
        key={source}
        src={source}
        alt={alt}
        loading="lazy"
        onError={(event) => (event.currentTarget.hidden = true)}
        onLoad={(event) => (event.currentTarget.hidden = false)}
      />
    </span>
  );
}

export function SearchField(props: { label: string; text: Signal<string> }) {
  return (
    <label class="search-field">
      <Icon name="search" size={18} />
      <input
        type="search"
        aria-label={props.label}
        placeholder={texts.search}
        value={props.text.value}
        onInput={(event) => (props.text.value = event.currentTarget.value)}
      />
    </label>
  );
}

/** True when all words of `search` are in one of the texts. */
export function isFound(search: string, ...fields: string[]): boolean {
  const text = fields.join(" ").toLowerCase();
  return wordsOf(search).every((word) => text.includes(word));
}

/** Puts first those in whose texts a word begins with each word of `search`. */
export function byWordsFound<T>(search: string, items: readonly T[], fieldsOf: (item: T) => string[]): T[] {
  const begins = (item: T) => {
    const words = fieldsOf(item).join(" ").toLowerCase().split(/[^\p{L}\p{N}]+/u);
    return wordsOf(search).every((word) => words.some((one) => one.startsWith(word)));
  };
  return [...items.filter(begins), ...items.filter((item) => !begins(item))];
}

function wordsOf(search: string): string[] {
  return search.toLowerCase().split(/\s+/);
}
