// Who commands: takes the command for this page, keeps it alive, gives it back.
import { Refused, type Message, type Outcome } from "./rosbridge.ts";

export interface Caller {
  order(service: string, args?: Message): Promise<Outcome>;
}

export class Command {
  readonly name: string;
  private lease: string | undefined;
  private period_ms = 0;
  private kept_ms = 0;
  private asking: Promise<void> | undefined;
  onChange: () => void = () => {};

  constructor(
    private readonly robot: Caller,
    name: string,
  ) {
    this.name = name;
  }

  get mine(): boolean {
    return this.lease !== undefined;
  }

  // Throws when it is refused, or nobody answers.
  take(): Promise<void> {
    this.asking ??= this.ask().finally(() => (this.asking = undefined));
    return this.asking;
  }

  async giveBack(): Promise<void> {
    const lease = this.lease;
    this.lost();
    if (lease !== undefined) await this.robot.order("/command/release", { lease });
  }

  // For one order that wants the command: takes it, if it is not this page's already, and gives it back then.
  async during<Answer>(order: () => Promise<Answer>): Promise<Answer> {
    if (this.mine) return order();
    await this.take();
    try {
      return await order();
    } finally {
      await this.giveBack();
    }
  }

  // The connection has ended, or somebody else stopped the robot: the lease is worth nothing any more.
  lost(): void {
    if (this.lease === undefined) return;
    this.lease = undefined;
    this.onChange();
  }

  // To be called often: keeps the lease alive. Throws when it is no more.
  async keep(now_ms: number): Promise<void> {
    const lease = this.lease;
    if (lease === undefined || now_ms - this.kept_ms < this.period_ms) return;
    this.kept_ms = now_ms;
    try {
      await this.robot.order("/command/keep_alive", { lease });
    } catch (error) {
      if (this.lease === lease && error instanceof Refused) this.lost();
      throw error;
    }
  }

  private async ask(): Promise<void> {
    const outcome = await this.robot.order("/command/acquire", { name: this.name });
    this.lease = String(outcome["lease"]);
    this.period_ms = (Number(outcome["keep_alive_period"]) * 1000) / 2;
    this.kept_ms = performance.now();
    this.onChange();
  }
}
