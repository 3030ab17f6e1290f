import { signal } from "@preact/signals";
import type { PageMessage, ServerMessage, StepMessage } from "./messages";

const RECONNECT_MS = 1000;

/** The secret in this page's address; empty without one. */
export const token = /^\/p\/([^/]+)$/.exec(location.pathname)?.[1] ?? "";
/** Where the session of a trial is on this server. */
export const sessionFolder = `/p/${token}/session/`;

export const step = signal<StepMessage | null>(null);
/** When the time of the running trial is over, by performance.now() [ms]; null while none runs. */
export const deadline = signal<number | null>(null);
export const isConnected = signal(false);
/** What keeps this page from going on. */
export const obstacle = signal<"unknown" | "replaced" | null>(token === "" ? "unknown" : null);
/** Why the last message was refused; empty if it was not. */
export const refusal = signal("");

let socket: WebSocket | null = null;

export function connect(): void {
  if (obstacle.value !== null) return;
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  socket = new WebSocket(`${scheme}://${location.host}/ws`);
  socket.onopen = () => {
    isConnected.value = true;
    send({ do: "hello", token });
  };
  socket.onmessage = ({ data }: MessageEvent<string>) => receive(JSON.parse(data) as ServerMessage);
  socket.onclose = () => {
    isConnected.value = false;
    setTimeout(connect, RECONNECT_MS);
  };
}

/** Sends, if the server is there; otherwise the page shows that it is not, and the step comes again. */
export function send(message: PageMessage): void {
  refusal.value = "";
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
}

/** The address of a picture or film of the study. */
export function fileOf(path: string): string {
  return `/p/${token}/file/${path.split("/").map(encodeURIComponent).join("/")}`;
}

function receive(message: ServerMessage): void {
  switch (message.t) {
    case "step":
      deadline.value = null;
      step.value = message;
      break;
    case "session":
      deadline.value = performance.now() + 1000 * message.left;
      break;
    case "error":
      refusal.value = message.error;
      break;
    default:
      obstacle.value = message.t;
  }
}
