// Goes to the instant that a person points at. While the simulator is on its way to one, only the newest wish is kept: dragging over
// the time line asks for no more than can be answered. Passive: told the time, in ms.

const near_s = 0.0015;
const patience_ms = 500;

export class Seeker {
  private wish_s: number | undefined;
  private goes = false;
  private arrived_ms = 0;
  // Where it is going, and where it is until the simulator's state says so, too; undefined: nowhere.
  target_s: number | undefined;

  constructor(
    private readonly seek: (time_s: number) => Promise<void>,
    private readonly failed: (error: Error) => void,
    private readonly now_ms: () => number = () => performance.now(),
  ) {}

  get isGoing(): boolean {
    return this.goes;
  }

  async to(time_s: number): Promise<void> {
    this.wish_s = time_s;
    this.target_s = time_s;
    if (this.goes) return;
    this.goes = true;
    try {
      while (this.wish_s !== undefined) {
        const wish_s: number = this.wish_s;
        this.wish_s = undefined;
        await this.seek(wish_s);
      }
    } catch (error) {
      this.wish_s = this.target_s = undefined;
      this.failed(error as Error);
    } finally {
      this.goes = false;
      this.arrived_ms = this.now_ms();
    }
  }

  // The simulator's state has this time: what was told before it arrived is of no interest any more.
  told(time_s: number): void {
    if (this.goes || this.target_s === undefined) return;
    if (Math.abs(time_s - this.target_s) < near_s || this.now_ms() - this.arrived_ms > patience_ms) this.target_s = undefined;
  }
}
