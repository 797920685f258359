// Where the world lies under the robot's odometry, and how gently it gets there.
import assert from "node:assert/strict";
import test from "node:test";
import { inverseOf, outOf, WorldFrame } from "../src/simulator/world_frame.ts";

const near = (is: object, expected: Record<string, number>, within = 1e-9) => {
  const values = is as Record<string, number>;
  for (const [key, value] of Object.entries(expected)) assert.ok(Math.abs(values[key]! - value) < within, `${key} is ${values[key]}, not ${value}`);
};

test("there and back again is where one was", () => {
  const odometry = { x: 0.4, y: -0.7, z: 0.02, yaw: 2.1 };
  const place = { x: 1.5, y: -2.5, z: 0.3 };
  near(outOf(inverseOf(odometry), outOf(odometry, place)), place);
  near(outOf({ x: 1, y: 0, z: 0, yaw: Math.PI / 2 }, { x: 2, y: 0, z: 0 }), { x: 1, y: 2, z: 0 });
});

test("drift is followed within a second, without a jump", () => {
  const frame = new WorldFrame();
  assert.equal(frame.after(0.1), undefined, "nothing is known yet");
  frame.take({ x: 0, y: 0, z: 0, yaw: 3.1 }, 1);
  near(frame.after(0)!, { x: 0, yaw: 3.1 });
  frame.take({ x: 0.05, y: 0, z: 0, yaw: -3.1 }, 1); // by 0.083 rad, over the half turn
  const shown = { ...frame.after(0.033)! };
  assert.ok(shown.x > 0.002 && shown.x < 0.02, `${shown.x}`);
  assert.ok(shown.yaw > 3.1 && shown.yaw < 3.13, "the short way round");
  for (let i = 0; i < 60; ++i) frame.after(0.033);
  near(frame.after(0.033)!, { x: 0.05 }, 1e-4);
});

test("another run, or more than drift, is a jump", () => {
  const frame = new WorldFrame();
  frame.take({ x: 0, y: 0, z: 0, yaw: 0 }, 1);
  assert.equal(frame.take({ x: 0.01, y: 0, z: 0, yaw: 0 }, 1), false);
  assert.equal(frame.take({ x: 0.05, y: 0, z: 0, yaw: 0 }, 2), true);
  near(frame.after(0)!, { x: 0.05 });
  frame.take({ x: 2, y: 0, z: 0, yaw: 0 }, 2);
  near(frame.after(0)!, { x: 2 });
  frame.take(undefined, 3);
  near(frame.after(0)!, { x: 2 });
});
