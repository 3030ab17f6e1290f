import type { HTMLAttributes } from "preact";
import { useRef } from "preact/hooks";

const KEY_STEP = 20; // [px]

type Handlers = Pick<
  HTMLAttributes<HTMLElement>,
  "onPointerDown" | "onPointerMove" | "onPointerUp" | "onPointerCancel" | "onKeyDown"
>;

/** Handlers of an edge or corner that sets a width [px]: dragged, or moved with the arrow keys. */
export function useResize(props: {
  /** The edge at which it is made wider. */
  edge: "left" | "right";
  width: () => number;
  resize: (width: number) => void;
}): Handlers {
  const start = useRef<{ x: number; width: number } | null>(null);
  const outward = props.edge === "right" ? 1 : -1;
  const end = () => (start.current = null);
  return {
    onPointerDown: (event) => {
      event.currentTarget.setPointerCapture(event.pointerId);
      start.current = { x: event.clientX, width: props.width() };
    },
    onPointerMove: (event) => {
      if (start.current) props.resize(start.current.width + outward * (event.clientX - start.current.x));
    },
    onPointerUp: end,
    onPointerCancel: end,
    onKeyDown: (event) => {
      const ways: Record<string, number> = { ArrowRight: outward, ArrowLeft: -outward, ArrowUp: 1, ArrowDown: -1 };
      const way = ways[event.key];
      if (way === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      props.resize(props.width() + way * KEY_STEP);
    },
  };
}
