import { useSignal } from "@preact/signals";
import { may } from "../allowed";
import type { Allowed, LibraryEntry, Timeline } from "../protocol";
import { ask, notify, state } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { downloadFile } from "../ui/download";
import { Empty, isFound, Picture, SearchField } from "../ui/card";
import { MenuButton, type MenuEntry } from "../ui/menu";
import { refreshSets, sets } from "./datasets";
import { analyzed, exported, filmed, generated, isTimelineOpen, renamed, shared, sheet, showPanel, toImitate } from "./page";
import { opened, openRecording, pictureOfRecording, recordings, refreshRecordings, titleOf, whenMade } from "./recordings";
import { JobList, SetsList } from "./sets_list";
import { TitleInPlace } from "./title_in_place";

const { library: words } = texts;

async function bin(id: string): Promise<void> {
  const title = titleOf(id);
  if (state.value?.playback?.recording === id && (await ask("live")) === null) return;
  if ((await ask("bin", { recording: id })) === null) return;
  notify(words.binned(title));
  if (opened.value?.id === id) opened.value = null;
  await refreshRecordings();
}

async function takeBack(id: string): Promise<void> {
  const title = titleOf(id);
  if ((await ask("unbin", { recording: id })) === null) return;
  notify(words.isBack(title));
  await refreshRecordings();
}

function download(id: string): void {
  downloadFile(`/recordings/${encodeURIComponent(id)}.zip`);
}

/** Its timeline comes to the front, wherever it is; null if it cannot be opened. */
export async function open(id: string): Promise<Timeline | null> {
  const timeline = opened.value?.id === id ? opened.value.timeline : await openRecording(id);
  isTimelineOpen.value = true;
  sheet.value = "timeline";
  return timeline;
}

async function showEnd(id: string): Promise<void> {
  const timeline = await open(id);
  if (timeline !== null) await ask("show", { recording: id, seconds: timeline.seconds });
}

function imitate(id: string): void {
  toImitate.value = id;
  showPanel("brain");
}

async function refresh(): Promise<void> {
  await Promise.all([refreshRecordings(), refreshSets()]);
}

function entriesOf(recording: LibraryEntry): MenuEntry[] {
  const { id } = recording;
  const unless = (allowed: Allowed) => (allowed === true ? {} : { disabled: true, reason: allowed });
  return [
    { label: words.show, icon: "eye", ...unless(may("show")), onChoose: () => void showEnd(id) },
    { label: words.imitate, icon: "robot", onChoose: () => imitate(id) },
    {
      label: texts.datasets.generateEntry,
      icon: "copy",
      ...unless(may("generate")),
      onChoose: () => (generated.value = id),
    },
    { label: texts.filming.entry, icon: "film", ...unless(may("film")), onChoose: () => (filmed.value = id) },
    {
      label: texts.exporting.entry,
      icon: "library",
      ...unless(may("export")),
      onChoose: () => (exported.value = { recording: id }),
    },
    { label: texts.sharing.entry, icon: "share", ...unless(may("share")), onChoose: () => (shared.value = id) },
    { label: words.analyze, icon: "search", ...unless(may("analyze")), onChoose: () => (analyzed.value = id) },
    { label: words.rename, icon: "pencil", ...unless(may("rename")), onChoose: () => (renamed.value = id) },
    { label: words.download, icon: "download", onChoose: () => download(id) },
    { label: words.toBin, icon: "trash", isDanger: true, ...unless(may("bin")), onChoose: () => void bin(id) },
  ];
}

function RecordingCard({ recording }: { recording: LibraryEntry }) {
  const { id, binned } = recording;
  const title = titleOf(id);
  const isOpen = opened.value?.id === id;
  return (
    <li class={`recording ${isOpen ? "is-open" : ""}`}>
      <Picture source={pictureOfRecording(id)} alt={words.picture(title)} />
      <div class="recording-words">
        <strong>
          <TitleInPlace id={id} isFixed={binned} />
        </strong>
        {recording.error ? (
          <p class="trouble">{recording.error}</p>
        ) : (
          <small>
            {texts.seconds(recording.seconds ?? 0)} · {words.segments(recording.segments ?? 0)}
          </small>
        )}
        {recording.corrects && (
          <small>{texts.timeline.corrects(titleOf(recording.corrects.recording), recording.corrects.seconds)}</small>
        )}
        <small>
          {recording.scene && `${recording.scene} · `}
          {whenMade(recording.made)}
        </small>
        {recording.notes && <p class="notes">{recording.notes}</p>}
        <div class="row tight">
          {binned ? (
            <Button label={words.takeBack} disabled={may("unbin") !== true} onClick={() => void takeBack(id)} />
          ) : (
            <>
              <Button
                label={isOpen ? words.isOpen : words.open}
                title={words.openWhy}
                disabled={recording.error !== undefined}
                onClick={() => void open(id)}
              />
              <MenuButton label={words.actions(title)} entries={entriesOf(recording)} />
            </>
          )}
        </div>
      </div>
    </li>
  );
}

/** The same recordings, each followed by those that correct it. */
function withCorrections(all: LibraryEntry[]): LibraryEntry[] {
  const listed = new Set<LibraryEntry>();
  const list = (one: LibraryEntry) => {
    if (listed.has(one)) return;
    listed.add(one);
    all.filter(({ corrects }) => corrects?.recording === one.id).forEach(list);
  };
  const isCorrection = ({ corrects }: LibraryEntry) => all.some(({ id }) => id === corrects?.recording);
  all.filter((one) => !isCorrection(one)).forEach(list);
  all.forEach(list); // those that correct each other, which only a changed file says
  return [...listed];
}

export function LibraryPanel() {
  const search = useSignal("");
  const isBin = useSignal(false);
  const all = recordings.value;
  const here = (all ?? []).filter((recording) => recording.binned === isBin.value);
  const found = here.filter(({ id, title = "", notes = "", scene = "" }) => isFound(search.value, id, title, notes, scene));
  const numBinned = [...(all ?? []), ...(sets.value ?? [])].filter(({ binned }) => binned).length;
  return (
    <>
      <div class="row">
        <SearchField label={words.search} text={search} />
        <Button
          label={words.refresh}
          icon="reload"
          kind="quiet"
          isIconOnly
          onClick={() => void refresh()}
        />
        <Button
          label={words.binView}
          icon="trash"
          kind="quiet"
          isIconOnly
          isPressed={isBin.value}
          onClick={() => (isBin.value = !isBin.value)}
        >
          {numBinned > 0 && <span class="count">{numBinned}</span>}
        </Button>
      </div>
      <JobList />
      {isBin.value && <h3 class="bin-title">{words.bin}</h3>}
      <SetsList search={search.value} isBin={isBin.value} />
      {all === null ? (
        <Empty icon="library" text={words.loading} />
      ) : here.length === 0 ? (
        <Empty icon={isBin.value ? "trash" : "library"} text={isBin.value ? words.binIsEmpty : words.none} />
      ) : found.length === 0 ? (
        <Empty icon="search" text={words.notFound} />
      ) : (
        <ul class="recordings">
          {withCorrections(found).map((recording) => (
            <RecordingCard key={recording.id} recording={recording} />
          ))}
        </ul>
      )}
    </>
  );
}
