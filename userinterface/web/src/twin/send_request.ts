// What is sent to the robot there, out of a form's fields: one walk, motion or goal at most, and settings, which go first. Passive.
import type { Message } from "../rosbridge.ts";
import type { Goal } from "../simulator/footstep_plan.ts";

export const leastReason = 10; // characters: it is recorded
const longest_s = 600;

export type SendKind = "walk" | "motion" | "goal" | "settings";
export interface SendFields {
  kind: SendKind;
  forward: string; // m/s
  left: string; // m/s
  turn: string; // rad/s
  seconds: string;
  motion: string;
  goal: Goal | undefined;
  settings: string; // PLUGIN.PARAMETER=VALUE, one a line
}
export interface SendBounds {
  forward: number; // m/s, so left
  turn: number; // rad/s
}
// As gaitway_msgs/srv/SendToRobot has it.
export interface SendRequest extends Message {
  walk: number[];
  duration: number;
  motion: string;
  goal: number[];
  settings: string[];
  reason: string;
}

function numberOf(name: string, value: string, least: number, most: number, unit: string): number {
  const number = value.trim() === "" ? NaN : Number(value);
  if (number >= least && number <= most) return number;
  throw new Error(`“${name}” is '${value}', and must be ${least} … ${most} ${unit}`);
}

export function readSettings(text: string): string[] {
  return text.split("\n").map((line, index) => ({ line: line.trim(), index })).filter(({ line }) => line !== "").map(({ line, index }) => {
    const found = /^([\w-]+\.[\w.-]+)\s*=\s*(.+)$/.exec(line);
    if (!found) throw new Error(`Line ${index + 1} of the settings is '${line}', and must be PLUGIN.PARAMETER=VALUE, such as trajectory.step_time=0.3`);
    return `${found[1]}=${found[2]}`;
  });
}

// Throws an error that names the field, its value and the rule.
export function readRequest(fields: SendFields, bounds: SendBounds): SendRequest {
  const request: SendRequest = { walk: [], duration: 0, motion: "", goal: [], settings: readSettings(fields.settings), reason: "" };
  if (fields.kind === "walk") {
    const speed = (name: string, value: string) => numberOf(name, value, -bounds.forward, bounds.forward, "m/s");
    request.walk = [speed("forward", fields.forward), speed("left", fields.left), numberOf("turn", fields.turn, -bounds.turn, bounds.turn, "rad/s")];
    request.duration = numberOf("for", fields.seconds, 0.1, longest_s, "s");
    if (request.walk.every((value) => value === 0)) throw new Error("The walk has no speed: “forward”, “left” and “turn” are 0, and one of them must not be");
  } else if (fields.kind === "motion") {
    if (fields.motion === "") throw new Error("No motion is chosen: choose one of the list");
    request.motion = fields.motion;
  } else if (fields.kind === "goal") {
    if (!fields.goal) throw new Error("No goal is chosen: press Walk to, and click the floor in the picture");
    request.goal = [fields.goal.x, fields.goal.y, fields.goal.yaw];
  } else if (request.settings.length === 0) {
    throw new Error("There are no settings to send: write at least one line PLUGIN.PARAMETER=VALUE");
  }
  return request;
}

export function withReason(request: SendRequest, reason: string): SendRequest {
  const written = reason.trim();
  if (written.length < leastReason) throw new Error(`The reason has ${written.length} characters, and must have ${leastReason} at least: it is recorded with what is sent`);
  return { ...request, reason: written };
}

// Remembers what this page has sent, so that nothing else is sent in its place when it did not pass.
export class SentHere {
  private request: SendRequest | undefined;
  private what: string | undefined;

  begun(request: SendRequest): void {
    this.request = { ...request, reason: "" };
    this.what = undefined;
  }
  told({ sending, sendingWhat }: { sending: string; sendingWhat: string }): void {
    if (this.request && this.what === undefined && sending !== "idle") this.what = sendingWhat;
  }
  // undefined: what is told of was sent from elsewhere.
  requestOf(sendingWhat: string): SendRequest | undefined {
    return this.what === sendingWhat ? this.request : undefined;
  }
}
