import { useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { may } from "../allowed";
import type { Point } from "../protocol";
import { command } from "../studio";
import { texts } from "../texts";
import { Icon } from "../ui/icons";
import { world } from "./page";

const { objects: words } = texts;
/** Less is a click [px]. */
const LEAST_WAY = 6;

/** Where something is dragged, on the page [px], and the place in the world where it would be put. */
interface Carried {
  name: string;
  x: number;
  y: number;
  place: Point | null;
}

function useDragging(onDrop: (name: string, place: Point) => void) {
  const carried = useSignal<Carried | null>(null);
  const start = useRef<{ name: string; x: number; y: number } | null>(null);
  const end = () => {
    start.current = null;
    carried.value = null;
  };
  const handlersOf = (name: string) => ({
    onPointerDown: (event: PointerEvent & { currentTarget: HTMLElement }) => {
      if (event.button !== 0) return;
      event.currentTarget.setPointerCapture(event.pointerId);
      start.current = { name, x: event.clientX, y: event.clientY };
    },
    onPointerMove: ({ clientX: x, clientY: y }: PointerEvent) => {
      const from = start.current;
      if (from === null || (carried.value === null && Math.hypot(x - from.x, y - from.y) < LEAST_WAY)) return;
      carried.value = { name, x, y, place: world.value?.roomAt({ x, y }) ?? null };
    },
    onPointerUp: () => {
      const place = carried.value?.place;
      if (place) onDrop(name, place);
      end();
    },
    onPointerCancel: end,
    onKeyDown: (event: KeyboardEvent) => void (event.key === "Escape" && end()),
  });
  return { carried, handlersOf };
}

/** Ready-made objects: dragged to a place of the table, or chosen with a click. */
export function Palette(props: {
  presets: { name: string; title: string }[];
  chosen: string;
  seed: number;
  onChoose: (name: string) => void;
  onAdded: () => void;
}) {
  const drop = async (preset: string, place: Point) => {
    const rounded = place.map((value) => Math.round(value * 100) / 100) as Point;
    if ((await command({ do: "add", preset, seed: props.seed, place: rounded })) !== null) props.onAdded();
  };
  const { carried, handlersOf } = useDragging((name, place) => void drop(name, place));
  const now = carried.value;
  return (
    <>
      <ul class="palette" aria-label={words.palette}>
        {props.presets.map(({ name, title }) => (
          <li key={name}>
            <button
              type="button"
              class="chip"
              title={words.paletteWhy(title)}
              aria-pressed={name === props.chosen}
              disabled={may("command") !== true}
              onClick={() => props.onChoose(name)}
              {...handlersOf(name)}
            >
              {title}
            </button>
          </li>
        ))}
      </ul>
      {now !== null && (
        <div class={`carried ${now.place === null ? "" : "has-place"}`} style={{ left: `${now.x}px`, top: `${now.y}px` }}>
          <Icon name="block" />
          {now.place === null ? words.noPlace : words.placeAt(now.place)}
        </div>
      )}
    </>
  );
}
