import { fps, isLowDetail } from "./signals";

/** Pictures that take longer than this, for so many on end, are too slow [ms]. */
const SLOW_MS = 32;
const MOST_SLOW = 45;
/** Two pictures farther apart than this do not belong together: nothing moved in between [ms]. */
const PAUSE_MS = 400;
const SHARE = 0.08;

/** Watches how long pictures take, and gives up detail where that is too long. */
export class DetailKeeper {
  private mode: "auto" | "low" | "high" = "auto";
  private slow = 0;
  private last = 0;
  private interval = 0;

  constructor(private readonly setLow: (isLow: boolean) => void) {}

  setMode(mode: "auto" | "low" | "high"): void {
    this.mode = mode;
    this.slow = 0;
    if (mode !== "auto") this.become(mode === "low");
  }

  /** A picture was drawn now that was asked for at `asked` [ms]. */
  note(asked: number, now: number): void {
    const interval = now - this.last;
    const waited = now - Math.max(asked, this.last);
    this.last = now;
    if (interval > PAUSE_MS) return;
    this.interval = this.interval === 0 ? interval : this.interval + SHARE * (interval - this.interval);
    fps.value = Math.round(1000 / this.interval);
    this.slow = waited > SLOW_MS ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.mode === "auto" && this.slow >= MOST_SLOW && !isLowDetail.value) this.become(true);
  }

  private become(isLow: boolean): void {
    this.slow = 0;
    isLowDetail.value = isLow;
    this.setLow(isLow);
  }
}
