// What /simulation/state tells of the simulator, in the page's own form. Passive.
import type { Message } from "../rosbridge.ts";
import type { Placed, Triple, Turn } from "../description.ts";

export const stateTopic = { name: "/simulation/state", type: "gaitway_msgs/msg/SimulationState" } as const;
export const silentAfter_ms = 1000; // it comes ten times a second, also while the simulator is paused

export type MarkKind = "command" | "push" | "fault" | "world" | "fall";
export interface Mark {
  at_s: number;
  kind: MarkKind;
}
// Pose of a frame in another one, both upright.
export interface Odometry {
  x: number;
  y: number;
  z: number;
  yaw: number;
}
export interface SimulationState {
  time_s: number;
  recorded_s: number; // the last instant that has been simulated
  state: "playing" | "paused" | "busy" | "failed";
  text: string; // what it is busy with, or why it failed
  speed: number; // that is asked for, in times real time
  pace: number; // that is measured
  world: string;
  geometry: number; // another one: the world's solids are others
  run: number; // another one: the robot has been put to another instant
  fallen: boolean;
  odometry: Odometry | undefined; // of the frame of the robot's own estimate, in the simulator's world; undefined: not known
  base: Placed | undefined; // true, in the simulator's world
  things: ReadonlyMap<string, Placed>;
  marks: readonly Mark[];
  events: readonly { at_s: number; text: string }[];
}

const markKinds: readonly string[] = ["command", "push", "fault", "world", "fall"] satisfies MarkKind[];
const states: readonly string[] = ["playing", "paused", "busy", "failed"] satisfies SimulationState["state"][];

const list = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);
const numbers = (value: unknown) => list(value).map(Number);

export function poseOf(pose: unknown): Placed {
  const { position, orientation } = pose as { position: { x: number; y: number; z: number }; orientation: { x: number; y: number; z: number; w: number } };
  return { place: [position.x, position.y, position.z], turn: [orientation.x, orientation.y, orientation.z, orientation.w] };
}

export function readState(message: Message): SimulationState {
  const kinds = list(message["mark_kinds"]);
  const texts = list(message["event_texts"]);
  const poses = list(message["thing_poses"]);
  const odometry = numbers(message["odometry"]);
  const base = numbers(message["base"]);
  const state = String(message["state"]);
  return {
    time_s: Number(message["time"]),
    recorded_s: Math.max(Number(message["recorded"]), Number(message["time"])),
    state: states.includes(state) ? (state as SimulationState["state"]) : "failed",
    text: states.includes(state) ? String(message["text"] ?? "") : `it says that it is '${state}', which this page does not know`,
    speed: Number(message["speed"]),
    pace: Number(message["pace"]),
    world: String(message["world"] ?? ""),
    geometry: Number(message["geometry"]),
    run: Number(message["run"]),
    fallen: message["fallen"] === true,
    odometry: odometry.length === 4 && odometry.every(Number.isFinite) ? { x: odometry[0]!, y: odometry[1]!, z: odometry[2]!, yaw: odometry[3]! } : undefined,
    base: base.length === 7 ? { place: base.slice(0, 3) as Triple, turn: base.slice(3) as Turn } : undefined,
    things: new Map(list(message["thing_names"]).flatMap((name, index) => (poses[index] ? [[String(name), poseOf(poses[index])]] : []))),
    marks: numbers(message["mark_times"]).flatMap((at_s, index) => (markKinds.includes(String(kinds[index])) ? [{ at_s, kind: kinds[index] as MarkKind }] : [])),
    events: numbers(message["event_times"]).map((at_s, index) => ({ at_s, text: String(texts[index] ?? "") })),
  };
}

// How fast the robot's time passes: what rests does not age.
export function paceOf({ state, speed }: SimulationState): number {
  return state === "playing" ? speed : 0;
}
