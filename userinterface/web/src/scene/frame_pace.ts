// How often the picture is drawn, and how finely: as often as frames come, thirty times a second at most, and coarser where
// the computer does not keep up with that. Passive: told the time, in ms.

const least_ms = 30;
const window_ms = 2000;
const coarsest = 0.5;
const step = 0.8;
const windowsUntilFiner = 10;

export class FramePace {
  private last_ms = -Infinity;
  private readonly drawn_ms: number[] = [];
  private windowBegan_ms = -Infinity;
  private wished = 0;
  private drawn = 0;
  private goodWindows = 0;
  // Of the resolution that the screen has.
  fineness = 1;
  total = 0;

  isDue(now_ms: number): boolean {
    return now_ms - this.last_ms >= least_ms;
  }

  // There is something new to draw.
  wish(): void {
    this.wished += 1;
  }

  // True: the fineness has changed.
  drew(now_ms: number): boolean {
    this.last_ms = now_ms;
    this.drawn_ms.push(now_ms);
    while ((this.drawn_ms[0] ?? now_ms) < now_ms - 1000) this.drawn_ms.shift();
    this.drawn += 1;
    this.total += 1;
    if (now_ms - this.windowBegan_ms < window_ms) return false;
    const judged = this.windowBegan_ms > -Infinity && now_ms - this.windowBegan_ms < 2 * window_ms;
    const changed = judged && this.judge(this.drawn / Math.max(this.wished, 1), (this.wished * 1000) / (now_ms - this.windowBegan_ms));
    this.windowBegan_ms = now_ms;
    this.wished = this.drawn = 0;
    return changed;
  }

  // In the last second.
  get perSecond(): number {
    return this.drawn_ms.length;
  }

  private judge(share: number, wishesPerSecond: number): boolean {
    const before = this.fineness;
    this.goodWindows = share > 0.9 ? this.goodWindows + 1 : 0;
    if (share < 0.75 && wishesPerSecond > 20) this.fineness = Math.max(this.fineness * step, coarsest);
    if (this.goodWindows >= windowsUntilFiner) {
      this.goodWindows = 0;
      this.fineness = Math.min(this.fineness / step, 1);
    }
    return this.fineness !== before;
  }
}
