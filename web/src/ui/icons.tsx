/** Outlines on a grid of 24 by 24, drawn with a line 1.8 wide. */
const OUTLINES = {
  record: "M12 12m-6 0a6 6 0 1 0 12 0a6 6 0 1 0 -12 0",
  stop: "M7 7h10v10H7z",
  play: "M8 5.5v13l10.5-6.5z",
  pause: "M8.5 5.5v13M15.5 5.5v13",
  undo: "M8.5 5 4.5 9l4 4M5 9h8.5a5 5 0 0 1 0 10H10",
  redo: "M15.5 5l4 4-4 4M19 9h-8.5a5 5 0 0 0 0 10H14",
  left: "M14.5 6l-6 6 6 6",
  right: "M9.5 6l6 6-6 6",
  up: "M6 14.5l6-6 6 6",
  down: "M6 9.5l6 6 6-6",
  higher: "M12 19V5M7 10l5-5 5 5M6 21h12",
  lower: "M12 4v14M7 13l5 5 5-5M6 21h12",
  plus: "M12 5.5v13M5.5 12h13",
  minus: "M5.5 12h13",
  cross: "M6.5 6.5l11 11M17.5 6.5l-11 11",
  check: "M5 12.5l4.5 4.5L19 7.5",
  search: "M10.5 10.5m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0 -11 0M14.7 14.7 19.5 19.5",
  trash: "M5 7h14M10 7V4.5h4V7M7 7l.8 12.5h8.4L17 7M10.3 10.5v5.5M13.7 10.5v5.5",
  pencil: "M5 19l.9-4L16 4.9l3.1 3.1L9 18.1zM14 7l3 3",
  download: "M12 4.5v10M7.5 10.5l4.5 4.5 4.5-4.5M5 19.5h14",
  upload: "M12 15V5M7.5 9l4.5-4.5L16.5 9M5 19.5h14",
  reload: "M18.5 9.5A7 7 0 1 0 19 13M19 5v4.5h-4.5",
  more: "M6 12h.01M12 12h.01M18 12h.01",
  cut: "M8 8l11 8.5M8 16 19 7.5M6 7m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0M6 17m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0",
  branch: "M7 5v14M7 14c0-4 10-2 10-7M17 7m-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0",
  help: "M9 9.2a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5h.01M12 12m-9 0a9 9 0 1 0 18 0a9 9 0 1 0 -18 0",
  sun: "M12 12m-3.8 0a3.8 3.8 0 1 0 7.6 0a3.8 3.8 0 1 0 -7.6 0M12 3v1.8M12 19.2V21M3 12h1.8M19.2 12H21M5.6 5.6l1.3 1.3M17.1 17.1l1.3 1.3M18.4 5.6l-1.3 1.3M6.9 17.1l-1.3 1.3",
  moon: "M19.5 14.5A8 8 0 0 1 9.5 4.5a8 8 0 1 0 10 10z",
  people: "M9 8.5m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0M3 19c0-3.5 2.7-5.5 6-5.5s6 2 6 5.5M15.5 5.6a3.2 3.2 0 0 1 0 5.8M17.5 14c2.2.7 3.5 2.5 3.5 5",
  block: "M12 3.5l7.5 4.2v8.6L12 20.5l-7.5-4.2V7.7zM4.8 7.8 12 12l7.2-4.2M12 12v8.3",
  library: "M4.5 5.5h15v13h-15zM10.5 9.5v5l4-2.5z",
  hand: "M8 12V6.5a1.5 1.5 0 0 1 3 0V11V5a1.5 1.5 0 0 1 3 0v6-4.5a1.5 1.5 0 0 1 3 0V14c0 4-2 6.5-5.5 6.5-3 0-4.3-1.3-5.6-3.7l-1.7-3a1.5 1.5 0 0 1 2.5-1.6z",
  robot: "M6 9.5h12V18H6zM12 9.5V6M12 5m-1 0a1 1 0 1 0 2 0a1 1 0 1 0 -2 0M9.5 13h.01M14.5 13h.01M10 15.8h4M3.5 12v3.5M20.5 12v3.5",
  brain: "M12 5.5a3 3 0 0 0-5.5 1.7A3.2 3.2 0 0 0 5 12.8a3.2 3.2 0 0 0 3 4.7 2.6 2.6 0 0 0 4 .7zM12 5.5a3 3 0 0 1 5.5 1.7 3.2 3.2 0 0 1 1.5 5.6 3.2 3.2 0 0 1-3 4.7 2.6 2.6 0 0 1-4 .7M12 5.5v13",
  film: "M4 6h16v12H4zM8 6v12M16 6v12M4 10h4M4 14h4M16 10h4M16 14h4",
  eye: "M3 12c2.3-4 5.4-6 9-6s6.7 2 9 6c-2.3 4-5.4 6-9 6s-6.7-2-9-6zM12 12m-2.7 0a2.7 2.7 0 1 0 5.4 0a2.7 2.7 0 1 0 -5.4 0",
  share: "M17 6m-2.3 0a2.3 2.3 0 1 0 4.6 0a2.3 2.3 0 1 0 -4.6 0M7 12m-2.3 0a2.3 2.3 0 1 0 4.6 0a2.3 2.3 0 1 0 -4.6 0M17 18m-2.3 0a2.3 2.3 0 1 0 4.6 0a2.3 2.3 0 1 0 -4.6 0M9 10.8l6-3.6M9 13.2l6 3.6",
  copy: "M9 9h10v10.5H9zM15 9V5H5v10.5h4",
  collapseLeft: "M4.5 5.5h15v13h-15zM9.5 5.5v13M15.5 9.5 13 12l2.5 2.5",
  collapseRight: "M4.5 5.5h15v13h-15zM14.5 5.5v13M8.5 9.5 11 12l-2.5 2.5",
  warning: "M12 4.5l8.5 15h-17zM12 10v4.5M12 17h.01",
} as const;

export type IconName = keyof typeof OUTLINES;

const FILLED: IconName[] = ["record", "stop", "play"];

/** Decoration: whatever it stands on has a label of its own. */
export function Icon({ name, size = 20 }: { name: IconName; size?: number }) {
  return (
    <svg class="icon" width={size} height={size} viewBox="0 0 24 24" aria-hidden="true">
      <path
        d={OUTLINES[name]}
        fill={FILLED.includes(name) ? "currentColor" : "none"}
        stroke="currentColor"
        stroke-width="1.8"
        stroke-linecap="round"
        stroke-linejoin="round"
      />
    </svg>
  );
}
