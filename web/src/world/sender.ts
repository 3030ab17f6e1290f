import type { Command } from "../commands";
import { lastSeq, request } from "../studio";

const PAUSE_MS = 12;
const MOST_UNANSWERED = 8;

/** What to send now; null: nothing after all. */
type Wish = () => Command | null;

/**
 * Sends commands of a stream of wishes, of which only the newest matters: at once, but not more
 * often than pictures come, nor when a slow line has not answered yet. A refusal is not reported:
 * the next wish is on its way.
 */
export class Sender {
  private wish: Wish | null = null;
  private unanswered = 0;
  private sentAt = 0;
  private timer: ReturnType<typeof setTimeout> | null = null;

  /** @param onSent called with the number of each request */
  constructor(private readonly onSent: (seq: number) => void = () => {}) {}

  want(wish: Wish): void {
    this.wish = wish;
    this.sendWhenDue();
  }

  /** Whether every wish was sent and answered. */
  get isIdle(): boolean {
    return this.wish === null && this.unanswered === 0;
  }

  private sendWhenDue(): void {
    if (this.wish === null || this.unanswered >= MOST_UNANSWERED || this.timer !== null) return;
    const wait = this.sentAt + PAUSE_MS - performance.now();
    if (wait > 0) {
      this.timer = setTimeout(() => {
        this.timer = null;
        this.sendWhenDue();
      }, wait);
      return;
    }
    const command = this.wish();
    this.wish = null;
    if (command !== null) this.send(command);
  }

  private send(command: Command): void {
    this.sentAt = performance.now();
    ++this.unanswered;
    const answered = () => {
      --this.unanswered;
      this.sendWhenDue();
    };
    request("command", { command }).then(answered, answered);
    this.onSent(lastSeq());
  }
}
