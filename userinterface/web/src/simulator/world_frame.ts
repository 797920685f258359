// Where the simulator's world lies in the picture, whose frame is the robot's odometry. Odometry drifts, so the world is moved
// under it: slowly, so that nobody sees it jump. Passive: told the time.
import type { Odometry } from "./simulation_state.ts";

const settles_s = 0.25;
const jump_m = 0.25, jump_rad = 0.35; // more than odometry drifts in a tenth of a second

export interface Flat3 {
  x: number;
  y: number;
  z: number;
}
export const wrap_rad = (angle: number) => Math.atan2(Math.sin(angle), Math.cos(angle));

// Of the world in the frame of which `odometry` is the pose.
export function inverseOf({ x, y, z, yaw }: Odometry): Odometry {
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  return { x: -(cos * x + sin * y), y: -(cos * y - sin * x), z: -z, yaw: -yaw };
}

// A place given in the frame that has this pose.
export function outOf({ x, y, z, yaw }: Odometry, place: Flat3): Flat3 {
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  return { x: x + cos * place.x - sin * place.y, y: y + sin * place.x + cos * place.y, z: z + place.z };
}

export class WorldFrame {
  private wanted: Odometry | undefined;
  private shown: Odometry | undefined;
  private run: number | undefined;

  get isKnown(): boolean {
    return this.shown !== undefined;
  }

  // `run`: another one: the robot was put elsewhere, and with it the frame. Gives whether it lies elsewhere at once.
  take(odometry: Odometry | undefined, run: number): boolean {
    if (!odometry) return false;
    const { shown } = this;
    const jumps = !shown || run !== this.run || Math.hypot(odometry.x - shown.x, odometry.y - shown.y, odometry.z - shown.z) > jump_m ||
      Math.abs(wrap_rad(odometry.yaw - shown.yaw)) > jump_rad;
    this.wanted = odometry;
    this.run = run;
    if (jumps) this.shown = { ...odometry };
    return jumps;
  }

  // Gives the pose of odometry in the world that is to be drawn; undefined: nothing has been told yet.
  after(passed_s: number): Odometry | undefined {
    const { wanted, shown } = this;
    if (!wanted || !shown) return undefined;
    const share = 1 - Math.exp(-Math.max(passed_s, 0) / settles_s);
    shown.x += share * (wanted.x - shown.x);
    shown.y += share * (wanted.y - shown.y);
    shown.z += share * (wanted.z - shown.z);
    shown.yaw += share * wrap_rad(wanted.yaw - shown.yaw);
    return shown;
  }
}
