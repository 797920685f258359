// A held stick moves the robot, and whatever ends that ends it until the stick is let go.
import assert from "node:assert/strict";
import test from "node:test";
import { Drive, sendEvery_ms, standstill, velocityOf, type Velocity } from "../src/drive.ts";

const ahead: Velocity = { forward: 0.2, left: 0, turn: 0 };

test("asks for the command, waits for it, drives, and stands when let go", () => {
  const drive = new Drive();
  assert.equal(drive.hold(ahead, false), true);
  assert.equal(drive.hold(ahead, false), false, "asks once");
  assert.equal(drive.due(0), undefined);
  drive.granted();
  assert.deepEqual(drive.due(0), ahead);
  assert.deepEqual(drive.letGo(), standstill);
  assert.equal(drive.state, "rests");
});

test("sends on and on while it is held, with what is held then", () => {
  const drive = new Drive();
  drive.hold(ahead, true);
  assert.deepEqual(drive.due(100), ahead);
  assert.equal(drive.due(100 + sendEvery_ms - 1), undefined);
  drive.hold({ ...ahead, turn: 0.5 }, true);
  assert.deepEqual(drive.due(100 + sendEvery_ms), { ...ahead, turn: 0.5 });
});

test("what ended it does not begin again by itself", () => {
  const drive = new Drive();
  drive.hold(ahead, true);
  assert.equal(drive.end(), true);
  assert.equal(drive.state, "blocked");
  drive.hold(ahead, true);
  drive.granted();
  assert.equal(drive.due(1e6), undefined);
  assert.equal(drive.letGo(), undefined, "nothing is sent for it either");
  drive.hold(ahead, true);
  assert.deepEqual(drive.due(1e6), ahead);
});

test("let go before it was granted: a late grant moves nothing", () => {
  const drive = new Drive();
  drive.hold(ahead, false);
  assert.equal(drive.letGo(), undefined);
  drive.granted();
  assert.equal(drive.state, "rests");
  assert.equal(drive.due(0), undefined);
});

test("ending what rests blocks nothing", () => {
  const drive = new Drive();
  assert.equal(drive.end(), false);
  assert.equal(drive.state, "rests");
});

test("the stick's place is a share of what holds in its direction", () => {
  const bounds = { forward: 0.4, backward: 0.2, left: 0.1, turn: 1.5 };
  assert.deepEqual(velocityOf({ ahead: -1, left: 0.5, turn: 2 }, bounds), { forward: -0.2, left: 0.05, turn: 1.5 });
});

test("a velocity that comes too late is nothing, and a row of them as long as one holds ends the drive", () => {
  const drive = new Drive();
  const ahead = { forward: 0.2, left: 0, turn: 0 };
  drive.hold(ahead, true);
  for (const now_ms of [1000, 1080, 2000, 2080, 2400]) assert.equal(drive.late(now_ms, 500), false);
  assert.deepEqual(drive.due(2480), ahead);
  assert.equal(drive.late(2500, 500), true);
  assert.equal(drive.state, "blocked");
  assert.equal(drive.due(2600), undefined);
  assert.equal(drive.late(2600, 500), false, "told once");
});
