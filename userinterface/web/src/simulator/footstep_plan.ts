// A way to a goal, as footsteps: how the planner's answer reads, and how much of it is still to come. Passive.
import type { Message } from "../rosbridge.ts";

// Of the middle between the feet, in the simulator's world.
export interface Goal {
  x: number;
  y: number;
  yaw: number;
}
export type Side = 0 | 1; // left, right
export interface Footstep extends Goal {
  side: Side; // of the sole, whose pose this is
}
export interface FootstepPlan {
  steps: readonly Footstep[];
  feet: readonly [Goal, Goal]; // where they are
  seconds: number; // that the walk takes, estimated
}

// A list of bytes, or what rosbridge makes of it elsewhere: their base64.
function bytesOf(value: unknown): number[] {
  if (typeof value === "string") return [...atob(value)].map((letter) => letter.charCodeAt(0));
  return Array.isArray(value) ? value.map(Number) : [];
}

// Throws where the answer is none that a plan may give.
export function readPlan(answer: Message): FootstepPlan {
  const sides = bytesOf(answer["sides"]);
  const poses = (answer["steps"] as unknown[]).map(Number);
  const feet = (answer["feet"] as unknown[]).map(Number);
  if (poses.length !== 3 * sides.length || feet.length !== 6 || ![...poses, ...feet].every(Number.isFinite)) {
    throw new Error(`the plan has ${sides.length} sides, ${poses.length} numbers of steps and ${feet.length} of feet: three a step and six are wanted`);
  }
  const pose = (values: readonly number[], at: number): Goal => ({ x: values[3 * at]!, y: values[3 * at + 1]!, yaw: values[3 * at + 2]! });
  return {
    steps: sides.map((side, index) => ({ side: side === 1 ? 1 : 0, ...pose(poses, index) })),
    feet: [pose(feet, 0), pose(feet, 1)],
    seconds: Number(answer["duration"]),
  };
}

export function middleOf([left, right]: FootstepPlan["feet"]): Goal {
  const yaw = Math.atan2(Math.sin(left.yaw) + Math.sin(right.yaw), Math.cos(left.yaw) + Math.cos(right.yaw));
  return { x: (left.x + right.x) / 2, y: (left.y + right.y) / 2, yaw };
}

// Of the middle between the feet, along the steps.
export function length_m({ steps, feet }: FootstepPlan): number {
  const now: [Goal, Goal] = [...feet];
  let last = middleOf(now);
  let sum_m = 0;
  for (const step of steps) {
    now[step.side] = step;
    const middle = middleOf(now);
    sum_m += Math.hypot(middle.x - last.x, middle.y - last.y);
    last = middle;
  }
  return sum_m;
}

// How many of the steps are behind when the robot says that so many are left. Of a way that was planned anew it may be more than there were.
export function passedSteps(plan: FootstepPlan, left: number): number {
  return Math.min(Math.max(plan.steps.length - left, 0), plan.steps.length);
}

export function planText(plan: FootstepPlan): string {
  const steps = `${plan.steps.length} step${plan.steps.length === 1 ? "" : "s"}`;
  const time = Number.isFinite(plan.seconds) && plan.seconds > 0 ? `, about ${plan.seconds.toFixed(0)} s` : "";
  return `${steps}, ${length_m(plan).toFixed(1)} m${time}`;
}

// The goal that a press and a drag over the floor make. Who only taps wants the robot to look the way it comes.
export const tapAtMost_m = 0.08;
export function goalOfDrag(from: readonly [number, number], to: readonly [number, number], robot: Goal | undefined): Goal {
  const [x, y] = from;
  const drag = Math.hypot(to[0] - x, to[1] - y);
  if (drag > tapAtMost_m) return { x, y, yaw: Math.atan2(to[1] - y, to[0] - x) };
  const near = !robot || Math.hypot(x - robot.x, y - robot.y) < 0.25; // there it only shifts its feet
  return { x, y, yaw: near ? (robot?.yaw ?? 0) : Math.atan2(y - robot.y, x - robot.x) };
}

export function goalText({ x, y, yaw }: Goal): string {
  const signed = (value: number) => value.toFixed(2).replace("-", "−");
  return `x ${signed(x)} m, y ${signed(y)} m, ${((yaw * 180) / Math.PI).toFixed(0).replace("-", "−")}°`;
}
