// What /simulation/twin tells of the robot there, in the page's own form: what is not known is NaN or undefined, and never 0. Passive.
import type { Placed, Triple, Turn } from "../description.ts";
import type { Message } from "../rosbridge.ts";

export const twinTopic = { name: "/simulation/twin", type: "gaitway_msgs/msg/TwinState" } as const;
export const silentAfter_ms = 1000; // it comes ten times a second, whatever the robot there does
export const oldAfter_s = 0.5; // what was measured before that is not of now

const links = ["connecting", "connected", "lost", "refused"] as const;
const sendings = ["idle", "trying", "sending", "done", "not passed", "failed", "stopped"] as const;
export type TwinLink = (typeof links)[number];
export type Sending = (typeof sendings)[number];

// One thing that is compared. In SI units, as `unit` says.
export interface Channel {
  name: string;
  unit: string;
  measured: number;
  simulated: number; // at the same instant of the motion
  difference: number; // RMS over the last 2 s
  limit: number; // above it the difference is told; 0: it never is
}
export interface TwinState {
  robot: string; // its address
  link: TwinLink;
  text: string; // why, for people
  age_s: number; // since the newest measured state, when this was told
  activity: string; // "": not known
  commander: string; // "": nobody
  follows: boolean; // the simulated robot does what the robot there is told
  followsText: string; // why it does not, where no person ended it
  base: Placed | undefined; // measured, in the simulator's world
  joints: readonly number[] | undefined; // rad, measured
  lag_s: number; // that the simulated robot is behind
  channels: readonly Channel[];
  told: readonly { at_s: number; text: string }[]; // s since the simulator's start; the newest first: as they were told, backwards
  sending: Sending;
  sendingWhat: string;
  sendingText: string;
  passed: number;
  tried: number;
  picture: number; // another one: there is a new picture; 0: there is none
}

const list = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);
const known = (value: unknown) => (typeof value === "number" ? value : NaN); // JSON has null for what is no number
const numbers = (value: unknown) => list(value).map(known);
const text = (value: unknown) => (typeof value === "string" ? value : "");
const count = (value: unknown) => Math.max(0, Math.round(known(value))) || 0;

function readChannels(message: Message): Channel[] {
  const units = list(message["units"]);
  const [measured, simulated, difference, limits] = ["measured", "simulated", "difference", "limits"].map((field) => numbers(message[field])) as [number[], number[], number[], number[]];
  const at = (values: readonly number[], index: number) => values[index] ?? NaN;
  return list(message["channels"]).map((name, index) => ({
    name: String(name),
    unit: text(units[index]),
    measured: at(measured, index),
    simulated: at(simulated, index),
    difference: at(difference, index),
    limit: at(limits, index) > 0 ? at(limits, index) : 0,
  }));
}

export function readTwin(message: Message): TwinState {
  const told = String(message["state"]);
  const link = links.find((one) => one === told);
  const base = numbers(message["base"]);
  const joints = numbers(message["joints"]);
  const toldTexts = list(message["told_texts"]);
  const sending = String(message["sending"]);
  return {
    robot: text(message["robot"]),
    link: link ?? "lost",
    text: link ? text(message["text"]) : `it is said to be '${told}', which this page does not know`,
    age_s: known(message["age"]),
    activity: text(message["activity"]),
    commander: text(message["commander"]),
    follows: message["follows"] === true,
    followsText: text(message["follows_text"]),
    base: base.length === 7 && base.every(Number.isFinite) ? { place: base.slice(0, 3) as Triple, turn: base.slice(3) as Turn } : undefined,
    joints: joints.length > 0 ? joints : undefined,
    lag_s: known(message["lag"]),
    channels: readChannels(message),
    told: numbers(message["told_times"]).map((at_s, index) => ({ at_s, text: text(toldTexts[index]) })).reverse(),
    sending: sendings.find((one) => one === sending) ?? "idle",
    sendingWhat: text(message["sending_what"]),
    sendingText: text(message["sending_text"]),
    passed: count(message["passed"]),
    tried: count(message["tried"]),
    picture: count(message["picture"]),
  };
}

// Something is on its way to the robot there.
export const isBusy = ({ sending }: Pick<TwinState, "sending">) => sending === "trying" || sending === "sending";
