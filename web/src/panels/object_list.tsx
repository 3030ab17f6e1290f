import { useEffect, useRef } from "preact/hooks";
import { isCommandOffered, may, when } from "../allowed";
import { command, currentHand, heldObject, notify } from "../studio";
import { handColors } from "../colors";
import type { SceneObject } from "../protocol";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Empty } from "../ui/card";
import { select, selected, toggleSelected } from "../world/selection";
import { holders, objectsHere } from "./derived_signals";
import { takenInList } from "./hands_panel";
import { chosenObject, showPanel, world } from "./page";
import { useAllowed } from "./use_allowed";

const { objects: words } = texts;

async function take(object: string): Promise<void> {
  takenInList.value = object;
  const reply = await command({ do: "grasp", hand: currentHand.value, object });
  if (reply === null) {
    takenInList.value = null;
    return;
  }
  if (reply.deed) notify(texts.action(reply.deed));
  showPanel("hands");
}

/** Clicks and keys of the list: they choose one object, with Shift a range, with Ctrl one more; Ctrl+A all. */
function useSelecting(ids: string[], chosen: string | null, show: (place: number) => void) {
  const selectRange = (from: number, to: number) => {
    const [first, last] = [Math.min(from, to), Math.max(from, to)];
    select([...selected.value, ...ids.slice(Math.max(0, first), last + 1)]);
  };
  const click = (event: MouseEvent, id: string) => {
    if (!isCommandOffered("displace")) {
      select([]);
    } else if (event.shiftKey) {
      selectRange(chosen === null ? 0 : ids.indexOf(chosen), ids.indexOf(id));
    } else if (event.ctrlKey || event.metaKey) {
      if (selected.value.length === 0 && chosen !== null && chosen !== id) select([chosen]);
      toggleSelected(id);
    } else {
      select([]);
    }
    chosenObject.value = id;
  };
  const go = (event: KeyboardEvent) => {
    const at = chosen === null ? -1 : ids.indexOf(chosen);
    const places: Record<string, number> = {
      ArrowDown: Math.min(at + 1, ids.length - 1),
      ArrowUp: Math.max(at - 1, 0),
      Home: 0,
      End: ids.length - 1,
    };
    const place = places[event.key];
    const isAll = event.ctrlKey && event.key === "a" && isCommandOffered("displace");
    if (place === undefined && event.key !== "Enter" && !isAll) return;
    event.preventDefault();
    event.stopPropagation();
    if (isAll) {
      select(ids);
    } else if (place === undefined) {
      if (chosen !== null && may("command") === true) void take(chosen);
    } else {
      if (event.shiftKey && isCommandOffered("displace")) selectRange(at, place);
      else select([]);
      chosenObject.value = ids[place] ?? null;
      show(place);
    }
  };
  const isSelected = (id: string) => (selected.value.length > 0 ? selected.value.includes(id) : id === chosen);
  return { click, go, isSelected };
}

/** A listbox: arrow keys choose, Enter takes. */
export function ObjectList() {
  const list = useRef<HTMLDivElement>(null);
  const ids = objectsHere.value.map((object) => object.id);
  const chosen = chosenObject.value !== null && ids.includes(chosenObject.value) ? chosenObject.value : (ids[0] ?? null);
  const held = heldObject.value;
  useEffect(() => {
    if (held !== null) chosenObject.value = held;
  }, [held]);
  const [mayTake] = useAllowed([
    { do: "command", command: { do: "grasp", hand: currentHand.value, object: chosen ?? "" } },
  ]);
  const { click, go, isSelected } = useSelecting(ids, chosen, (place) =>
    list.current?.children[place]?.scrollIntoView({ block: "nearest" }),
  );
  if (ids.length === 0) return <Empty icon="block" text={words.none} />;
  return (
    <>
      <div
        class="object-list"
        role="listbox"
        tabIndex={0}
        aria-label={words.list}
        aria-multiselectable="true"
        aria-activedescendant={chosen === null ? undefined : `object-${ids.indexOf(chosen)}`}
        ref={list}
        data-tour="objects"
        onKeyDown={go}
      >
        {objectsHere.value.map((object, k) => (
          <div
            key={object.id}
            id={`object-${k}`}
            role="option"
            aria-selected={isSelected(object.id)}
            onClick={(event) => click(event, object.id)}
            onDblClick={() => may("command") === true && void take(object.id)}
          >
            <span class="object-id">{object.id}</span>
            <ObjectNote object={object} />
          </div>
        ))}
      </div>
      <div class="row">
        <Button
          label={words.take}
          icon="hand"
          class="grow"
          {...when(chosen === null ? words.none : mayTake)}
          onClick={() => chosen !== null && void take(chosen)}
        />
        <Button
          label={words.focus}
          icon="eye"
          class="grow"
          disabled={chosen === null}
          onClick={() => chosen !== null && world.value?.focus(chosen)}
        />
      </div>
    </>
  );
}

function ObjectNote({ object }: { object: SceneObject }) {
  const hand = holders.value[object.id];
  if (hand === undefined) {
    return <span class="object-note">{object.fixed ? words.isFixed : words.kindOf(object.shape)}</span>;
  }
  return (
    <span class="object-note held" style={{ "--hand": handColors[hand] }}>
      <span class="swatch" />
      {words.heldBy(hand)}
    </span>
  );
}
