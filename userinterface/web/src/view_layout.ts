// The layout of the view's frame. Made by `./dev gaitway api document` from the robot's own table; not to be edited.
export type ViewType = "uint8" | "int16" | "uint16" | "int32" | "uint32";
export interface ViewRow {
  readonly name: string;
  readonly type: ViewType;
  readonly count: number; // 0: one a joint
  readonly scale: number; // 0: counters, bits, letters
}
export const viewVersion = 1;
export const viewRows = [
  { name: "version", type: "uint8", count: 1, scale: 1 },
  { name: "joint_count", type: "uint8", count: 1, scale: 1 },
  { name: "frame", type: "uint32", count: 1, scale: 0 },
  { name: "robot_time", type: "uint32", count: 1, scale: 0.001 },
  { name: "mode", type: "uint8", count: 1, scale: 1 },
  { name: "activity", type: "uint8", count: 1, scale: 1 },
  { name: "contact", type: "uint8", count: 2, scale: 1 },
  { name: "age", type: "uint16", count: 5, scale: 0.001 },
  { name: "round_trip", type: "uint16", count: 1, scale: 0.001 },
  { name: "base_place", type: "int32", count: 2, scale: 0.0001 },
  { name: "base_height", type: "int16", count: 1, scale: 0.0001 },
  { name: "base_turn", type: "int16", count: 4, scale: 3.051850947599719e-05 },
  { name: "com", type: "int16", count: 3, scale: 0.0001 },
  { name: "zmp", type: "int16", count: 2, scale: 0.0001 },
  { name: "planned_zmp", type: "int16", count: 2, scale: 0.0001 },
  { name: "foot_force", type: "uint16", count: 2, scale: 0.1 },
  { name: "velocity", type: "int16", count: 3, scale: 0.001 },
  { name: "joint_trouble", type: "uint8", count: 5, scale: 0 },
  { name: "batches_late", type: "uint16", count: 1, scale: 0 },
  { name: "batches_refused", type: "uint16", count: 1, scale: 0 },
  { name: "tails_played", type: "uint16", count: 1, scale: 0 },
  { name: "footstep_count", type: "uint8", count: 1, scale: 1 },
  { name: "footstep", type: "int16", count: 12, scale: 0.001 },
  { name: "commander", type: "uint8", count: 16, scale: 0 },
  { name: "joint", type: "int16", count: 0, scale: 0.0001 },
] as const satisfies readonly ViewRow[];
