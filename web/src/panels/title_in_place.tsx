import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { may } from "../allowed";
import { texts } from "../texts";
import { MAX_TITLE_LENGTH, renameRecording, titleOf } from "./recordings";

const { library: words } = texts;

/** The title of a recording, changed where it stands: kept with Enter or when the field is left, taken back with Escape. */
export function TitleInPlace({ id, isFixed = false }: { id: string; isFixed?: boolean }) {
  const title = titleOf(id);
  const [draft, setDraft] = useState<string | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  const field = useRef<HTMLInputElement>(null);
  const returnsFocus = useRef(false);
  // A field that is removed is left, too: then it has been kept or taken back already.
  const isOpen = useRef(false);
  const isTyped = draft !== null;
  useLayoutEffect(() => {
    if (isTyped) field.current?.select();
    else if (returnsFocus.current) button.current?.focus();
    returnsFocus.current = false;
  }, [isTyped]);
  if (isFixed || may("rename") !== true) return <span title={title}>{title}</span>;
  const begin = () => {
    isOpen.current = true;
    setDraft(title);
  };
  const end = (byKey: boolean) => {
    isOpen.current = false;
    returnsFocus.current = byKey;
    setDraft(null);
  };
  // What is refused stays in the field.
  const keep = async (byKey: boolean) => {
    if (!isOpen.current || draft === null) return;
    if (draft === title || (await renameRecording(id, { title: draft }))) end(byKey);
  };
  if (!isTyped) {
    return (
      <button type="button" class="title-in-place" ref={button} title={words.typeTitle(title)} onClick={begin}>
        {title}
      </button>
    );
  }
  return (
    <input
      type="text"
      class="title-in-place"
      ref={field}
      aria-label={words.name}
      value={draft}
      maxLength={MAX_TITLE_LENGTH}
      onInput={(event) => setDraft(event.currentTarget.value)}
      onBlur={() => void keep(false)}
      onKeyDown={(event) => {
        if (event.key === "Enter") void keep(true);
        if (event.key === "Escape") end(true);
      }}
    />
  );
}
