import { texts } from "../texts";
import { Icon } from "../ui/icons";
import { isSmall } from "../ui/media";
import { isOffered } from "../allowed";
import { leftTabs, rightTabs, sheet, showPanel, type Sheet } from "./page";
import { TAB_ICONS } from "./sidebar";

/** Where the screen is small: which sheet is up. */
export function TabBar() {
  if (!isSmall.value) return null;
  const entry = (name: Sheet, label: string, toggle: () => void) => (
    <button key={name} type="button" aria-pressed={sheet.value === name} onClick={toggle}>
      <Icon name={name === "timeline" ? "film" : TAB_ICONS[name]} />
      <span>{label}</span>
    </button>
  );
  return (
    <nav class="tab-bar" aria-label={texts.panels.all}>
      {[...leftTabs.value, ...rightTabs.value].map((tab) =>
        entry(tab, texts[tab].tab, () => (sheet.value === tab ? (sheet.value = null) : showPanel(tab))),
      )}
      {isOffered("show") && entry("timeline", texts.timeline.fold, () => (sheet.value = sheet.value === "timeline" ? null : "timeline"))}
    </nav>
  );
}
