// What a push is: its strength and direction from how somebody drags, and the message that asks for it. Passive.
import type { Turn } from "./description.ts";

export interface PushBounds {
  least: number; // N
  most: number;
  usual: number; // of who only taps
  shortest: number; // s
  longest: number;
}
export type Flat = readonly [x: number, y: number];

export const push_s = 0.1;
const tapAtMost_px = 6;
const perPixel_N = 1;

// About the vertical, of what has this attitude.
export function heading_rad([x, y, z, w]: Readonly<Turn>): number {
  return Math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
}

function strength(wanted_N: number, { least, most }: PushBounds): number {
  return Math.min(Math.max(wanted_N, least), most);
}

// [N], level. `away`: of length 1, level, where the camera looks. To the right pushes to the right, upwards pushes away; who only
// taps pushes away, with `tapped_N`.
export function forceOfDrag(right_px: number, up_px: number, away: Flat, tapped_N: number, bounds: PushBounds): Flat {
  const length_px = Math.hypot(right_px, up_px);
  const tapped = length_px <= tapAtMost_px;
  const size_N = strength(tapped ? tapped_N : length_px * perPixel_N, bounds);
  const [right, ahead] = tapped ? [0, 1] : [right_px / length_px, up_px / length_px];
  return [size_N * (ahead * away[0] + right * away[1]), size_N * (ahead * away[1] - right * away[0])];
}

// The force of the picture, as the robot that looks so has it: x ahead, y to the left.
export function inHeading([x, y]: Flat, robotHeading_rad: number): Flat {
  const [cos, sin] = [Math.cos(robotHeading_rad), Math.sin(robotHeading_rad)];
  return [cos * x + sin * y, cos * y - sin * x];
}

export function sizeOf([x, y]: Flat): number {
  return Math.hypot(x, y);
}

// Arguments of /simulation/push. The picture's world is where odometry has it, the simulator's is another: the robot's heading is common
// to both.
export function pushRequest(link: string, [ahead, left]: Flat): Record<string, unknown> {
  return { link, force: { x: ahead, y: left, z: 0 }, duration: push_s, frame: "heading" };
}
