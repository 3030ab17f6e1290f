import { useEffect } from "preact/hooks";
import { useSignalEffect } from "@preact/signals";
import { isOffered } from "../allowed";
import { isConnected, notify, numLibraryUpdates, scene } from "../studio";
import { texts } from "../texts";
import { isSmall } from "../ui/media";
import { AnalysisDialog } from "./analysis_dialog";
import { Banners } from "./banners";
import { BrainPanel } from "./brain_panel";
import { ContextMenu } from "./context_menu";
import { ExportDialog } from "./export_dialog";
import { EyeView } from "./eye_view";
import { FilmDialog } from "./film_dialog";
import { GenerateDialog } from "./generate_dialog";
import { refreshSceneCatalog } from "./scene_catalog";
import { HandsPanel } from "./hands_panel";
import { Help } from "./help";
import { LibraryPanel } from "./library_panel";
import { isRecording, isWatched, recordingId, shownRecording } from "./derived_signals";
import { ObjectsPanel } from "./objects_panel";
import { analyzed, editedScene, exported, filmed, generated, isHelpOpen, isLeftOpen, isRightOpen, leftTab, leftTabs, openedSet, panelWidths, renamed, renamedSet, rightTab, rightTabs, sheet } from "./page";
import { onRecordingFinished, onRecordingShown, refreshRecordings } from "./recordings";
import { RenameDialog } from "./rename_dialog";
import { RenameSetDialog } from "./rename_set_dialog";
import { RobotPanel } from "./robot_panel";
import { SceneEditor } from "./scene_editor";
import { SetDialog } from "./set_dialog";
import { Sidebar } from "./sidebar";
import { Stage } from "./stage";
import { TabBar } from "./tab_bar";
import { TimelinePanel } from "./timeline_panel";
import { TopBar } from "./top_bar";
import { hasTour, Tour } from "./tour";

/** Whatever is known of the outside is looked up again when the connection comes back. */
function useRefresh(): void {
  useSignalEffect(() => {
    if (!isConnected.value) return;
    void refreshSceneCatalog();
    void refreshRecordings();
  });
  useEffect(() => {
    let wasConnected = false;
    let isLost = false;
    return isConnected.subscribe((yes) => {
      if (yes && isLost) notify(texts.connection.back);
      isLost = !yes && wasConnected;
      wasConnected = wasConnected || yes;
    });
  }, []);
  useEffect(() => {
    let num = numLibraryUpdates.value;
    return numLibraryUpdates.subscribe((now) => {
      // The end of a recording updates the library anyway.
      if (now !== num && !isRecording.value) void refreshRecordings();
      num = now;
    });
  }, []);
  useEffect(() => shownRecording.subscribe((id) => void (id !== null && onRecordingShown(id))), []);
  useEffect(() => {
    let last: string | null = null;
    return recordingId.subscribe((id) => {
      if (last !== null && id === null) void onRecordingFinished(last);
      last = id;
    });
  }, []);
}

/** The window's title contains the scene, and whether a recording is in progress. */
function useTitle(): void {
  useSignalEffect(() => {
    const name = scene.value?.name;
    document.title = `${isRecording.value ? "● " : ""}${name === undefined ? "" : `${name} – `}${texts.title}`;
  });
}

/** As the user made it, but the world keeps a third of the window. */
function widthOf(side: "left" | "right", isOpen: boolean): Record<string, string> {
  const width = panelWidths[side].value;
  return isOpen && width !== null ? { [`--${side}`]: `min(${width}px, 33vw)` } : {};
}

export function StudioPage() {
  useRefresh();
  useTitle();
  // What a watched simulation has no use for is left out; the world stays where it is in the tree.
  const isWhole = !isWatched.value;
  return (
    <div
      class={`studio ${isWhole ? "" : "is-watched"} ${isSmall.value ? "is-small" : ""} ${isLeftOpen.value ? "" : "left-folded"} ${isRightOpen.value ? "" : "right-folded"}`}
      style={{ ...widthOf("left", isLeftOpen.value), ...widthOf("right", isRightOpen.value) }}
      data-sheet={isSmall.value ? (sheet.value ?? "none") : undefined}
    >
      <TopBar />
      {isWhole && (
        <Sidebar
          side="left"
          label={texts.panels.left}
          tabs={leftTabs.value}
          chosen={leftTab}
          isOpen={isLeftOpen}
          panels={{ objects: ObjectsPanel, library: LibraryPanel }}
        />
      )}
      <Stage>
        <Banners />
        {isWhole && isOffered("eye") && <EyeView />}
        {isWhole && hasTour.value && <Tour />}
      </Stage>
      {isWhole && (
        <Sidebar
          side="right"
          label={texts.panels.right}
          tabs={rightTabs.value}
          chosen={rightTab}
          isOpen={isRightOpen}
          panels={{ hands: HandsPanel, robot: RobotPanel, brain: BrainPanel }}
        />
      )}
      {isWhole && isOffered("show") && <TimelinePanel />}
      {isWhole && <TabBar />}
      <ContextMenu />
      {isHelpOpen.value && <Help />}
      {editedScene.value && <SceneEditor key={editedScene.value.name} />}
      {renamed.value !== null && <RenameDialog id={renamed.value} />}
      {renamedSet.value !== null && <RenameSetDialog name={renamedSet.value} />}
      {analyzed.value !== null && <AnalysisDialog recording={analyzed.value} />}
      {exported.value !== null && <ExportDialog source={exported.value} />}
      {filmed.value !== null && <FilmDialog recording={filmed.value} />}
      {openedSet.value !== null && <SetDialog key={openedSet.value} name={openedSet.value} />}
      {generated.value !== null && <GenerateDialog recording={generated.value} />}
    </div>
  );
}
