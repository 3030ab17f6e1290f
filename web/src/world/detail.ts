import { fps, isLowDetail } from "./signals";

/** Pictures that take longer than this, for so many on end, are too slow [ms]. */
const SLOW_MS = 32;
const MOST_SLOW = 45;
/** As slow as this even with low detail, things that move are drawn with fewer pixels [ms]. */
const VERY_SLOW_MS = 45;
/** If no picture was requested for this time after the last one, nothing moved in between [ms]. */
const PAUSE_MS = 80;
/** Time between the last motion and the sharp picture [ms]. */
const STILL_MS = 250;
const SHARE = 0.08;

/** Watches how long pictures take, and gives up detail where that is too long. */
export class DetailController {
  private mode: "auto" | "low" | "high" = "auto";
  private slow = 0;
  private last = 0;
  /** Between pictures of something that moves, the mean of late [ms]. */
  private interval = 0;
  private isVerySlow = false;
  private stillness: ReturnType<typeof setTimeout> | undefined;

  /** @param setCoarse called with false once nothing moves */
  constructor(
    private readonly setLow: (isLow: boolean) => void,
    private readonly setCoarse: (isCoarse: boolean) => void,
  ) {}

  setMode(mode: "auto" | "low" | "high"): void {
    this.mode = mode;
    this.slow = 0;
    if (mode !== "auto") this.become(mode === "low");
  }

  dispose(): void {
    clearTimeout(this.stillness);
  }

  /** A picture is about to be drawn that was asked for at `asked` [ms]. */
  note(asked: number, now: number): void {
    const interval = now - this.last;
    const waited = now - Math.max(asked, this.last);
    const hasPaused = asked - this.last > PAUSE_MS;
    this.last = now;
    if (hasPaused) return;
    this.interval = this.interval === 0 ? interval : this.interval + SHARE * (interval - this.interval);
    fps.value = Math.round(1000 / this.interval);
    this.slow = waited > SLOW_MS ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.mode === "auto" && this.slow >= MOST_SLOW && !isLowDetail.value) this.become(true);
    if (isLowDetail.value) this.drawMotionQuickly();
  }

  private become(isLow: boolean): void {
    this.slow = 0;
    this.interval = 0;
    this.isVerySlow = false;
    isLowDetail.value = isLow;
    this.setLow(isLow);
  }

  private drawMotionQuickly(): void {
    this.isVerySlow ||= this.slow > MOST_SLOW / 4 && this.interval > VERY_SLOW_MS;
    if (!this.isVerySlow) return;
    this.setCoarse(true);
    clearTimeout(this.stillness);
    this.stillness = setTimeout(() => this.setCoarse(false), STILL_MS);
  }
}
