import { computed, effect, signal } from "@preact/signals";
import type { Hand, StateMessage } from "../protocol";
import { poseListeners, programFolder, scene, state, variants } from "../studio";
import { decodeRecording, placeAt, poseAt, type Recording, TICKS_PER_SECOND } from "./recording";

const LINK = /^\/shared\/[0-9a-f]{32}\/?$/;
const RETRY_MS = 1500;
const MAX_TRIES = 20;
/** A picture that comes later is no reason to jump [s]. */
const MAX_STEP_SECONDS = 0.25;

/** The folder of this page's recording on the server: the secret of the link is in it. */
export const folder = `${location.pathname.replace(/\/+$/, "")}/`;

export const recording = signal<Recording | null>(null);
/** Why there is no recording; null: it is there, or on its way. */
export const obstacle = signal<"unknown" | "failed" | null>(null);
/** The moment that is shown. */
export const seconds = signal(0);
export const rate = signal(1);
export const isPlaying = signal(false);
export const length = computed(() => Math.max(0, (recording.value?.numTicks ?? 1) - 1) / TICKS_PER_SECOND);
const tick = computed(() => Math.round(seconds.value * TICKS_PER_SECOND));

/** Number of the last picture of the robot's eye; null before the first. */
export const eyePicture = computed(() => {
  const taken = recording.value?.description.eye.filter((one) => one <= tick.value).length ?? 0;
  return taken === 0 ? null : taken - 1;
});

/** For each frame, which pose was sent to the world last. */
let sent: number[] = [];
let frameRequest = 0;
let lastTime = 0;

/** Loads the recording; while the server is busy or away, again. */
export async function load(): Promise<void> {
  // A link that lost its end leads to this page, too.
  obstacle.value = LINK.test(location.pathname) ? null : "unknown";
  if (obstacle.value !== null) return;
  for (let k = 0; k < MAX_TRIES; ++k) {
    const answer = await fetch(`${folder}recording`).catch(() => null);
    if (answer?.ok) return begin(decodeRecording(await answer.arrayBuffer()));
    if (answer?.status === 404) {
      obstacle.value = "unknown";
      return;
    }
    await new Promise((next) => setTimeout(next, RETRY_MS));
  }
  obstacle.value = "failed";
}

function begin(loaded: Recording): void {
  programFolder.value = folder;
  recording.value = loaded;
  scene.value = loaded.description.scene;
  state.value = stateOf([]);
  document.title = loaded.description.title;
}

/** The world as it is now, to one that has just been made. */
export function showAll(): void {
  sent = [];
  show();
}

export function seek(to: number): void {
  seconds.value = Math.min(Math.max(0, to), length.value);
}

export function play(): void {
  if (seconds.value >= length.value) seek(0);
  isPlaying.value = true;
  lastTime = performance.now();
  frameRequest = requestAnimationFrame(step);
}

export function pause(): void {
  isPlaying.value = false;
  cancelAnimationFrame(frameRequest);
}

function step(now: number): void {
  const passed = Math.min(MAX_STEP_SECONDS, Math.max(0, now - lastTime) / 1000);
  lastTime = now;
  seek(seconds.value + passed * rate.value);
  if (seconds.value >= length.value) return pause();
  frameRequest = requestAnimationFrame(step);
}

/** Sends the world what differs from what it has. */
function show(): void {
  const now = recording.value;
  if (now === null) return;
  const isKey = sent.length === 0;
  const frames = now.tracks.flatMap((track, frame) => {
    const place = placeAt(track, tick.value);
    if (place < 0 || place === sent[frame]) return [];
    sent[frame] = place;
    return [{ frame, pose: poseAt(track, place) }];
  });
  const poses = { scene: now.description.scene.scene, tick: tick.value, ack: 0, isKey, frames };
  if (isKey || frames.length > 0) poseListeners.forEach((listener) => listener(poses));
}

effect(show);

effect(() => {
  const before = (recording.value?.description.changes ?? []).filter((change) => change.tick <= tick.value);
  const looks = before.flatMap((change) => (change.looks ? [change.looks] : [])).at(-1);
  const gone = before.flatMap((change) => (change.gone ? [change.gone] : [])).at(-1) ?? [];
  if (looks !== undefined && looks !== variants.peek()) variants.value = looks;
  if (state.peek() !== null && state.peek()!.gone !== gone) state.value = stateOf(gone);
});

/** The state of a studio that shows a recording, as far as the world shows it. */
function stateOf(gone: string[]): StateMessage {
  const hand: Hand = { object: null, plane: 0 };
  return {
    t: "state",
    tick: 0,
    mode: "playback",
    allowed: { requests: {}, commands: {} },
    paused: false,
    speed: 1,
    hands: { left: hand, right: hand, both: hand, any: hand },
    uses: {},
    still: true,
    recording: null,
    playback: null,
    restoring: null,
    failure: null,
    controls: {},
    gone,
    fallen: [],
    attention: {},
    robot: null,
    brain: { name: "", status: "none", message: "", claim: null, file: "", line: 0 },
    snap: [],
    eye: null,
    markers: [],
  };
}
