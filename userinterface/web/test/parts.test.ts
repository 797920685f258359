// Small parts: bounds of the gait, hulls of soles, histories of plots, filters of events.
import assert from "node:assert/strict";
import test from "node:test";
import { gaitBounds } from "../src/bounds.ts";
import { FramePace } from "../src/scene/frame_pace.ts";
import { convexHull } from "../src/scene/polygon.ts";
import { strongest } from "../src/sticks.ts";
import { passes } from "../src/tabs/events_tab.ts";
import { History } from "../src/tabs/history.ts";
import { sizeText } from "../src/tabs/recordings_tab.ts";
import type { ViewFrame } from "../src/view_decoder.ts";

test("speeds that hold are those of the gait, and at most those of the robot API", () => {
  const told = { success: true, message: "", forward: 0.47, backward: 0.3125, left: 0.156, turn: 2.8 };
  assert.deepEqual(gaitBounds(told, { forward: 0.4, backward: 0.4, left: 0.4, turn: 2 }), { forward: 0.4, backward: 0.3125, left: 0.156, turn: 2 });
  assert.equal(gaitBounds({}, { forward: 0.4, backward: 0.3, left: 0.2, turn: 2 }).left, 0.2);
});

test("the hull of two soles is what is stood on", () => {
  const hull = convexHull([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5], [3, 0], [3, 1], [2, 0], [2, 1]]);
  assert.deepEqual(hull, [[0, 0], [3, 0], [3, 1], [0, 1]]);
  assert.deepEqual(convexHull([]), []);
});

test("of several sticks the one that is held farthest counts", () => {
  assert.deepEqual(strongest([{ ahead: 0.1, left: 0, turn: 0 }, undefined, { ahead: 0, left: 0, turn: -0.5 }]), { ahead: 0, left: 0, turn: -0.5 });
});

test("a history gives the newest seconds, and begins anew with the robot's clock", () => {
  const history = new History([{ name: "x", value: (frame) => frame.com[0] }]);
  const add = (time_s: number, x: number) => history.add({ robot_time: [time_s], com: [x] } as unknown as ViewFrame);
  for (let i = 0; i <= 100; ++i) add(i / 10, i);
  assert.deepEqual(history.data([0], 0.2), [[9.8, 9.9, 10], [98, 99, 100]]);
  add(10.1, NaN);
  assert.equal(history.data([0], 0)[1]?.[0], null);
  add(11.1, 5);
  assert.deepEqual(history.data([0], 0.6), [[10.6, 11.1], [null, 5]]);
  add(0.1, 7);
  assert.deepEqual(history.data([0], 100), [[0.1], [7]]);
});

test("events pass by their level and by all of the words", () => {
  const event = { time_s: 1, level: 30, source: "stability", text: "Trim limited" };
  assert.ok(passes(event, 30, "trim STAB") && passes(event, 0, ""));
  assert.ok(!passes(event, 40, "") && !passes(event, 0, "trim api"));
});

test("the picture gets coarser where the computer does not keep up, and finer again later", () => {
  const pace = new FramePace();
  const run = (from_ms: number, until_ms: number, drawEvery_ms: number) => {
    for (let now_ms = from_ms, draw_ms = from_ms; now_ms < until_ms; now_ms += 33) {
      pace.wish();
      if (now_ms < draw_ms) continue;
      pace.drew(now_ms);
      draw_ms = now_ms + drawEvery_ms;
    }
  };
  run(0, 5000, 30);
  assert.equal(pace.fineness, 1);
  run(5000, 30_000, 120);
  assert.equal(pace.fineness, 0.5);
  assert.ok(pace.perSecond < 10);
  run(30_000, 150_000, 30);
  assert.equal(pace.fineness, 1);
});

test("nothing new to draw is no slowness", () => {
  const pace = new FramePace();
  for (let now_ms = 0; now_ms < 20_000; now_ms += 500) pace.drew(now_ms);
  assert.equal(pace.fineness, 1);
  assert.equal(pace.isDue(19_510), false);
});

test("sizes in words", () => assert.deepEqual([12, 999_999, 2_500_000].map(sizeText), ["1 kB", "1000 kB", "2.5 MB"]));
