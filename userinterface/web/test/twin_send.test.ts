// What is sent to the robot there: fields as a request, reasons, whose it was; and the picture that comes in parts.
import assert from "node:assert/strict";
import test from "node:test";
import type { Message } from "../src/rosbridge.ts";
import { readRequest, readSettings, SentHere, whatOf, withReason, type SendFields } from "../src/twin/send_request.ts";
import type { Sending } from "../src/twin/twin_state.ts";
import { TwinOrders, wholePicture } from "../src/twin/twin_orders.ts";

const bounds = { forward: 0.5, turn: 1.5 };
const fields = (more: Partial<SendFields>): SendFields => ({ kind: "walk", forward: "0.2", left: "0", turn: "-0.1", seconds: "4", motion: "", goal: undefined, settings: "", ...more });
const told = (sending: Sending, sendingWhat: string, picture = 0) => ({ sending, sendingWhat, sendingText: "", picture });
const nothing = { walk: [], duration: 0, motion: "", goal: [], settings: [], reason: "" };

test("fields make the one request that is chosen, with settings before it", () => {
  assert.deepEqual(readRequest(fields({ settings: "trajectory.step_time = 0.3\n\n  zmp.gain=1 " }), bounds), { ...nothing, walk: [0.2, 0, -0.1], duration: 4, settings: ["trajectory.step_time=0.3", "zmp.gain=1"] });
  assert.deepEqual(readRequest(fields({ kind: "motion", motion: "kick" }), bounds), { ...nothing, motion: "kick" });
  assert.deepEqual(readRequest(fields({ kind: "goal", goal: { x: 1, y: 2, yaw: 3 } }), bounds), { ...nothing, goal: [1, 2, 3] });
  assert.deepEqual(readRequest(fields({ kind: "settings", settings: "a.b=c" }), bounds), { ...nothing, settings: ["a.b=c"] });
});

test("what cannot be sent says which field, what it is and what it must be", () => {
  const refused = (more: Partial<SendFields>, text: RegExp) => assert.throws(() => readRequest(fields(more), bounds), text);
  refused({ forward: "0.6" }, /“forward” is '0\.6', and must be -0\.5 … 0\.5 m\/s/);
  refused({ turn: "" }, /“turn” is ''/);
  refused({ seconds: "0.4" }, /“for” is '0\.4', and must be 0\.5 … 599 s/);
  refused({ seconds: "600" }, /“for” is '600'/);
  refused({ left: "0,1" }, /“left” is '0,1'/);
  refused({ forward: "0", turn: "0" }, /no speed/);
  refused({ kind: "motion" }, /No motion/);
  refused({ kind: "goal" }, /Walk to/);
  refused({ kind: "settings" }, /no settings/);
  assert.throws(() => readSettings("a.b=1\nstep_time=0.3"), /Line 2 .*'step_time=0\.3'.*PLUGIN\.PARAMETER=VALUE/);
});

test("a reason has ten characters", () => {
  const request = readRequest(fields({}), bounds);
  assert.throws(() => withReason(request, "  because   "), /7 characters/);
  assert.equal(withReason(request, " it is held by a crane ").reason, "it is held by a crane");
});

test("only what this page has sent is sent nevertheless", () => {
  const sent = new SentHere();
  const request = readRequest(fields({}), bounds);
  const before = told("not passed", "motion kick");
  sent.told(before);
  assert.equal(sent.requestOf("motion kick"), undefined, "it was another's");
  sent.asks(withReason(request, "it is held by a crane"), before, 0);
  sent.begun();
  sent.told(before); // it was under way
  assert.equal(sent.requestOf("motion kick"), undefined, "what was told before is not what was sent");
  assert.ok(sent.isAsking(100), "it may have begun");
  sent.told(told("trying", "walk 0.20 m/s ahead, …"));
  assert.ok(!sent.isAsking(200), "it is told of");
  sent.told(told("trying", "motion wave"));
  assert.deepEqual(sent.requestOf("walk 0.20 m/s ahead, …"), request, "without the former reason");
  assert.equal(sent.requestOf("motion wave"), undefined);
  sent.asks(readRequest(fields({ kind: "motion", motion: "wave" }), bounds), told("not passed", "walk 0.20 m/s ahead, …"), 300);
  sent.refused();
  assert.ok(!sent.isAsking(310));
  assert.deepEqual(sent.requestOf("walk 0.20 m/s ahead, …"), request, "what was refused is not in its place");
});

test("what was sent is known by its name when its answer was lost with the connection", () => {
  const request = readRequest(fields({ left: "0", turn: "0" }), bounds);
  const [before, name] = [told("done", "walk 0.20 m/s, 4 s"), "walk 0.20 m/s, 4 s"];
  const sent = new SentHere();
  sent.asks(request, before, 0);
  sent.told(before);
  assert.equal(sent.requestOf(name), undefined, "it is what was done before");
  sent.told(told("trying", "motion wave"));
  assert.equal(sent.requestOf("motion wave"), undefined, "it is another's");
  assert.ok(sent.isAsking(5900) && !sent.isAsking(6100), "what begins does so within that time");
  sent.told(told("not passed", name, 3));
  assert.deepEqual(sent.requestOf(name), request);
});

test("what is sent has the name that the twin gives it", () => {
  const name = (more: Partial<SendFields>) => whatOf(readRequest(fields(more), bounds));
  assert.equal(name({ left: "0", turn: "0", seconds: "10.5" }), "walk 0.20 m/s, 10.5 s");
  assert.equal(name({ settings: "a.b=1\nc.d=2" }), "a.b=1, c.d=2, then walk 0.20 m/s ahead, 0.00 to the left, -0.10 rad/s, 4 s");
  assert.equal(name({ kind: "motion", motion: "kick" }), "motion kick");
  assert.equal(name({ kind: "goal", goal: { x: 1.2, y: 0.5, yaw: Math.PI / 2 } }), "way to 1.20 m, 0.50 m, 90 deg");
  assert.equal(name({ kind: "settings", settings: "a.b=1" }), "a.b=1");
});

// Of the picture that there is at the first, second, … call; the last one stays.
function parts(pictures: number[][], part = 3) {
  let calls = 0;
  return async (first: number) => {
    const whole = pictures[Math.min(calls++, pictures.length - 1)]!;
    return { total: whole.length, bytes: Uint8Array.from(whole.slice(first, first + part)) };
  };
}

test("a picture comes in parts, and from its beginning when it becomes another one", async () => {
  assert.deepEqual([...await wholePicture(parts([[1, 2, 3, 4, 5, 6, 7]]))], [1, 2, 3, 4, 5, 6, 7]);
  assert.deepEqual([...await wholePicture(parts([[1, 2, 3]]))], [1, 2, 3]);
  assert.deepEqual([...await wholePicture(parts([[1, 2, 3, 4, 5], [8, 7, 6, 5]]))], [8, 7, 6, 5]);
});

test("a picture that does not fit its size is none", async () => {
  await assert.rejects(wholePicture(async () => ({ total: 4, bytes: new Uint8Array(0) })), /4 bytes/);
  await assert.rejects(wholePicture(async () => ({ total: 2, bytes: new Uint8Array(3) })), /has 3/);
  for (const total of [0, NaN, 1e9]) await assert.rejects(wholePicture(async () => ({ total, bytes: new Uint8Array(1) })), /bytes, and must/);
  let total = 10;
  await assert.rejects(wholePicture(async () => ({ total: ++total, bytes: new Uint8Array(1) })), /3 times/);
});

test("orders are what the services want", async () => {
  const asked: [string, Message | undefined][] = [];
  const orders = new TwinOrders({ order: async (service, args) => {
    asked.push([service, args]);
    return { success: true, message: "", total: 3, data: btoa("abc") };
  } });
  await orders.follow(true);
  await orders.send(readRequest(fields({}), bounds));
  await orders.stop();
  await orders.reconnect();
  assert.deepEqual([...await orders.picture()], [97, 98, 99]);
  assert.deepEqual(asked, [
    ["/simulation/twin/follow", { data: true }], ["/simulation/twin/send", { ...nothing, walk: [0.2, 0, -0.1], duration: 4 }], ["/simulation/twin/stop", {}], ["/simulation/twin/reconnect", {}],
    ["/simulation/twin/picture", { first: 0 }]]);
});
