// Pushes: strength and direction of drags, and the frame that the robot gets them in.
import assert from "node:assert/strict";
import test from "node:test";
import { forceOfDrag, heading_rad, inHeading, pushRequest, sizeOf, type Flat } from "../src/push.ts";

const bounds = { least: 0.1, most: 200, usual: 20, shortest: 0.01, longest: 2 };
const near = (is: Flat, expected: Flat) => {
  for (const axis of [0, 1] as const) assert.ok(Math.abs(is[axis] - expected[axis]) < 1e-9, `${is} is not ${expected}`);
};

test("a tap pushes away from the camera, with the strength that is set", () => {
  near(forceOfDrag(0, 0, [0, 1], 50, bounds), [0, 50]);
  near(forceOfDrag(3, -3, [1, 0], 20, bounds), [20, 0]);
});

test("a drag pushes where it goes: right to the right, up away, down towards; a pixel is a newton", () => {
  near(forceOfDrag(30, 0, [1, 0], 50, bounds), [0, -30]);
  near(forceOfDrag(30, 0, [0, 1], 50, bounds), [30, 0]);
  near(forceOfDrag(0, 40, [0, 1], 50, bounds), [0, 40]);
  near(forceOfDrag(0, -40, [0, 1], 50, bounds), [0, -40]);
  near(forceOfDrag(30, 40, [1, 0], 50, bounds), [40, -30]);
});

test("no push is stronger or weaker than the simulator takes", () => {
  assert.equal(sizeOf(forceOfDrag(0, 900, [1, 0], 50, bounds)), 200);
  assert.equal(sizeOf(forceOfDrag(0, 0, [1, 0], 0, bounds)), 0.1);
});

test("the robot gets the force as it looks itself", () => {
  const half = Math.SQRT1_2;
  assert.ok(Math.abs(heading_rad([0, 0, half, half]) - Math.PI / 2) < 1e-12);
  assert.equal(heading_rad([0, 0.5, 0, Math.sqrt(0.75)]), 0, "a nod is no turn");
  near(inHeading([0, 10], Math.PI / 2), [10, 0]);
  near(inHeading(inHeading([3, 4], 0.7), -0.7), [3, 4]);
  assert.deepEqual(pushRequest("trunk", [10, -1]), { link: "trunk", force: { x: 10, y: -1, z: 0 }, duration: 0.1, frame: "heading" });
});
