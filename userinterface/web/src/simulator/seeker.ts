// Goes to the instant that a person points at. While the simulator is on its way to one, only the newest wish is kept: dragging over
// the time line asks for no more than can be answered.

export class Seeker {
  private wish_s: number | undefined;
  private goes = false;

  constructor(
    private readonly seek: (time_s: number) => Promise<void>,
    private readonly failed: (error: Error) => void,
  ) {}

  // Where it is going; undefined: it has arrived.
  target_s: number | undefined;

  async to(time_s: number): Promise<void> {
    this.wish_s = time_s;
    this.target_s = time_s;
    if (this.goes) return;
    this.goes = true;
    try {
      while (this.wish_s !== undefined) {
        const now_s: number = this.wish_s;
        this.wish_s = undefined;
        await this.seek(now_s);
      }
    } catch (error) {
      this.wish_s = undefined;
      this.failed(error as Error);
    } finally {
      this.goes = false;
      this.target_s = undefined;
    }
  }
}
