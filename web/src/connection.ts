import { parse } from "./said";
import { texts } from "./texts";
import { decodeBinary, VERSION, type AnswerTo, type EyeView, type FieldsOf, type TextMessage, type Poses, type Reply, type Update, type Wanted } from "./protocol";

const RECONNECT_MS = 500;

export interface Listener {
  onUpdate(update: Update): void;
  onPoses(poses: Poses): void;
  onEyeView(view: EyeView): void;
  onConnected(isConnected: boolean): void;
}

/** The program said no; `reply` has its reasons. */
export class Refused extends Error {
  constructor(readonly reply: Reply) {
    super(reply.error);
  }
}

/** The WebSocket to the program. Comes back by itself when it breaks: the program holds all truth. */
export class StudioConnection {
  private socket: WebSocket | null = null;
  private seq = 0;
  private readonly waiting = new Map<number, { resolve(r: Reply): void; reject(e: Error): void }>();

  private isClosed = false;

  /** @param folder of the program's addresses on the server, with a slash at both ends */
  constructor(
    private readonly listener: Listener,
    private readonly folder: string,
  ) {
    this.connect();
  }

  /** Ends the connection for good. */
  close(): void {
    this.isClosed = true;
    this.socket?.close();
  }

  /** Resolves with the answer; rejects with Refused, or when the connection is lost. */
  request<What extends Wanted>(what: What, ...[fields]: FieldsOf<What>): Promise<AnswerTo<What>> {
    const seq = ++this.seq;
    return new Promise((resolve: (reply: AnswerTo<What>) => void, reject) => {
      if (this.socket?.readyState !== WebSocket.OPEN) {
        reject(new Error(texts.connection.none));
        return;
      }
      this.waiting.set(seq, { resolve: (reply) => resolve(reply as AnswerTo<What>), reject });
      this.socket.send(JSON.stringify({ ...fields, seq, do: what }));
    });
  }

  /** Number of requests without an answer yet. */
  get numWaiting(): number {
    return this.waiting.size;
  }

  /** The number of the last request: poses acknowledge it. */
  get lastSeq(): number {
    return this.seq;
  }

  private connect(): void {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}${this.folder}ws${location.search}`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.request("hello", { version: VERSION }).then(
        () => this.listener.onConnected(true),
        () => socket.close(),
      );
    };
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => this.receive(data);
    socket.onclose = () => {
      this.listener.onConnected(false);
      for (const { reject } of this.waiting.values()) reject(new Error(texts.connection.wasLost));
      this.waiting.clear();
      if (!this.isClosed) setTimeout(() => this.connect(), RECONNECT_MS);
    };
    this.socket = socket;
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data !== "string") {
      const message = decodeBinary(data);
      if (message === null) return;
      if ("png" in message) this.listener.onEyeView(message);
      else this.listener.onPoses(message);
      return;
    }
    const message = parse(data) as TextMessage;
    if (message.t !== "reply") {
      this.listener.onUpdate(message);
      return;
    }
    const request = this.waiting.get(message.seq);
    this.waiting.delete(message.seq);
    if (message.ok) request?.resolve(message);
    else request?.reject(new Refused(message));
  }
}
