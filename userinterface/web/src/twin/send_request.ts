// What is sent to the robot there, out of a form's fields: one walk, motion or goal at most, and settings, which go first. Passive.
import type { Message } from "../rosbridge.ts";
import type { Goal } from "../simulator/footstep_plan.ts";
import type { TwinState } from "./twin_state.ts";

export const exampleSetting = "stability.ankle_pitch=0.3";
export const leastReason = 10; // characters: it is recorded
export const shortest_s = 0.5;
export const longest_s = 599;
const begins_ms = 6000; // after that nothing begins any more that was asked for before: its answer is waited for for 5 s

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
    if (!found) throw new Error(`Line ${index + 1} of the settings is '${line}', and must be PLUGIN.PARAMETER=VALUE, such as ${exampleSetting}`);
    return `${found[1]}=${found[2]}`;
  });
}

// Throws an error that names the field, its value and the rule.
export function readRequest(fields: SendFields, bounds: SendBounds): SendRequest {
  const request: SendRequest = { walk: [], duration: 0, motion: "", goal: [], settings: readSettings(fields.settings), reason: "" };
  if (fields.kind === "walk") {
    const speed = (name: string, value: string) => numberOf(name, value, -bounds.forward, bounds.forward, "m/s");
    request.walk = [speed("forward", fields.forward), speed("left", fields.left), numberOf("turn", fields.turn, -bounds.turn, bounds.turn, "rad/s")];
    request.duration = numberOf("for", fields.seconds, shortest_s, longest_s, "s");
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

// As they are counted in a reason.
export const charactersOf = (reason: string) => reason.trim().length;

export function withReason(request: SendRequest, reason: string): SendRequest {
  const written = reason.trim();
  const count = charactersOf(reason);
  if (count < leastReason) throw new Error(`The reason has ${count} characters, and must have ${leastReason} at least: it is recorded with what is sent`);
  return { ...request, reason: written };
}

const fixed = (value: number) => value.toFixed(2);

// As the twin calls what was sent (`sending_what`).
export function whatOf({ walk, duration, motion, goal, settings }: SendRequest): string {
  const tasks: string[] = [];
  const [forward = 0, left = 0, turn = 0] = walk;
  const aside = left === 0 && turn === 0 ? "" : ` ahead, ${fixed(left)} to the left, ${fixed(turn)} rad/s`;
  if (walk.length > 0) tasks.push(`walk ${fixed(forward)} m/s${aside}, ${Number(duration.toPrecision(6))} s`);
  if (motion !== "") tasks.push(`motion ${motion}`);
  const [x = 0, y = 0, yaw = 0] = goal;
  if (goal.length > 0) tasks.push(`way to ${fixed(x)} m, ${fixed(y)} m, ${((yaw * 180) / Math.PI).toFixed(0)} deg`);
  return [settings.join(", "), ...tasks].filter((text) => text !== "").join(", then ");
}

type Told = Pick<TwinState, "sending" | "sendingWhat" | "sendingText" | "picture">;
const keyOf = ({ sending, sendingWhat, sendingText, picture }: Told) => JSON.stringify([sending, sendingWhat, sendingText, picture]);

// Remembers what this page has sent, so that nothing else is sent in its place when it did not pass. The answer may be lost with the connection,
// and with it what was told meanwhile: then it is known by its name, if what is told is not what was told before. Passive.
export class SentHere {
  private sent: { request: SendRequest; what: string } | undefined;
  private asked: { request: SendRequest; at_ms: number; before: string; answered: boolean } | undefined;

  // Before it is asked for. `told`: what is told until then.
  asks(request: SendRequest, told: Told, now_ms: number): void {
    this.asked = { request: { ...request, reason: "" }, at_ms: now_ms, before: keyOf(told), answered: false };
  }
  // It begins to be tried.
  begun(): void {
    if (!this.asked) return;
    this.sent = undefined;
    this.asked.answered = true;
  }
  // It does not, for certain.
  refused(): void {
    this.asked = undefined;
  }
  told(state: Told): void {
    if (!this.asked || keyOf(state) === this.asked.before) return;
    const { request, answered } = this.asked;
    if (!(answered && state.sending === "trying") && state.sendingWhat !== whatOf(request)) return;
    this.sent = { request, what: state.sendingWhat };
    this.asked = undefined;
  }
  // It may have begun without having been told of yet.
  isAsking(now_ms: number): boolean {
    return this.asked !== undefined && now_ms - this.asked.at_ms < begins_ms;
  }
  // undefined: what is told of was sent from elsewhere.
  requestOf(sendingWhat: string): SendRequest | undefined {
    return this.sent?.what === sendingWhat ? this.sent.request : undefined;
  }
}
