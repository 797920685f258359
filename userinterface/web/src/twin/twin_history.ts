// The last minute of what is compared, for plots. Passive: told the time, in s of the page's clock.
import { wrap_rad } from "../simulator/world_frame.ts";
import { unitOf } from "./agreement.ts";
import type { Channel } from "./twin_state.ts";

export const kept_s = 60;
const gap_s = 0.35; // nothing is known in between, and no curve is drawn through it

type Column = (number | null)[];
export interface ChannelCurves {
  times_s: number[]; // before now: negative
  measured: Column; // in the unit that is shown
  simulated: Column;
  difference: Column; // measured less simulated
}

export class TwinHistory {
  private names = "";
  private times_s: number[] = [];
  private values: { measured: Column; simulated: Column; unit: string }[] = [];

  // `channels`: empty: nothing is known now.
  add(channels: readonly Channel[], now_s: number): void {
    const names = channels.map(({ name }) => name).join();
    if (channels.length > 0 && names !== this.names) this.begin(channels, names);
    const last_s = this.times_s.at(-1);
    if (last_s !== undefined && now_s <= last_s) return;
    if (channels.length === 0) return;
    if (last_s !== undefined && now_s - last_s > gap_s) this.push((last_s + now_s) / 2, []);
    this.push(now_s, channels);
    this.forget(now_s - kept_s);
  }

  of(channel: number, now_s: number): ChannelCurves {
    const { measured = [], simulated = [], unit = "" } = this.values[channel] ?? {};
    const { times } = unitOf(unit);
    const shown = (column: Column) => column.map((value) => (value === null ? null : value * times));
    const difference = measured.map((value, index) => {
      const other = simulated[index] ?? null;
      return value === null || other === null ? null : (unit === "rad" ? wrap_rad(value - other) : value - other) * times;
    });
    return { times_s: this.times_s.map((at_s) => at_s - now_s), measured: shown(measured), simulated: shown(simulated), difference };
  }

  // Other things are compared.
  private begin(channels: readonly Channel[], names: string): void {
    this.names = names;
    this.times_s = [];
    this.values = channels.map(({ unit }) => ({ measured: [], simulated: [], unit }));
  }

  private push(at_s: number, channels: readonly Channel[]): void {
    const column = (value: number | undefined) => (value === undefined || Number.isNaN(value) ? null : value);
    this.times_s.push(at_s);
    for (const [index, { measured, simulated }] of this.values.entries()) {
      measured.push(column(channels[index]?.measured));
      simulated.push(column(channels[index]?.simulated));
    }
  }

  private forget(before_s: number): void {
    const first = this.times_s.findIndex((at_s) => at_s >= before_s);
    if (first <= 0) return;
    for (const column of [this.times_s, ...this.values.flatMap(({ measured, simulated }) => [measured, simulated])]) column.splice(0, first);
  }
}
