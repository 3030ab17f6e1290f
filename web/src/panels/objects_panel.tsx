import { useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { isCommandOffered, isOffered, may, when } from "../allowed";
import { ask, notify, scene } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { byWordsFound, Card, Empty, isFound, Picture, SearchField } from "../ui/card";
import { NumberField } from "../ui/number_field";
import { layoutSwitch } from "../ui/preference";
import { ObjectList } from "./object_list";
import { Palette } from "./palette";
import { sceneCatalog, isSceneCatalogLost, pictureOfScene, refreshSceneCatalog, textOfScene } from "./scene_catalog";
import { fallen, isPlayback, objectsHere } from "./derived_signals";
import { draft, editedScene } from "./page";
import { SelectionCard } from "./selection_card";
import { useAllowed } from "./use_allowed";

const { objects: words } = texts;
const isListOpen = layoutSwitch("list-open", true);
const isAddOpen = layoutSwitch("add-open", true);
const isSceneListOpen = layoutSwitch("gallery-open", true);
const MAX_FILE_BYTES = 1e6;

function AddObjects() {
  const preset = useSignal("");
  const seed = useSignal(1);
  const presets = sceneCatalog.value?.presets ?? [];
  const chosen = preset.value || (presets[0]?.name ?? "");
  const [mayClearTable] = useAllowed([{ do: "clear", rage: true }]);
  const spawn = async () => {
    if ((await ask("spawn", { preset: chosen, seed: seed.value })) !== null) seed.value += 1;
  };
  return (
    <>
      <Palette
        presets={presets}
        chosen={chosen}
        seed={seed.value}
        onChoose={(name) => (preset.value = name)}
        onAdded={() => (seed.value += 1)}
      />
      <div class="row">
        <span title={words.seedWhy}>
          <NumberField
            label={words.seed}
            isLabelled
            value={seed.value}
            digits={0}
            min={0}
            max={4294967295}
            step={1}
            onCommit={(value) => (seed.value = Math.round(value))}
          />
        </span>
        <Button
          label={words.spawn}
          icon="plus"
          class="grow"
          {...when(chosen === "" ? words.noPresets : may("spawn"))}
          onClick={() => void spawn()}
        />
      </div>
      <div class="row">
        <Button
          label={words.clear}
          class="grow"
          {...when(may("clear"), words.clearWhy)}
          onClick={() => void ask("clear")}
        />
        <Button
          label={words.rage}
          class="grow"
          {...when(mayClearTable, words.rageWhy)}
          onClick={() => void ask("clear", { rage: true })}
        />
      </div>
    </>
  );
}

function SceneList() {
  const search = useSignal("");
  const busy = useSignal<string | null>(null);
  const mayLoad = when(may("load"));
  const load = async (name: string) => {
    busy.value = name;
    await ask("load", { scene: name });
    busy.value = null;
  };
  if (isSceneCatalogLost.value) {
    return (
      <Empty icon="warning" text={words.noGallery}>
        <Button label={words.reload} icon="reload" onClick={() => void refreshSceneCatalog()} />
      </Empty>
    );
  }
  const found = (sceneCatalog.value?.scenes ?? []).filter(({ name, title }) => isFound(search.value, name, title));
  const scenes = byWordsFound(search.value, found, ({ name, title }) => [name, title]);
  return (
    <>
      <SearchField label={words.search} text={search} />
      {sceneCatalog.value === null && <span class="spinner" />}
      {sceneCatalog.value !== null && scenes.length === 0 && <Empty icon="search" text={words.noScenes} />}
      <ul class="gallery" aria-label={words.scenes} title={mayLoad.title}>
        {scenes.map(({ name, title }) => (
          <li key={name}>
            <button
              type="button"
              class="scene"
              title={title}
              disabled={mayLoad.disabled}
              aria-current={name === scene.value?.name}
              aria-busy={busy.value === name}
              onClick={() => void load(name)}
            >
              <Picture source={pictureOfScene(name)} alt="" />
              <span class="scene-title">{title}</span>
              <span class="scene-name">{name}</span>
              {busy.value === name && <span class="spinner" />}
              {name === scene.value?.name && <span class="badge">{words.isHere}</span>}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}

async function openFile(file: File): Promise<void> {
  if (file.size > MAX_FILE_BYTES) {
    notify(texts.editor.tooLarge, true);
    return;
  }
  editedScene.value = { name: file.name.replace(/\.xml$/i, ""), xml: await file.text() };
}

async function editPresentScene(): Promise<void> {
  const name = scene.value?.name ?? texts.editor.defaultName;
  editedScene.value = { name, xml: (await textOfScene(name)) ?? texts.editor.template };
}

function SceneActions() {
  const input = useRef<HTMLInputElement>(null);
  return (
    <div class="row scene-actions">
      <Button
        label={words.reload}
        icon="reload"
        {...when(may("reload"), words.reloadWhy)}
        onClick={() => void ask("reload")}
      />
      <Button label={words.upload} icon="upload" title={words.uploadWhy} onClick={() => input.current?.click()} />
      <Button label={words.write} icon="pencil" title={words.writeWhy} onClick={() => void editPresentScene()} />
      <input
        ref={input}
        type="file"
        accept=".xml,text/xml,application/xml"
        hidden
        aria-label={words.upload}
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          event.currentTarget.value = "";
          if (file) void openFile(file);
        }}
      />
    </div>
  );
}

export function ObjectsPanel() {
  return (
    <>
      <Card
        title={words.onTable}
        isOpen={isListOpen}
        aside={<span class="count">{words.show(objectsHere.value.length)}</span>}
      >
        <ObjectList />
        {fallen.value.length > 0 && (
          <p class="hint">
            {words.onFloor(fallen.value)} {!isPlayback.value && words.onFloorHint}
          </p>
        )}
      </Card>
      {isCommandOffered("displace") && <SelectionCard />}
      {isOffered("spawn") && (
        <Card title={words.add} isOpen={isAddOpen}>
          <AddObjects />
        </Card>
      )}
      {isOffered("load") && (
        <Card title={words.scenes} isOpen={isSceneListOpen}>
          <SceneActions />
          {draft.value && (
            <Button
              label={texts.editor.goOn(draft.value.name)}
              icon="pencil"
              onClick={() => (editedScene.value = draft.value)}
            />
          )}
          <SceneList />
        </Card>
      )}
    </>
  );
}
