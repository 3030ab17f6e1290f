import type { ComponentType } from "preact";
import { useRef } from "preact/hooks";
import type { Signal } from "@preact/signals";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { Icon, type IconName } from "../ui/icons";
import { isSmall } from "../ui/media";
import { useResize } from "../ui/resize";
import { PANEL_WIDTHS, panelWidths, sheet, type LeftTab, type RightTab } from "./page";

export const TAB_ICONS: Record<LeftTab | RightTab, IconName> = {
  objects: "block",
  library: "library",
  hands: "hand",
  robot: "robot",
  brain: "brain",
};

interface SidebarProps<Tab extends LeftTab | RightTab> {
  side: "left" | "right";
  label: string;
  tabs: readonly Tab[];
  chosen: Signal<Tab>;
  isOpen: Signal<boolean>;
  panels: Record<Tab, ComponentType>;
}

/** The edge between a panel and the world; a double click returns it to its place. */
function Edge({ side }: { side: "left" | "right" }) {
  const edge = useRef<HTMLDivElement>(null);
  const wanted = panelWidths[side];
  const width = () => edge.current?.parentElement?.offsetWidth ?? PANEL_WIDTHS.min;
  const resize = (to: number) =>
    (wanted.value = Math.round(Math.min(PANEL_WIDTHS.max, Math.max(PANEL_WIDTHS.min, to))));
  return (
    <div
      ref={edge}
      class="sidebar-edge"
      role="separator"
      aria-orientation="vertical"
      aria-label={texts.panels.width}
      aria-valuemin={PANEL_WIDTHS.min}
      aria-valuemax={PANEL_WIDTHS.max}
      aria-valuenow={wanted.value ?? width()}
      tabIndex={0}
      title={texts.panels.widthWhy}
      onDblClick={() => (wanted.value = null)}
      {...useResize({ edge: side === "left" ? "right" : "left", width, resize })}
    />
  );
}

/** Panels behind tabs; folded it is a strip of the tabs' icons, and a sheet where the screen is small. */
export function Sidebar<Tab extends LeftTab | RightTab>(props: SidebarProps<Tab>) {
  const { side, chosen, isOpen } = props;
  const tablist = useRef<HTMLDivElement>(null);
  const present = props.tabs.includes(chosen.value) ? chosen.value : props.tabs[0]!;
  const shown = isSmall.value ? (props.tabs.find((tab) => tab === sheet.value) ?? null) : isOpen.value ? present : null;
  if (isSmall.value && shown === null) return null;
  const choose = (tab: Tab) => {
    chosen.value = tab;
    isOpen.value = true;
  };
  const go = (event: KeyboardEvent) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const at = props.tabs.indexOf(present);
    const next = props.tabs[(at + step + props.tabs.length) % props.tabs.length]!;
    choose(next);
    tablist.current?.querySelector<HTMLElement>(`#tab-${next}`)?.focus();
  };
  const Panel: ComponentType | null = shown === null ? null : props.panels[shown];
  return (
    <aside class={`sidebar ${side} ${shown === null ? "folded" : ""}`} aria-label={props.label}>
      <div class="sidebar-head">
        {isSmall.value && shown !== null ? (
          <>
            <h2>{texts[shown].tab}</h2>
            <Button label={texts.close} icon="cross" kind="quiet" isIconOnly onClick={() => (sheet.value = null)} />
          </>
        ) : (
          <>
            <h2 class="visually-hidden">{props.label}</h2>
            <div
              role="tablist"
              aria-label={props.label}
              aria-orientation={shown === null ? "vertical" : "horizontal"}
              class="tabs"
              ref={tablist}
              onKeyDown={go}
            >
              {props.tabs.map((tab) => (
                <button
                  key={tab}
                  type="button"
                  role="tab"
                  id={`tab-${tab}`}
                  aria-selected={tab === shown}
                  aria-controls={`panel-${side}`}
                  tabIndex={tab === present ? 0 : -1}
                  title={shown === null ? texts[tab].tab : undefined}
                  onClick={() => choose(tab)}
                >
                  <Icon name={TAB_ICONS[tab]} />
                  <span>{texts[tab].tab}</span>
                </button>
              ))}
            </div>
            {shown !== null && (
              <Button
                label={texts.panels.collapse}
                icon={side === "left" ? "collapseLeft" : "collapseRight"}
                kind="quiet"
                isIconOnly
                onClick={() => (isOpen.value = false)}
              />
            )}
          </>
        )}
      </div>
      {Panel && !isSmall.value && <Edge side={side} />}
      {Panel && (
        <div class="sidebar-body" role="tabpanel" id={`panel-${side}`} aria-label={texts[shown!].tab}>
          <Panel />
        </div>
      )}
    </aside>
  );
}
