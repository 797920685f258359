// What /walk_to/state tells: how far the robot is on its way. Passive.
import type { Message } from "../rosbridge.ts";
import type { Goal } from "./footstep_plan.ts";

export const wayTopic = { name: "/walk_to/state", type: "gaitway_msgs/msg/WayState" } as const;

export interface WayState {
  goes: boolean; // there is a way that it follows, or that it is planning
  result: string; // of the last one: none arrived cancelled refused failed
  text: string;
  stepsLeft: number;
  distanceLeft_m: number;
  replans: number;
  goal: Goal | undefined;
}

export function readWay(message: Message): WayState {
  const goal = Array.isArray(message["goal"]) ? message["goal"].map(Number) : [];
  return {
    goes: ["plans", "walks", "waits"].includes(String(message["state"])),
    result: String(message["result"]),
    text: String(message["text"] ?? ""),
    stepsLeft: Number(message["steps_left"]),
    distanceLeft_m: Number(message["distance_left"]),
    replans: Number(message["replans"]),
    goal: goal.length === 3 && goal.every(Number.isFinite) ? { x: goal[0]!, y: goal[1]!, yaw: goal[2]! } : undefined,
  };
}

export function leftText({ stepsLeft, distanceLeft_m }: WayState): string {
  const distance = Number.isFinite(distanceLeft_m) ? `${distanceLeft_m.toFixed(1)} m` : "";
  return [distance, stepsLeft > 0 ? `${stepsLeft} step${stepsLeft === 1 ? "" : "s"}` : ""].filter(Boolean).join(", ");
}

export const sameGoal = (a: Goal, b: Goal) => Math.hypot(a.x - b.x, a.y - b.y) < 0.005 && Math.abs(Math.sin((a.yaw - b.yaw) / 2)) < 0.005;
