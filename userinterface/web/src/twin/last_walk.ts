// The last walk that was driven from this page, as one velocity for so long: what may be sent to the robot there. Passive: told the time, in ms.
import { isStandstill, type Velocity } from "../drive.ts";

const least_s = 1;
const hundredths = (value: number) => Math.round(100 * value) / 100;

export interface Walk extends Velocity {
  duration_s: number;
}

export class LastWalk {
  private began_ms: number | undefined;
  private since_ms = 0;
  private now: Velocity | undefined;
  private way = { forward: 0, left: 0, turn: 0 }; // that was asked for so far, m and rad
  private last: Walk | undefined;

  // What is asked for from now on.
  take(velocity: Velocity, now_ms: number): void {
    const { began_ms, now } = this;
    if (now) {
      const passed_s = (now_ms - this.since_ms) / 1000;
      this.way = { forward: this.way.forward + passed_s * now.forward, left: this.way.left + passed_s * now.left, turn: this.way.turn + passed_s * now.turn };
    }
    this.since_ms = now_ms;
    this.now = isStandstill(velocity) ? undefined : velocity;
    if (this.now && began_ms === undefined) {
      this.began_ms = now_ms;
      this.way = { forward: 0, left: 0, turn: 0 };
    } else if (!this.now && began_ms !== undefined) {
      this.end((now_ms - began_ms) / 1000);
    }
  }

  // undefined: none has ended yet.
  get walk(): Walk | undefined {
    return this.last;
  }

  private end(passed_s: number): void {
    this.began_ms = undefined;
    if (passed_s <= 0) return;
    const mean = { forward: hundredths(this.way.forward / passed_s), left: hundredths(this.way.left / passed_s), turn: hundredths(this.way.turn / passed_s) };
    if (!isStandstill(mean)) this.last = { ...mean, duration_s: Math.max(Math.round(10 * passed_s) / 10, least_s) };
  }
}
