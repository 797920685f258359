// How often the picture is drawn: as often as frames come, but never more than thirty times a second.

const least_ms = 30;

export class FramePace {
  private last_ms = -Infinity;
  private readonly drawn_ms: number[] = [];

  isDue(now_ms: number): boolean {
    return now_ms - this.last_ms >= least_ms;
  }

  drew(now_ms: number): void {
    this.last_ms = now_ms;
    this.drawn_ms.push(now_ms);
    while ((this.drawn_ms[0] ?? now_ms) < now_ms - 1000) this.drawn_ms.shift();
  }

  // In the last second.
  get perSecond(): number {
    return this.drawn_ms.length;
  }
}
