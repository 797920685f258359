// How old what is shown is, and whether the connection lives. Passive: told the time, in ms.
import type { ViewFrame } from "./view_decoder.ts";

export const oldAfter_ms = 300;
export const lostAfter_ms = 1000;

// live: the newest is young. old: connected, but what is shown is not of now. lost: nothing comes any more.
export type LinkState = "live" | "old" | "lost";

export interface Loss {
  frames: number; // that never came, or were left out since the page was slow
  outages: number;
  longest_ms: number;
}

export class Freshness {
  private frame: ViewFrame | undefined;
  private came_ms = -Infinity;
  private connected = false;
  private outageSince_ms: number | undefined;
  // How fast the robot's time passes, in times real time: a simulated one may be slow, or rest (0), and then nothing of it gets old.
  pace = 1;
  readonly loss: Loss = { frames: 0, outages: 0, longest_ms: 0 };

  take(frame: ViewFrame, now_ms: number): void {
    this.endOutage(now_ms);
    const skipped = this.frame ? (frame.frame[0] ?? 0) - (this.frame.frame[0] ?? 0) - 1 : 0;
    if (this.connected && skipped > 0) this.loss.frames += skipped;
    this.connected = true;
    this.frame = frame;
    this.came_ms = now_ms;
  }

  // The socket has ended.
  disconnected(now_ms: number): void {
    if (this.connected) this.beginOutage(now_ms);
    this.connected = false;
  }

  get newest(): ViewFrame | undefined {
    return this.frame;
  }

  // Of one part of the frame (row `age`), or of all that a picture needs: with the way from the robot to here.
  age_ms(part: number, now_ms: number): number {
    if (!this.frame) return Infinity;
    if (this.rests) return this.sinceCame_ms(now_ms);
    const atRobot_ms = (this.frame.age[part] ?? NaN) * 1000;
    const way_ms = ((this.frame.round_trip[0] ?? NaN) * 1000) / 2;
    if (Number.isNaN(atRobot_ms)) return Infinity;
    return atRobot_ms * Math.min(this.pace, 1) + (Number.isNaN(way_ms) ? 0 : way_ms) + this.sinceCame_ms(now_ms);
  }

  get rests(): boolean {
    return this.pace === 0;
  }

  sinceCame_ms(now_ms: number): number {
    return now_ms - this.came_ms;
  }

  // Joints, pose, message controller and clock: the plan may rest.
  pictureAge_ms(now_ms: number): number {
    return Math.max(...[0, 1, 2, 4].map((part) => this.age_ms(part, now_ms)));
  }

  state(now_ms: number): LinkState {
    if (!this.connected || this.sinceCame_ms(now_ms) > lostAfter_ms) return "lost";
    return this.pictureAge_ms(now_ms) > oldAfter_ms ? "old" : "live";
  }

  private beginOutage(now_ms: number): void {
    this.outageSince_ms ??= Math.min(now_ms, Math.max(this.came_ms, 0));
  }

  private endOutage(now_ms: number): void {
    if (this.frame && this.sinceCame_ms(now_ms) > lostAfter_ms) this.beginOutage(now_ms);
    if (this.outageSince_ms === undefined) return;
    this.loss.outages += 1;
    this.loss.longest_ms = Math.max(this.loss.longest_ms, now_ms - this.outageSince_ms);
    this.outageSince_ms = undefined;
  }
}

export function ageText(age_ms: number): string {
  if (!Number.isFinite(age_ms)) return "never";
  if (age_ms < 1000) return `${Math.max(Math.round(age_ms), 0)} ms`;
  return age_ms < 60_000 ? `${(age_ms / 1000).toFixed(1)} s` : `${Math.round(age_ms / 60_000)} min`;
}
