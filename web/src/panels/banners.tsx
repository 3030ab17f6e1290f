import { useEffect } from "preact/hooks";
import { effect, signal, useSignal } from "@preact/signals";
import { may, when } from "../allowed";
import { ask, clients, isConnected, isController, progress } from "../studio";
import { texts } from "../texts";
import { Button } from "../ui/buttons";
import { openDialogs } from "../ui/dialog";
import { Notices } from "../ui/notices";
import { ControlWanted, takeControl } from "./control";
import { failedRecording, isAtCorrection, isPaused, isPlayback, isClearingTable, isRestoring, isWatched, recordedOver } from "./derived_signals";

/** Time before the page reports that connecting takes long, and time before it reports that it may fail. */
const PATIENCE_MS = 800;
const DOUBT_MS = 10_000;

function Disconnected() {
  const words = useSignal<string | null>(null);
  useEffect(() => {
    const { connecting, lost, doubt } = texts.connection;
    const first = clients.value === null ? connecting : lost;
    const timers = [
      setTimeout(() => (words.value = first), PATIENCE_MS),
      setTimeout(() => (words.value = doubt), DOUBT_MS),
    ];
    return () => timers.forEach(clearTimeout);
  }, []);
  if (words.value === null) return null;
  return (
    <div class="banner error" role="alert">
      <span class="spinner" />
      <span>{words.value}</span>
    </div>
  );
}

function Busy() {
  const what = progress.value?.what ?? (isRestoring.value ? "branch" : null);
  if (what === null || openDialogs.value.length > 0) return null;
  return (
    <div class="banner busy">
      <label for="busy">{texts.progress[what] ?? what}</label>
      {progress.value === null ? <progress id="busy" /> : <progress id="busy" value={progress.value.done} max={progress.value.total} />}
    </div>
  );
}

/** The failure that was read, and is not reported again. */
const readFailure = signal<string | null>(null);
effect(() => {
  if (failedRecording.value === null) readFailure.value = null;
});

/** The last recording ended by itself: that stays until it is read. */
function Failure() {
  const { failure } = texts;
  const now = failedRecording.value;
  if (now === null || readFailure.value === now.recording) return null;
  return (
    <div class="banner error" role="alert">
      <span>
        {now.kept ? failure.kept(now.title || now.recording) : failure.lost(now.title || now.recording)} <small>{now.error}</small>
      </span>
      <Button label={failure.read} onClick={() => (readFailure.value = now.recording)} />
    </div>
  );
}

/** What is to be done while time is paused. */
function pausedWords(): string {
  if (recordedOver.value !== null) return texts.timeline.overPaused(recordedOver.value.hands);
  return isAtCorrection.value ? texts.timeline.correctPaused : texts.time.paused;
}

/** The banners for the last reported state of the program. */
function Present() {
  return (
    <>
      <Busy />
      <Failure />
      <ControlWanted />
      {clients.value !== null && !isController.value && !isWatched.value && (
        <div class="banner">
          <span>{texts.people.watchingBanner}</span>
          <Button label={texts.people.take} kind="accent" onClick={() => void takeControl(false)} />
        </div>
      )}
      {isPlayback.value && (
        <div class="banner">
          <span>{texts.timeline.playbackBanner}</span>
          <Button
            label={texts.timeline.live}
            kind="accent"
            {...when(may("live"))}
            onClick={() => void ask("live")}
          />
        </div>
      )}
      {isClearingTable.value && (
        <div class="banner words-only">
          <span>{texts.objects.rageBanner}</span>
        </div>
      )}
      {isPaused.value && !isPlayback.value && (
        <div class="banner">
          <span>{pausedWords()}</span>
          <Button
            label={texts.time.resume}
            kind="accent"
            {...when(may("resume"))}
            onClick={() => void ask("resume")}
          />
        </div>
      )}
    </>
  );
}

/** What one has to know before one wonders why nothing happens. */
export function Banners() {
  return (
    <div class="banners">
      {isConnected.value ? <Present /> : <Disconnected />}
      {openDialogs.value.length === 0 && <Notices />}
    </div>
  );
}
