// Where the robot there is drawn between two states, of which there are ten a second: on the straight way from where it is drawn to what was
// told last, in as long as it took to be told. So it is drawn a state late, and evenly. Passive: told the time, in ms.
import type { Placed, Triple, Turn } from "../description.ts";

const least_ms = 50, most_ms = 300;
const jump_m = 0.5; // further than a robot goes in a tenth of a second

export interface Pose {
  base: Placed;
  joints: readonly number[]; // rad
}

const mix = (a: readonly number[], b: readonly number[], share: number) => b.map((value, index) => {
  const from = a[index] ?? NaN;
  return Number.isFinite(from) ? from + share * (value - from) : value;
});

// The short way round.
function mixTurns(a: Turn, b: Turn, share: number): Turn {
  const sign = a.reduce((sum, value, index) => sum + value * b[index]!, 0) < 0 ? -1 : 1;
  const mixed = mix(a, b.map((value) => sign * value), share);
  const length = Math.hypot(...mixed);
  return (length > 1e-6 ? mixed.map((value) => value / length) : b) as Turn;
}

export class PoseFollower {
  private from: Pose | undefined;
  private to: Pose | undefined;
  private began_ms = 0;
  private takes_ms = 100;

  take(pose: Pose, now_ms: number): void {
    const drawn = this.at(now_ms);
    const jumps = !drawn || Math.hypot(...pose.base.place.map((value, axis) => value - drawn.base.place[axis]!)) > jump_m;
    if (!jumps) this.takes_ms = Math.min(Math.max(now_ms - this.began_ms, least_ms), most_ms);
    this.from = jumps ? pose : drawn;
    this.to = pose;
    this.began_ms = now_ms;
  }

  forget(): void {
    this.from = this.to = undefined;
  }

  // undefined: nothing is known.
  at(now_ms: number): Pose | undefined {
    const { from, to } = this;
    if (!from || !to) return undefined;
    const share = Math.min(Math.max((now_ms - this.began_ms) / this.takes_ms, 0), 1);
    if (share === 1) return to;
    return {
      base: { place: mix(from.base.place, to.base.place, share) as Triple, turn: mixTurns(from.base.turn, to.base.turn, share) },
      joints: mix(from.joints, to.joints, share),
    };
  }

  arrived(now_ms: number): boolean {
    return now_ms - this.began_ms >= this.takes_ms;
  }
}
