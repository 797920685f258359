// Where the picture's frame lies in the world: from what the picture showed at the instant of which the simulator tells.
import assert from "node:assert/strict";
import test from "node:test";
import type { Turn } from "../src/description.ts";
import { originOf, ViewTrail } from "../src/simulator/view_trail.ts";
import { outOf } from "../src/simulator/world_frame.ts";

const about = (yaw: number): Turn => [0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2)];
const frame = (time_s: number, x: number, y = 0, yaw = 0) => ({ robot_time: [time_s], base_place: [x, y], base_height: [0.36], base_turn: about(yaw) as number[] });
const state = (time_s: number, x: number, more = {}) => ({ time_s, state: "playing" as const, speed: 1, base: { place: [x, 0, 0.38] as [number, number, number], turn: about(0) }, ...more });
const near = (is: number | undefined, expected: number) => assert.ok(is !== undefined && Math.abs(is - expected) < 1e-9, `${is} is not ${expected}`);

test("what is seen at its place in that frame is where it truly is", () => {
  const [base, seen] = [{ x: 2, y: -1, z: 0.38, yaw: 2.9 }, { x: 0.3, y: 0.7, z: 0.36, yaw: -2.8 }];
  const origin = originOf(base, seen);
  const there = outOf(origin, seen);
  near(there.x, 2);
  near(there.y, -1);
  near(there.z, 0.38);
  near(Math.sin(origin.yaw + seen.yaw - base.yaw), 0);
});

test("the frame of that very instant counts: between two, what lies between", () => {
  const trail = new ViewTrail();
  trail.take(frame(1.0, 0.1));
  trail.take(frame(1.1, 0.3));
  near(trail.originFor(state(1.05, 5))?.x, 4.8);
  near(trail.originFor(state(1.05, 5))?.z, 0.02);
  near(trail.originFor(state(1.13, 5))?.x, 4.7);
  assert.equal(trail.originFor(state(1.2, 5)), undefined, "no frame tells of so late");
  near(trail.originFor(state(1.4, 5, { speed: 10 }))?.x, 4.7);
  assert.equal(trail.originFor(state(0.5, 5)), undefined, "nor of so early");
  assert.equal(trail.originFor(state(1.05, 5, { base: undefined })), undefined);
});

test("while it is paused the last frame counts, as often as it comes", () => {
  const trail = new ViewTrail();
  for (let i = 0; i < 200; ++i) trail.take(frame(2.5, 0.2));
  near(trail.originFor(state(2.5, 1, { state: "paused" }))?.x, 0.8);
  trail.take(frame(2.5, 0.1)); // the link began anew, and with it this odometry
  near(trail.originFor(state(2.5, 1, { state: "paused" }))?.x, 0.9);
});

test("time that goes back, or is put elsewhere, begins a new trail; a robot that lies tells no heading", () => {
  const trail = new ViewTrail();
  trail.take(frame(9, 3));
  trail.take(frame(2, 0.5));
  assert.equal(trail.originFor(state(9, 5)), undefined);
  near(trail.originFor(state(2, 5))?.x, 4.5);
  trail.take({ ...frame(2.03, 0.6), base_turn: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
  near(trail.originFor(state(2.03, 5))?.x, 4.5);
  assert.equal(trail.originFor(state(2, 5, { base: { place: [0, 0, 0.1], turn: [0, Math.SQRT1_2, 0, Math.SQRT1_2] } })), undefined);
  trail.forget();
  assert.equal(trail.originFor(state(2, 5)), undefined);
});
