// The robot's prepared motions, as it lists them, and their postures over time. Passive: told the time, in s.
import { withToken } from "./description.ts";

export interface MotionEntry {
  name: string;
  description?: string;
  duration?: number; // s
  start?: string; // posture: "stands", "lies on its front"
  postures?: string; // where they are
  refused?: string; // why there are none
}
// A foot: x, y, z, yaw of its sole. `support`: what stands: 0 left, 1 right, 2 both, 3 nothing.
export type FootPlace = [number, number, number, number];
export interface Posture {
  joints: number[];
  feet: [FootPlace, FootPlace];
  support: 0 | 1 | 2 | 3;
}
export interface MotionPostures {
  period: number; // s
  postures: Posture[];
}

async function fetchJson(path: string, token: string | undefined): Promise<unknown> {
  const answer = await fetch(path, withToken(token));
  if (!answer.ok) throw new Error(await answer.text());
  return answer.json();
}

export const loadMotions = (token: string | undefined) => fetchJson("motions.json", token) as Promise<MotionEntry[]>;
export const loadPostures = (path: string, token: string | undefined) => fetchJson(path, token) as Promise<MotionPostures>;

const pause_s = 0.8; // in the last posture, before it begins anew

// Of a preview that repeats itself.
export function timeInMotion(elapsed_s: number, { period, postures }: MotionPostures): number {
  const end_s = (postures.length - 1) * period;
  return Math.min(elapsed_s % (end_s + pause_s), end_s);
}

// Between two postures, joints and feet are in between; what stands is as in the former.
export function postureAt({ period, postures }: MotionPostures, time_s: number): Posture {
  const at = Math.min(Math.max(time_s / period, 0), postures.length - 1);
  const before = postures[Math.floor(at)];
  const after = postures[Math.ceil(at)];
  if (!before || !after) throw new RangeError("a motion has no postures");
  const mix = (a: readonly number[], b: readonly number[]) => a.map((value, index) => value + ((b[index] ?? value) - value) * (at - Math.floor(at)));
  return {
    joints: mix(before.joints, after.joints),
    feet: [mix(before.feet[0], after.feet[0]) as FootPlace, mix(before.feet[1], after.feet[1]) as FootPlace],
    support: before.support,
  };
}

// What a person must know before it is played.
export function motionText({ description, duration, start, refused }: MotionEntry): string {
  if (refused !== undefined) return `No preview: ${refused}.`;
  const lying = start !== "stands" ? " On the ground it is drawn roughly." : "";
  return `${description ?? ""} ${(duration ?? 0).toFixed(1)} s; begins when the robot ${start}.${lying}`.trim();
}

// How far from the lying to the standing attitude the trunk is drawn: 0 until it begins to rise, 1 from when feet stand.
export function rising({ period, postures }: MotionPostures, time_s: number): number {
  const stands = postures.findIndex(({ support }) => support !== 3);
  return stands < 0 ? 0 : Math.min(Math.max(time_s / Math.max(stands * period, period), 0), 1);
}
