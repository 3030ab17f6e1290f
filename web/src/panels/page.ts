import { computed, effect, signal } from "@preact/signals";
import { choicePreference, inLayout, layoutSwitch, numberPreference, preference, resetLayout, switchPreference } from "../ui/preference";
import { prefersDark } from "../ui/media";
import { isCommandOffered, isOffered } from "../allowed";
import type { World } from "../world/world";

// What is open, chosen and liked on this page. None of it is known to the program.

export const LEFT_TABS = ["objects", "library"] as const;
export const RIGHT_TABS = ["hands", "robot", "brain"] as const;
export type LeftTab = (typeof LEFT_TABS)[number];
export type RightTab = (typeof RIGHT_TABS)[number];
export type Sheet = LeftTab | RightTab | "timeline";

/** The panels for what the program offers. */
export const leftTabs = computed(() => LEFT_TABS.filter((tab) => tab === "objects" || isOffered("open")));
export const rightTabs = computed(() => RIGHT_TABS.filter((tab) => hasRightTab[tab]()));
const hasRightTab: Record<RightTab, () => boolean> = {
  hands: () => true,
  robot: () => isCommandOffered("pose"),
  brain: () => isOffered("start_brain"),
};

export const leftTab = inLayout(choicePreference<LeftTab>("left", "objects", LEFT_TABS));
export const rightTab = inLayout(choicePreference<RightTab>("right", "hands", RIGHT_TABS));
export const isLeftOpen = layoutSwitch("left-open", true);
export const isRightOpen = layoutSwitch("right-open", true);
/** Widths that panels may have [px]. */
export const PANEL_WIDTHS = { min: 220, max: 560 };
/** Widths of the panels at the sides [px]; null: as wide as the style has them. */
export const panelWidths = {
  left: inLayout(preference<number | null>("left-width", null, isPanelWidth)),
  right: inLayout(preference<number | null>("right-width", null, isPanelWidth)),
};
export const isTimelineOpen = layoutSwitch("timeline-open", true);
export const eyeWidth = inLayout(numberPreference("eye-width", 200, 120, 640));
export const isEyeOpen = layoutSwitch("eye-open", true);
export const isTourKnown = switchPreference("tour-known", false);
function isPanelWidth(value: unknown): value is number | null {
  return value === null || (typeof value === "number" && value >= PANEL_WIDTHS.min && value <= PANEL_WIDTHS.max);
}

/** Where the screen is small, one panel at a time is a sheet; null: none. */
export const sheet = signal<Sheet | null>(null);

export const THEMES = ["system", "light", "dark"] as const;
export const theme = choicePreference("theme", "system", THEMES);
export const isDark = computed(() => (theme.value === "system" ? prefersDark.value : theme.value === "dark"));
effect(() => {
  document.documentElement.dataset.theme = isDark.value ? "dark" : "light";
});

export const DETAILS = ["auto", "low", "high"] as const;
/** How finely the world is drawn; by itself as finely as it goes smoothly. */
export const detail = choicePreference("detail", "auto", DETAILS);

/** The three-dimensional world, once it is there. */
export const world = signal<World | null>(null);
/** The object chosen in the list. */
export const chosenObject = signal<string | null>(null);
export const isHelpOpen = signal(false);
export interface SceneText {
  name: string;
  xml: string;
}

function isSceneText(value: unknown): value is SceneText {
  const text = value as Partial<SceneText> | null;
  return typeof text?.name === "string" && typeof text.xml === "string";
}

/** The scene's text that is edited. */
export const editedScene = signal<SceneText | null>(null);
/** What was written and is not loaded yet: neither Escape nor a reload of the page loses it. */
export const draft = preference<SceneText | null>(
  "draft",
  null,
  (value): value is SceneText | null => value === null || isSceneText(value),
);
/** The recording whose title and notes are changed. */
export const renamed = signal<string | null>(null);
/** The generated set whose name is changed. */
export const renamedSet = signal<string | null>(null);
/** The recording that is analyzed. */
export const analyzed = signal<string | null>(null);
/** The recording of which a set is to be generated. */
export const generated = signal<string | null>(null);
/** The recording or generated set that is to be exported. */
export const exported = signal<{ recording: string } | { set: string } | null>(null);
/** The recording of which a film is to be made. */
export const filmed = signal<string | null>(null);
/** The generated set whose attempts are looked at. */
export const openedSet = signal<string | null>(null);
/** What is chosen to be imitated. */
export const toImitate = signal<string | null>(null);

/** Panels, their sizes and the view are as on a first visit. */
export function returnToDefaultLayout(): void {
  resetLayout();
  world.value?.showFirstView();
}

/** Brings a panel to the front, wherever it is. */
export function showPanel(tab: LeftTab | RightTab): void {
  sheet.value = tab;
  if (tab === "objects" || tab === "library") {
    leftTab.value = tab;
    isLeftOpen.value = true;
  } else {
    rightTab.value = tab;
    isRightOpen.value = true;
  }
}
