import { computed, effect, signal } from "@preact/signals";
import type { Command } from "./commands";
import { StudioConnection } from "./connection";
import type {
  AnswerTo,
  ClientsMessage,
  ConsoleLine,
  EventMessage,
  EyeView,
  FieldsOf,
  HandName,
  Job,
  OffersMessage,
  Poses,
  SceneMessage,
  StateMessage,
  Update,
  Wanted,
} from "./protocol";
import { texts } from "./texts";

/** What the page knows: the program's state as last received, and what only this page's user chose. */
export const scene = signal<SceneMessage | null>(null);
export const variants = signal<number[]>([]);
export const state = signal<StateMessage | null>(null);
export const clients = signal<ClientsMessage | null>(null);
export const isConnected = signal(false);
/** What a program that is no studio carries out; null: everything. */
export const offers = signal<OffersMessage | null>(null);
/** Where the program's meshes are on the server. */
export const programFolder = signal("/");
export const eyeView = signal<EyeView | null>(null);
export const consoleLines = signal<ConsoleLine[]>([]);
export const lastScore = signal<Record<string, unknown> | null>(null);
export const progress = signal<{ what: string; done: number; total: number } | null>(null);
/** The long work of the program, oldest first. */
export const jobs = signal<Job[]>([]);
/** Messages shown for a moment. */
export const notices = signal<{ id: number; text: string; isError: boolean }[]>([]);
/** Who want control from us, and were not answered. */
export const controlWantedBy = signal<number[]>([]);
/** How often recordings came, went or got other titles. */
export const numLibraryUpdates = signal(0);

/** The hand that the mouse is. */
export const currentHand = signal<HandName>("any");
export const isController = computed(
  () => clients.value !== null && clients.value.controller === clients.value.you,
);
effect(() => {
  const waiting = controlWantedBy.value.filter((by) => isController.value && clients.value?.clients.includes(by));
  if (waiting.length < controlWantedBy.value.length) controlWantedBy.value = waiting;
});
export const heldObject = computed(() => state.value?.hands[currentHand.value].object ?? null);

const MAX_CONSOLE_LINES = 500;
const NOTICE_MS = 4000;
let numNotices = 0;

export function notify(text: string, isError = false): void {
  const id = ++numNotices;
  notices.value = [...notices.value, { id, text, isError }];
  setTimeout(() => (notices.value = notices.value.filter((notice) => notice.id !== id)), NOTICE_MS);
}

/** Who wants to hear of poses and events at once: the world. */
export const poseListeners = new Set<(poses: Poses) => void>();
export const eventListeners = new Set<(event: EventMessage) => void>();

function onUpdate(update: Update): void {
  switch (update.t) {
    case "scene":
      scene.value = update;
      variants.value = update.looks;
      break;
    case "offers":
      offers.value = update;
      break;
    case "looks":
      variants.value = update.looks;
      break;
    case "state":
      state.value = update;
      break;
    case "clients":
      clients.value = update;
      break;
    case "event":
      for (const listener of eventListeners) listener(update);
      // What contact and tools do without a command would otherwise go unnoticed.
      if (update.words !== undefined) notify(update.words);
      // A thin string that parts is hardly seen.
      else if (update.kind === "used" && update.state === "cut") notify(texts.toolHint.hasCut(update.by ?? "", update.part ?? ""));
      break;
    case "console":
      consoleLines.value = [...(update.all ? [] : consoleLines.value), ...update.lines].slice(-MAX_CONSOLE_LINES);
      break;
    case "score":
      lastScore.value = update.result;
      break;
    case "progress":
      progress.value = update.done < update.total ? update : null;
      break;
    case "control_wanted":
      controlWantedBy.value = [...controlWantedBy.value.filter((by) => by !== update.by), update.by];
      break;
    case "control_kept":
      notify(texts.people.kept(update.by), true);
      break;
    case "library":
      numLibraryUpdates.value += 1;
      break;
    case "jobs":
      jobs.value = update.jobs;
      break;
    case "error":
      notify(update.error, true);
      break;
  }
}

let connection: StudioConnection | null = null;

/** @param folder of the program's addresses on the server, with a slash at both ends */
export function connect(folder = "/"): void {
  programFolder.value = folder;
  connection = new StudioConnection(
    {
      onUpdate,
      onPoses: (poses) => poseListeners.forEach((listener) => listener(poses)),
      onEyeView: (view) => (eyeView.value = view),
      onConnected: (yes) => (isConnected.value = yes),
    },
    folder,
  );
}

/** Ends the connection, and forgets what the program said. */
export function disconnect(): void {
  connection?.close();
  connection = null;
  isConnected.value = false;
  for (const known of [scene, state, clients, offers]) known.value = null;
  variants.value = [];
}

/** Asks the program; rejects with Refused or when the connection is lost. */
export function request<What extends Wanted>(what: What, ...fields: FieldsOf<What>): Promise<AnswerTo<What>> {
  if (connection === null) return Promise.reject(new Error(texts.connection.none));
  return connection.request(what, ...fields);
}

/** Asks for what takes its time, and may be given up before it is answered: then it fails. */
export function cancelableRequest<What extends Wanted>(
  what: What,
  ...fields: FieldsOf<What>
): { answer: Promise<AnswerTo<What>>; cancel: () => void } {
  let isAnswered = false;
  const answer = request(what, ...fields).finally(() => (isAnswered = true));
  const seq = lastSeq();
  const cancel = () => {
    if (!isAnswered) request("cancel", { request: seq }).catch(() => undefined);
  };
  return { answer, cancel };
}

/** Asks, and shows people why not if not. */
export async function ask<What extends Wanted>(what: What, ...fields: FieldsOf<What>): Promise<AnswerTo<What> | null> {
  try {
    return await request(what, ...fields);
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), true);
    return null;
  }
}

/** A command of docs/commands.md. */
export function command(wanted: Command): Promise<AnswerTo<"command"> | null> {
  return ask("command", { command: wanted });
}

/** Number of requests without an answer yet. */
export function numWaiting(): number {
  return connection?.numWaiting ?? 0;
}

export function lastSeq(): number {
  return connection?.lastSeq ?? 0;
}
