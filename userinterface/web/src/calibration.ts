// What the robot was calibrated with, as the robot tells it, and as people read it. Passive.
import { withToken, type Triple, type Turn } from "./description.ts";

export interface Calibrated {
  value: number[];
  deviation: number[] | null;
}
export interface Calibration {
  there: boolean;
  made: string | null;
  joints: { name: string; zero: Calibrated | null; encoder_step: number; trim_channel: number | null }[]; // rad
  trunk_com_offset: Calibrated | null; // m
  feet: { side: string; sensor: "cells" | "six_axis" | "none"; gain: Calibrated | null }[];
  imu: { link: string; place: Triple; turn: Turn };
}

export async function loadCalibration(token: string | undefined): Promise<Calibration> {
  const answer = await fetch("calibration.json", withToken(token));
  if (!answer.ok) throw new Error(await answer.text());
  return (await answer.json()) as Calibration;
}

const degrees = (angle_rad: number) => (angle_rad * 180) / Math.PI;
const signed = (value: number, digits: number) => (value < 0 ? "−" : "+") + Math.abs(value).toFixed(digits);
export const noValue = "as described";

// "+0.50 ± 0.03"; `scale`: to the unit that people read.
export function valueText(calibrated: Calibrated | null, index: number, scale: (value: number) => number, digits: number): string {
  if (!calibrated) return noValue;
  const deviation = calibrated.deviation?.[index];
  return signed(scale(calibrated.value[index] ?? NaN), digits) + (deviation === undefined ? "" : ` ± ${scale(deviation).toFixed(digits)}`);
}
export const zeroText = (zero: Calibrated | null) => valueText(zero, 0, degrees, 3);
export const offsetText = (offset: Calibrated | null, axis: number) => valueText(offset, axis, (metres) => metres * 1000, 1);
export const gainText = (gain: Calibrated | null, cell: number) => valueText(gain, cell, (value) => value, 3).replace(/^\+/, "");

// Roll, pitch and yaw in degrees: the turn about the link's x, then y, then z, as robot.yaml has it.
export function rollPitchYaw([x, y, z, w]: Turn): Triple {
  const upright = 2 * (w * y - z * x);
  const locked = Math.abs(upright) > 1 - 1e-9; // pitched by a right angle roll and yaw are one: all of it is told as yaw
  const roll = locked ? 0 : Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
  const pitch = Math.asin(Math.min(1, Math.max(-1, upright)));
  const yaw = locked ? -2 * Math.sign(upright) * Math.atan2(x, w) : Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  return [degrees(roll), degrees(pitch), degrees(yaw)].map((angle) => (Math.abs(angle) < 5e-4 ? 0 : angle)) as Triple;
}

// When it was made, or that there is none.
export function summaryText({ there, made }: Calibration): string {
  if (!there) return "This robot has no calibration: zeros, centre of mass and gains are taken to be as its description says. gaitway calibrate finds them.";
  return made === null ? "Calibrated; its file does not say when." : `Calibrated, made ${made.replace("T", " ").replace(/:\d\dZ$/, " UTC")}.`;
}
