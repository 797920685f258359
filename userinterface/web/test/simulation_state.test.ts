// What the simulator tells and what it is asked: the state's fields, results of simulation_interfaces, events as texts.
import assert from "node:assert/strict";
import test from "node:test";
import { Refused, type Message } from "../src/rosbridge.ts";
import { SimulationOrders } from "../src/simulator/simulation_orders.ts";
import { paceOf, readState } from "../src/simulator/simulation_state.ts";

const pose = { position: { x: 1, y: 2, z: 3 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
const message = (more: Message = {}): Message => ({
  time: 12.345, recorded: 30.2, state: "paused", text: "", speed: 2, pace: 1.9, world: "boxes", geometry: 3, run: 2, fallen: false, odometry: [0.1, 0.2, 0, 0.3],
  base: [1, 2, 0.4, 0, 0, 0, 1], thing_names: ["ball"], thing_poses: [pose], mark_times: [1, 2, 3], mark_kinds: ["push", "unheard_of", "fall"], event_times: [1], event_texts: ["push"], ...more,
});

test("the state reads as it was told; marks that this page does not know are left out", () => {
  const state = readState(message());
  assert.deepEqual([state.time_s, state.recorded_s, state.state, state.run], [12.345, 30.2, "paused", 2]);
  assert.deepEqual(state.odometry, { x: 0.1, y: 0.2, z: 0, yaw: 0.3 });
  assert.deepEqual(state.things.get("ball"), { place: [1, 2, 3], turn: [0, 0, 0, 1] });
  assert.deepEqual(state.marks, [{ at_s: 1, kind: "push" }, { at_s: 3, kind: "fall" }]);
  assert.deepEqual(state.base?.place, [1, 2, 0.4]);
});

test("what is not known is not made up", () => {
  const state = readState(message({ odometry: [], base: null, state: "dreams", recorded: 1, thing_poses: [] }));
  assert.equal(state.odometry, undefined);
  assert.equal(state.base, undefined);
  assert.equal(state.things.size, 0);
  assert.equal(state.state, "failed");
  assert.match(state.text, /'dreams'/);
  assert.equal(state.recorded_s, 12.345, "no less than the present");
  assert.equal(readState(message({ odometry: [NaN, 0, 0, 0] })).odometry, undefined);
});

test("what rests does not age", () => {
  assert.deepEqual(["playing", "paused", "busy", "failed"].map((state) => paceOf(readState(message({ state })))), [2, 0, 0, 0]);
});

function desk(values: Message) {
  const asked: [string, Message | undefined][] = [];
  const answer = async (service: string, args?: Message) => {
    asked.push([service, args]);
    return values;
  };
  return { asked, orders: new SimulationOrders({ call: answer, order: answer }) };
}

test("orders are what the services want", async () => {
  const { asked, orders } = desk({ success: true, message: "", result: { result: 1, error_message: "" } });
  await orders.play();
  await orders.pause();
  await orders.step(80);
  await orders.reset();
  await orders.setSpeed(0.5);
  await orders.seek(1.234);
  await orders.apply({ fault: { kind: "jam", duration_s: 0.002 } });
  assert.deepEqual(asked, [
    ["/simulation/set_simulation_state", { state: { state: 1 } }], ["/simulation/set_simulation_state", { state: { state: 2 } }], ["/simulation/step_simulation", { steps: 80 }],
    ["/simulation/reset_simulation", { scope: 0 }], ["/simulation/set_speed", { speed: 0.5 }], ["/simulation/seek", { time: 1.234 }],
    ["/simulation/apply", { event: '{"fault":{"kind":"jam","duration_s":0.002}}' }]]);
});

test("a result other than 1 refuses with its text; to be there already is no refusal", async () => {
  await assert.rejects(desk({ result: { result: 4, error_message: "it plays: pause it first" } }).orders.step(1), new Refused("it plays: pause it first"));
  await assert.rejects(desk({ result: { result: 2, error_message: "" } }).orders.reset(), /result 2/);
  await assert.rejects(desk({}).orders.step(1), Refused);
  await desk({ result: { result: 101, error_message: "plays already" } }).orders.play();
  await assert.rejects(desk({ result: { result: 101, error_message: "no" } }).orders.step(1), Refused);
});
