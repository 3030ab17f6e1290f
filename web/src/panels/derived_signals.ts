import { computed } from "@preact/signals";
import { may, mayControlNow } from "../allowed";
import { HANDS, type HandName } from "../protocol";
import { settled } from "../settled";
import { scene, state } from "../studio";

export const isPaused = computed(() => state.value?.paused ?? false);
export const isClearingTable = computed(() => state.value?.mode === "rage");
export const isPlayback = computed(() => state.value?.mode === "playback");
/** A program controls the simulation, and the page shows it. */
export const isWatched = computed(() => state.value?.mode === "watched");
/** The world goes back to a moment of a recording. */
export const isRestoring = computed(() => (state.value?.restoring ?? null) !== null);
export const isRecording = computed(() => (state.value?.recording ?? null) !== null);
/** The recording that the views show; null while they show the table. */
export const shownRecording = computed(() => state.value?.playback?.recording ?? null);
export const recordingId = computed(() => state.value?.recording?.id ?? null);
/** The controller may reach into the world now. */
export const mayAct = computed(() => may("command") === true);
export const mayControl = computed(() => mayControlNow() === true);
export const liveSegments = settled(() => state.value?.recording?.segments ?? []);
/** Whether a correction was begun, and its user has not acted yet. */
export const isAtCorrection = settled(() => {
  const recording = state.value?.recording;
  return recording?.corrects != null && recording.seconds <= recording.corrects.seconds + 0.1;
});
/** The hands that act again while the user records; null without. */
export const recordedOver = settled(() => state.value?.recording?.over ?? null);
export const brain = settled(() => state.value?.brain ?? null);
/** A brain is at work, or is about to. */
export const isBrainAtWork = computed(() => ["starting", "running"].includes(brain.value?.status ?? ""));
/** The last recording, if it ended by itself. */
export const failedRecording = settled(() => state.value?.failure ?? null);
/** The camera whose pictures are recorded, and the others; null without pictures. */
export const recordedEye = settled(() => state.value?.eye ?? null);
export const snaps = settled(() => state.value?.snap ?? []);
export const gone = settled(() => state.value?.gone ?? []);
export const attention = settled(() => state.value?.attention ?? {});

/** Who holds what. */
export const holders = settled(() => {
  const found: Record<string, HandName> = {};
  for (const hand of HANDS) {
    const object = state.value?.hands[hand].object;
    if (object) found[object] = hand;
  }
  return found;
});

/** The objects that lie on the floor. */
export const fallen = settled(() => state.value?.fallen ?? []);

/** The objects that are still in play. */
export const objectsHere = computed(
  () => scene.value?.objects.filter(({ id }) => !gone.value.includes(id) && !fallen.value.includes(id)) ?? [],
);
