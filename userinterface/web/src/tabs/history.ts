// What the view showed in the last minutes, as plots want it.
import type { ViewFrame } from "../view_decoder.ts";

export interface Curve {
  name: string;
  value: (frame: ViewFrame) => number | undefined;
}

export const keptFrames = 30 * 120;
const gap_s = 0.3; // of the robot's time without a frame: nothing is known of it, and no curve is drawn through it

// Time [s] and one column a curve; of unknown values null.
export class History {
  private columns: (number | null)[][];

  constructor(private readonly curves: readonly Curve[]) {
    this.columns = Array.from({ length: curves.length + 1 }, () => []);
  }

  add(frame: ViewFrame): void {
    const time_s = frame.robot_time[0] ?? 0;
    const times = this.columns[0] ?? [];
    const last_s = times[times.length - 1];
    if (typeof last_s === "number" && time_s < last_s) this.columns.forEach((column) => (column.length = 0)); // the robot was started anew
    if (typeof last_s === "number" && time_s - last_s > gap_s) this.columns.forEach((column, index) => column.push(index === 0 ? (last_s + time_s) / 2 : null));
    times.push(time_s);
    for (const [index, { value }] of this.curves.entries()) {
      const number = value(frame);
      this.columns[index + 1]?.push(number === undefined || Number.isNaN(number) ? null : number);
    }
    if (times.length > keptFrames * 1.1) this.columns = this.columns.map((column) => column.slice(-keptFrames));
  }

  // Those curves alone, of the last `span_s`; copies.
  data(chosen: readonly number[], span_s: number): (number | null)[][] {
    const times = this.columns[0] as number[];
    const since_s = (times[times.length - 1] ?? 0) - span_s;
    const from = times.findIndex((time_s) => time_s >= since_s);
    return [0, ...chosen.map((index) => index + 1)].map((column) => (this.columns[column] ?? []).slice(Math.max(from, 0)));
  }
}
