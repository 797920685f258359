// One time slot of the bus as it was seen, held against what is meant to be there: what was late, what is missing. Passive.
import { withToken } from "./description.ts";

// As userinterface/page/bus_assets.hpp has it.
export interface BusMessage {
  kind: string;
  id: number;
  ids: number[];
  bytes: number;
  joint: number; // -1: it is for all joints
  sent_by_joint: boolean;
  period_us: number;
  on_event: boolean;
  transmission_us: number;
  released: "" | "slot_edge" | "cycle_edge" | "sync" | "batch" | "trajectory";
  worst_us: number | null; // from its release
  deadline_us: number;
}
export interface BusTable {
  profile: string;
  slot_us: number;
  cycle_slots: number;
  interframe_us: number;
  load: number;
  jitter_us: number;
  jam_us: number;
  messages: BusMessage[];
}

export async function loadBus(token: string | undefined): Promise<BusTable> {
  const answer = await fetch("bus.json", withToken(token));
  if (!answer.ok) throw new Error(await answer.text());
  return (await answer.json()) as BusTable;
}

// The topic /bus_slot.
export interface BusSlot {
  header: { stamp: { sec: number; nanosec: number } };
  cycle: number;
  slot: number;
  id: number[];
  end_us: number[];
  length_us: number[];
  left_out: number;
}

const extended = 0x8000_0000;
const remote = 0x4000_0000;
const error = 0x2000_0000;

// in time: within the proven worst case. seen: nobody who listens knows when it was released. foreign: the robot has no such message.
export type Verdict = "in time" | "seen" | "late" | "missing" | "foreign" | "error";

// A frame of the slot, an error, or what should have come and did not (no `end_us`). Times from the slot's edge.
export interface Entry {
  message?: BusMessage;
  name: string;
  verdict: Verdict;
  end_us?: number;
  length_us: number;
  due_us?: number; // it was released then
  latest_us?: number; // it must have arrived by then, as is proven
}
export interface SlotPicture {
  entries: Entry[]; // in the order of time, what is missing where it was due
  load: number; // share of the slot
  count: Record<Verdict, number>;
}

interface Frame {
  message: BusMessage;
  id: number;
  start_us: number;
  end_us: number;
}

function hex(id: number): string {
  return `0x${id.toString(16).toUpperCase().padStart(3, "0")}`;
}

function nameOf(message: BusMessage, joints: readonly string[]): string {
  return message.joint < 0 ? message.kind : `${message.kind}, ${joints[message.joint] ?? `joint ${message.joint}`}`;
}

function foreignName(id: number): string {
  const format = (id & extended) !== 0 ? "extended " : "";
  return `unknown ${format}${(id & remote) !== 0 ? "remote " : ""}frame ${hex(id & 0x1fff_ffff)}`;
}

// When messages were released, as far as the slot's frames show it.
class Releases {
  private readonly sync: Frame | undefined;

  constructor(
    private readonly slot: BusSlot,
    private readonly table: BusTable,
    private readonly frames: readonly Frame[],
  ) {
    this.sync = frames.find(({ message }) => message.released === "slot_edge");
  }

  // Of a message that was not seen.
  ofMissing(message: BusMessage): number | undefined {
    if (message.released === "slot_edge") return 0;
    if (message.released !== "sync") return undefined;
    // Without a SYNC the joints go by their own clocks: as if it had come as late as it may.
    return this.sync?.end_us ?? this.table.messages.find(({ released }) => released === "slot_edge")?.worst_us ?? undefined;
  }

  of(frame: Frame): number | undefined {
    const { message, start_us } = frame;
    switch (message.released) {
      case "sync":
        return this.answersNothingHere(frame) ? undefined : this.ofMissing(message);
      case "cycle_edge":
        return this.slot.slot === 0 ? 0 : undefined;
      case "batch":
        return this.frames.find((other) => other.message.released === "batch" && toggleOf(other) === toggleOf(frame))?.start_us;
      case "trajectory":
        return this.frames.findLast((other) => other.message.joint === message.joint && other.message.released === "cycle_edge" && other.end_us <= start_us)?.end_us;
      default:
        return this.ofMissing(message);
    }
  }

  // An answer of the slot before, which its own follows; or one by the joint's own clock, before a late SYNC.
  private answersNothingHere({ start_us }: Frame): boolean {
    return this.sync !== undefined && start_us < this.sync.end_us;
  }
  isOfSlotBefore(frame: Frame): boolean {
    return frame.message.released === "sync" && this.answersNothingHere(frame) &&
      this.frames.some((other) => other.message === frame.message && other.end_us > frame.end_us);
  }
}

function toggleOf({ message, id }: Frame): number {
  return message.ids.indexOf(id);
}

function judged(frame: Frame, releases: Releases, joints: readonly string[]): Entry {
  const { message, end_us, start_us } = frame;
  const due_us = releases.of(frame);
  const latest_us = due_us === undefined || message.worst_us === null ? undefined : due_us + message.worst_us;
  const late = releases.isOfSlotBefore(frame) || (latest_us !== undefined && end_us > latest_us);
  const verdict = late ? "late" : latest_us === undefined ? "seen" : "in time";
  return { message, name: nameOf(message, joints), verdict, end_us, length_us: end_us - start_us, ...(due_us !== undefined && { due_us }), ...(latest_us !== undefined && { latest_us }) };
}

// Whether one is there in every slot.
function isExpected(message: BusMessage, table: BusTable): boolean {
  return !message.on_event && message.period_us === table.slot_us && (message.released === "slot_edge" || message.released === "sync");
}

export function slotPicture(slot: BusSlot, table: BusTable, joints: readonly string[]): SlotPicture {
  const byId = new Map(table.messages.flatMap((message) => message.ids.map((id) => [id, message] as const)));
  const entries: Entry[] = [];
  const frames: Frame[] = [];
  let busy_us = 0;
  for (const [index, raw] of slot.id.entries()) {
    const [end_us, length_us] = [slot.end_us[index] ?? 0, slot.length_us[index] ?? 0];
    const message = byId.get(raw);
    if ((raw & error) !== 0) {
      entries.push({ name: "error on the bus", verdict: "error", end_us, length_us: 0 });
      continue;
    }
    busy_us += Math.min(length_us, end_us) + table.interframe_us;
    if (message) frames.push({ message, id: raw, start_us: end_us - length_us, end_us });
    else entries.push({ name: foreignName(raw), verdict: "foreign", end_us, length_us });
  }
  frames.sort((one, other) => one.end_us - other.end_us);
  const releases = new Releases(slot, table, frames);
  entries.push(...frames.map((frame) => judged(frame, releases, joints)));
  const seen = new Set(frames.filter((frame) => !releases.isOfSlotBefore(frame)).map(({ message }) => message));
  for (const message of slot.left_out > 0 ? [] : table.messages) {
    const due_us = releases.ofMissing(message);
    if (seen.has(message) || due_us === undefined || !isExpected(message, table)) continue;
    entries.push({ message, name: nameOf(message, joints), verdict: "missing", length_us: message.transmission_us, due_us, ...(message.worst_us !== null && { latest_us: due_us + message.worst_us }) });
  }
  const when = ({ end_us, due_us }: Entry) => end_us ?? due_us ?? 0;
  entries.sort((one, other) => when(one) - when(other));
  const count: SlotPicture["count"] = { "in time": 0, seen: 0, late: 0, missing: 0, foreign: 0, error: 0 };
  for (const { verdict } of entries) count[verdict] += 1;
  return { entries, load: Math.min(busy_us / table.slot_us, 1), count };
}

export function share({ entries, load }: SlotPicture): string {
  const frames = entries.filter(({ end_us, verdict }) => end_us !== undefined && verdict !== "error").length;
  return `${frames} frames take ${Math.round(load * 100)} % of the slot`;
}

// What is wrong with it, in words.
export function troubles({ entries, count }: SlotPicture): string {
  const named = (verdict: Verdict) => {
    const names = entries.filter((entry) => entry.verdict === verdict).map(({ name }) => name);
    return names.length > 2 ? `${names.slice(0, 2).join("; ")} …` : names.join("; ");
  };
  const all = [
    count.missing > 0 && `${count.missing} missing (${named("missing")})`,
    count.late > 0 && `${count.late} late (${named("late")})`,
    count.error > 0 && `${count.error} ${count.error === 1 ? "error" : "errors"}`,
    count.foreign > 0 && `${count.foreign} not the robot's own (${named("foreign")})`,
  ].filter((text) => text !== false);
  return all.length > 0 ? all.join(", ") : "none is missing or late";
}

export const hasTrouble = ({ count }: SlotPicture): boolean => count.missing + count.late + count.error + count.foreign > 0;
