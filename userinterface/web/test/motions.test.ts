// Motions that are shown before they are played.
import assert from "node:assert/strict";
import test from "node:test";
import { motionText, postureAt, rising, timeInMotion, type MotionPostures, type Posture } from "../src/motions.ts";

const posture = (angle: number, support: Posture["support"]): Posture => ({ joints: [angle, -angle], feet: [[0, 0.05, 0, 0], [angle, -0.05, 0, 0]], support });
const motion: MotionPostures = { period: 0.05, postures: [posture(0, 3), posture(0.1, 3), posture(0.3, 2)] };

test("between two postures a joint is in between, and at the ends it stays", () => {
  assert.deepEqual(postureAt(motion, 0.025).joints, [0.05, -0.05]);
  assert.ok(Math.abs((postureAt(motion, 0.075).feet[1][0]) - 0.2) < 1e-12);
  assert.equal(postureAt(motion, 0.075).support, 3);
  assert.deepEqual(postureAt(motion, 9).joints, [0.3, -0.3]);
  assert.equal(postureAt(motion, -1).joints[0], 0);
});

test("a preview rests at the end, and begins anew", () => {
  assert.equal(timeInMotion(0.05, motion), 0.05);
  assert.equal(timeInMotion(0.5, motion), 0.1);
  assert.ok(Math.abs(timeInMotion(0.95, motion) - 0.05) < 1e-9);
});

test("the trunk rises until feet stand", () => {
  assert.equal(rising(motion, 0), 0);
  assert.equal(rising(motion, 0.05), 0.5);
  assert.equal(rising(motion, 0.1), 1);
});

test("duration and start are told, or why there is no preview", () => {
  assert.equal(motionText({ name: "wave", description: "Waves.", duration: 3.24, start: "stands" }), "Waves. 3.2 s; begins when the robot stands.");
  assert.match(motionText({ name: "rise", duration: 3, start: "lies on its back" }), /begins when the robot lies on its back\. On the ground .* roughly/);
  assert.equal(motionText({ name: "x", refused: "it is damaged" }), "No preview: it is damaged.");
});
