// Where the picture has had the robot's base, for a second or so: held against where the simulator says that it truly was at that instant, it
// tells where the picture's frame lies in the simulator's world. That frame is the user interface's own odometry, which begins anew with each
// link to the robot, so nobody else can tell. Passive.
import type { Placed, Turn } from "../description.ts";
import { heading_rad } from "../push.ts";
import type { ViewFrame } from "../view_decoder.ts";
import type { Odometry, SimulationState } from "./simulation_state.ts";
import { wrap_rad } from "./world_frame.ts";

const kept = 60; // frames, thirty a second
const late_s = 0.05; // of a state that is newer than the newest frame, in the robot's time at speed 1
const leastUpright = 0.5; // cosine of the tilt: beyond it a heading says little

const upright = ([x, y]: Readonly<Turn>) => 1 - 2 * (x * x + y * y);

// Of the frame in which the base is at `seen`, while it truly is at `base`.
export function originOf(base: Odometry, seen: Odometry): Odometry {
  const yaw = wrap_rad(base.yaw - seen.yaw);
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  return { x: base.x - (cos * seen.x - sin * seen.y), y: base.y - (sin * seen.x + cos * seen.y), z: base.z - seen.z, yaw };
}

export class ViewTrail {
  private trail: { time_s: number; seen: Odometry }[] = [];

  take({ robot_time, base_place, base_height, base_turn }: Pick<ViewFrame, "robot_time" | "base_place" | "base_height" | "base_turn">): void {
    const [time_s = NaN, x = NaN, y = NaN, z = NaN] = [robot_time[0], ...base_place, base_height[0]];
    const turn = base_turn as Turn;
    if (!Number.isFinite(time_s + x + y + z + (turn[3] ?? NaN)) || upright(turn) < leastUpright) return;
    if (time_s < (this.trail.at(-1)?.time_s ?? 0)) this.trail = []; // its time has gone back
    if (time_s === this.trail.at(-1)?.time_s) this.trail.pop();
    this.trail.push({ time_s, seen: { x, y, z, yaw: heading_rad(turn) } });
    if (this.trail.length > kept) this.trail.shift();
  }

  // The robot was put to another instant.
  forget(): void {
    this.trail = [];
  }

  // Where the picture's frame lies in the world; undefined: nothing that is known tells it.
  originFor({ time_s, base, state, speed }: Pick<SimulationState, "time_s" | "base" | "state" | "speed">): Odometry | undefined {
    const seen = base && upright(base.turn) >= leastUpright ? this.at(time_s, state === "playing" ? late_s * Math.max(speed, 1) : late_s) : undefined;
    return base && seen && originOf(flat(base), seen);
  }

  private at(time_s: number, most_s: number): Odometry | undefined {
    const after = this.trail.findIndex((entry) => entry.time_s >= time_s);
    const [a, b] = [this.trail[after < 0 ? this.trail.length - 1 : Math.max(after - 1, 0)], this.trail[after]];
    if (!b) return a && time_s - a.time_s <= most_s ? a.seen : undefined;
    if (!a || b.time_s <= a.time_s) return b.time_s - time_s <= most_s ? b.seen : undefined;
    const share = (time_s - a.time_s) / (b.time_s - a.time_s);
    const between = (name: "x" | "y" | "z") => a.seen[name] + share * (b.seen[name] - a.seen[name]);
    return { x: between("x"), y: between("y"), z: between("z"), yaw: a.seen.yaw + share * wrap_rad(b.seen.yaw - a.seen.yaw) };
  }
}

function flat({ place: [x, y, z], turn }: Placed): Odometry {
  return { x, y, z, yaw: heading_rad(turn) };
}
