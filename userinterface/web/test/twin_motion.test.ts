// What the page keeps of the robot there over time: the last minute for plots, the pose that is drawn, and the last walk that was driven here.
import assert from "node:assert/strict";
import test from "node:test";
import type { Turn } from "../src/description.ts";
import { LastWalk } from "../src/twin/last_walk.ts";
import { PoseFollower } from "../src/twin/pose_follower.ts";
import { TwinHistory } from "../src/twin/twin_history.ts";
import type { Channel } from "../src/twin/twin_state.ts";

const channel = (name: string, unit: string, measured: number, simulated: number): Channel => ({ name, unit, measured, simulated, difference: 0, limit: 1 });
const near = (value: number | null | undefined, wanted: number, least = 1e-9) => assert.ok(value != null && Math.abs(value - wanted) < least, `${value}, not ${wanted}`);

test("the history has a minute, in the units that are shown", () => {
  const history = new TwinHistory();
  for (let i = 0; i <= 900; ++i) history.add([channel("knee", "rad", i / 1000, 0.1), channel("place", "m", 0.01, NaN)], i / 10);
  const { times_s, measured, simulated, difference } = history.of(0, 90);
  assert.equal(times_s.length, 601);
  near(times_s[0], -60);
  near(times_s.at(-1), 0);
  near(measured.at(-1), (0.9 * 180) / Math.PI);
  near(simulated.at(-1), (0.1 * 180) / Math.PI);
  near(difference.at(-1), (0.8 * 180) / Math.PI);
  const place = history.of(1, 90);
  near(place.measured[0], 0.01);
  assert.deepEqual([place.simulated[0], place.difference[0]], [null, null], "what is not known is not 0");
});

test("no curve is drawn through what was not heard, and other channels begin anew", () => {
  const history = new TwinHistory();
  history.add([channel("knee", "rad", 1, 1)], 1);
  history.add([], 1.1);
  history.add([channel("knee", "rad", 1, 1)], 3);
  assert.deepEqual(history.of(0, 3).measured.map((value) => value === null), [false, true, false]);
  history.add([channel("hip", "rad", 1, 1)], 3.1);
  assert.equal(history.of(0, 3.1).times_s.length, 1);
});

test("the difference of angles is the short way round", () => {
  const history = new TwinHistory();
  history.add([channel("heading", "rad", 3.1, -3.1)], 0);
  near(history.of(0, 0).difference[0], ((6.2 - 2 * Math.PI) * 180) / Math.PI);
});

const turned = (yaw: number): Turn => [0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2)];
const pose = (x: number, yaw = 0, joint = 0) => ({ base: { place: [x, 0, 0.4] as [number, number, number], turn: turned(yaw) }, joints: [joint] });

test("it is drawn evenly between two states, in as long as they are apart", () => {
  const follower = new PoseFollower();
  assert.equal(follower.at(0), undefined);
  follower.take(pose(0), 0);
  near(follower.at(0)?.base.place[0], 0);
  follower.take(pose(0.1, 0.4, 1), 100);
  near(follower.at(100)?.base.place[0], 0);
  const half = follower.at(150)!;
  near(half.base.place[0], 0.05);
  near(half.joints[0], 0.5);
  near(2 * Math.atan2(half.base.turn[2], half.base.turn[3]), 0.2);
  assert.equal(follower.arrived(150), false);
  follower.take(pose(0.2, 0.8, 2), 200);
  near(follower.at(250)?.base.place[0], 0.15, 1e-6);
  near(follower.at(900)?.base.place[0], 0.2);
  assert.equal(follower.arrived(900), true);
});

test("a state that comes early makes no jump; another place and what is unknown do", () => {
  const follower = new PoseFollower();
  follower.take(pose(0), 0);
  follower.take(pose(0.1), 100);
  follower.take(pose(0.2), 150);
  near(follower.at(150)?.base.place[0], 0.05);
  follower.take(pose(3), 300);
  near(follower.at(300)?.base.place[0], 3);
  follower.forget();
  assert.equal(follower.at(301), undefined);
  follower.take({ ...pose(0), joints: [NaN] }, 400);
  follower.take(pose(0, 0, 1), 500);
  near(follower.at(520)?.joints[0], 1); // it was not known where it was
});

test("turns go the short way, also where the numbers have the other sign", () => {
  const follower = new PoseFollower();
  follower.take(pose(0, 0.2), 0);
  follower.take({ base: { place: [0, 0, 0.4], turn: turned(0.4).map((value) => -value) as Turn }, joints: [0] }, 100);
  const { turn } = follower.at(150)!.base;
  near(2 * Math.atan2(turn[2] * Math.sign(turn[3]), Math.abs(turn[3])), 0.3, 1e-3);
});

test("the last walk is its mean velocity, for as long as it was held", () => {
  const walk = new LastWalk();
  const last = () => walk.walk;
  assert.equal(last(), undefined);
  walk.take({ forward: 0.2, left: 0, turn: 0 }, 1000);
  assert.equal(last(), undefined, "it is not over");
  walk.take({ forward: 0.2, left: 0, turn: 0.4 }, 3000);
  walk.take({ forward: 0, left: 0, turn: 0 }, 5000);
  assert.deepEqual(last(), { forward: 0.2, left: 0, turn: 0.2, duration_s: 4 });
  walk.take({ forward: 0, left: 0, turn: 0 }, 9000);
  assert.deepEqual(last()?.duration_s, 4, "standing is no walk");
  walk.take({ forward: 0, left: -0.1, turn: 0 }, 10_000);
  walk.take({ forward: 0, left: 0, turn: 0 }, 10_200);
  assert.deepEqual(last(), { forward: 0, left: -0.1, turn: 0, duration_s: 1 });
});
