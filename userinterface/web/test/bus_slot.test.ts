// What the picture of the bus says of a slot: what was there, what was late, what is missing.
import assert from "node:assert/strict";
import test from "node:test";
import { hasTrouble, share, slotPicture, troubles, type BusMessage, type BusSlot, type BusTable, type Entry } from "../src/bus_slot.ts";

const message = (kind: string, ids: number[], joint: number, released: BusMessage["released"], worst_us: number | null, more: Partial<BusMessage> = {}): BusMessage => ({
  kind, id: ids[0] ?? 0, ids, bytes: 8, joint, sent_by_joint: kind === "feedback", period_us: 10_000, on_event: false, transmission_us: 135, released, worst_us, deadline_us: 10_000, ...more,
});
const table: BusTable = {
  profile: "full", slot_us: 10_000, cycle_slots: 8, interframe_us: 3, load: 0.4, jitter_us: 1000, jam_us: 2000,
  messages: [
    message("emergency stop", [1], -1, "", 3000, { on_event: true }),
    message("SYNC", [8], -1, "slot_edge", 3500),
    message("trim", [16], -1, "", 3700),
    message("feedback", [65], 0, "sync", 4000),
    message("feedback", [66], 1, "sync", 4200),
    message("trajectory", [258, 259], 0, "batch", 6000, { period_us: 80_000 }),
    message("trajectory", [260, 261], 1, "batch", 6200, { period_us: 80_000 }),
    message("heartbeat", [768], -1, "", null, { period_us: 80_000 }),
  ],
};
const joints = ["left knee", "right knee"];
type Seen = [id: number, end_us: number, length_us?: number];
const slot = (...seen: Seen[]): BusSlot => ({
  header: { stamp: { sec: 1, nanosec: 0 } }, cycle: 12, slot: 4,
  id: seen.map(([id]) => id), end_us: seen.map(([, end_us]) => end_us), length_us: seen.map(([, , length_us]) => length_us ?? 100), left_out: 0,
});
const of = (...seen: Seen[]) => slotPicture(slot(...seen), table, joints);
const entry = (entries: Entry[], name: string): Entry => {
  const found = entries.find((one) => one.name === name);
  assert.ok(found, `no ${name} in ${entries.map((one) => one.name).join(", ")}`);
  return found;
};

test("a slot in which all came in time says so, and how full it was", () => {
  const picture = of([8, 80, 80], [65, 200], [66, 303]);
  assert.deepEqual(picture.count, { "in time": 3, seen: 0, late: 0, missing: 0, foreign: 0, error: 0 });
  assert.equal(picture.load, (80 + 100 + 100 + 3 * 3) / 10_000);
  const knee = entry(picture.entries, "feedback, right knee");
  assert.deepEqual([knee.due_us, knee.latest_us, knee.end_us, knee.length_us], [80, 4280, 303, 100]);
  assert.equal(hasTrouble(picture), false);
  assert.equal(share(picture), "3 frames take 3 % of the slot");
  assert.equal(troubles(picture), "none is missing or late");
});

test("what is there in every slot is missing when it does not come; what is not, is not", () => {
  const picture = of([8, 80], [66, 303]);
  const knee = entry(picture.entries, "feedback, left knee");
  assert.deepEqual([knee.verdict, knee.end_us, knee.due_us, knee.latest_us], ["missing", undefined, 80, 4080]);
  assert.equal(picture.count.missing, 1, "neither trim nor batch nor stop");
  assert.equal(troubles(picture), "1 missing (feedback, left knee)");
  assert.equal(hasTrouble(picture), true);
});

test("an answer after its proven worst case is late; it is measured from the SYNC", () => {
  assert.equal(entry(of([8, 80], [65, 4080], [66, 4190]).entries, "feedback, left knee").verdict, "in time");
  const picture = of([8, 80], [66, 303], [65, 4081]);
  assert.equal(entry(picture.entries, "feedback, left knee").verdict, "late");
  assert.equal(picture.count.missing, 0);
  assert.equal(entry(of([8, 3600], [65, 3700], [66, 3800]).entries, "SYNC").verdict, "late");
});

test("without a SYNC it is missing, and answers are measured from when it must have come", () => {
  const picture = of([65, 7500], [66, 7701]);
  assert.equal(entry(picture.entries, "SYNC").verdict, "missing");
  assert.equal(entry(picture.entries, "feedback, left knee").verdict, "in time");
  assert.equal(entry(picture.entries, "feedback, right knee").verdict, "late");
});

test("an answer before the SYNC is one of the slot before if its own follows, and one by the joint's own clock if not", () => {
  const followed = of([66, 20], [8, 180], [65, 290], [66, 400]);
  assert.deepEqual(followed.entries.filter(({ name }) => name === "feedback, right knee").map(({ verdict }) => verdict), ["late", "in time"]);
  const alone = of([66, 20], [8, 180], [65, 290]);
  assert.equal(entry(alone.entries, "feedback, right knee").verdict, "seen");
  assert.equal(alone.count.missing, 0);
});

test("a batch's frames are measured from its first one, each toggle for itself", () => {
  const picture = of([8, 80], [65, 200], [66, 300], [259, 1100], [258, 5000], [260, 5200], [261, 7201]);
  const [first, second] = picture.entries.filter(({ name }) => name === "trajectory, right knee");
  assert.deepEqual([first?.due_us, first?.verdict], [4900, "in time"]);
  assert.deepEqual([second?.due_us, second?.latest_us, second?.verdict], [1000, 7200, "late"]);
});

test("errors, foreign frames and messages without a known release are what they are", () => {
  const picture = of([8, 80], [65, 200], [66, 300], [0x2000_0000, 400, 0], [0x7ab, 500], [0x9abc_def0, 600], [0x4000_0041, 700], [16, 800], [768, 900]);
  assert.equal(entry(picture.entries, "error on the bus").verdict, "error");
  assert.equal(entry(picture.entries, "unknown frame 0x7AB").verdict, "foreign");
  assert.equal(entry(picture.entries, "unknown extended frame 0x1ABCDEF0").verdict, "foreign");
  assert.equal(entry(picture.entries, "unknown remote frame 0x041").verdict, "foreign");
  assert.equal(entry(picture.entries, "trim").verdict, "seen");
  assert.equal(entry(picture.entries, "heartbeat").verdict, "seen");
  assert.match(share(picture), /^8 frames /);
  assert.equal(troubles(picture), "1 error, 3 not the robot's own (unknown frame 0x7AB; unknown extended frame 0x1ABCDEF0 …)");
});

test("a frame that began before the slot counts with what of it is in the slot", () => {
  assert.equal(of([8, 30, 80]).load, (30 + 3) / 10_000);
});

test("a slot with more frames than its record has room for says of none that it is missing", () => {
  const crowded = { ...slot([8, 80]), left_out: 3 };
  assert.equal(slotPicture(crowded, table, joints).count.missing, 0);
});

test("in the published profile joints answer their trajectories, and nothing is said of slots without", () => {
  const paper: BusTable = { ...table, profile: "paper", messages: [message("trajectory", [1], 0, "cycle_edge", 1700, { period_us: 80_000 }), message("feedback", [13], 0, "trajectory", 3300)] };
  const first = slotPicture({ ...slot([1, 120], [13, 3000]), slot: 0 }, paper, joints);
  assert.deepEqual(first.entries.map(({ due_us, verdict }) => [due_us, verdict]), [[0, "in time"], [120, "in time"]]);
  assert.deepEqual(slotPicture(slot([13, 9000]), paper, joints).entries.map(({ verdict }) => verdict), ["seen"]);
  assert.equal(slotPicture(slot(), paper, joints).count.missing, 0);
});
