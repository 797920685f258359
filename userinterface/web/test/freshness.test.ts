// Old is shown as old, and a dead connection is never green.
import assert from "node:assert/strict";
import test from "node:test";
import { ageText, Freshness } from "../src/freshness.ts";
import type { ViewFrame } from "../src/view_decoder.ts";

function frame(number: number, ages_s = [0.01, 0.01, 0.01, 5, 0.01], roundTrip_s = NaN): ViewFrame {
  return { frame: [number], age: ages_s, round_trip: [roundTrip_s] } as unknown as ViewFrame;
}

test("nothing has come: lost, and infinitely old", () => {
  const freshness = new Freshness();
  assert.equal(freshness.state(0), "lost");
  assert.equal(freshness.pictureAge_ms(0), Infinity);
});

test("a frame is live, grows old, and is lost", () => {
  const freshness = new Freshness();
  freshness.take(frame(1), 1000);
  assert.equal(freshness.state(1010), "live");
  assert.equal(freshness.state(1280), "live");
  assert.equal(freshness.state(1300), "old");
  assert.equal(freshness.state(2001), "lost");
});

test("what is old at the robot is old here, however young the frame is", () => {
  const freshness = new Freshness();
  freshness.take(frame(1, [0.01, 0.35, 0.01, 0.01, 0.01]), 1000);
  assert.equal(freshness.state(1001), "old");
  freshness.take(frame(2, [0.01, NaN, 0.01, 0.01, 0.01]), 1033);
  assert.equal(freshness.state(1034), "old");
});

test("the way from the robot counts", () => {
  const freshness = new Freshness();
  freshness.take(frame(1, [0, 0, 0, 0, 0], 0.2), 1000);
  assert.equal(Math.round(freshness.pictureAge_ms(1050)), 150);
});

test("an ended socket is lost at once, and what was missed is counted", () => {
  const freshness = new Freshness();
  freshness.take(frame(10), 1000);
  freshness.take(frame(13), 1100);
  assert.equal(freshness.loss.frames, 2);
  freshness.disconnected(1200);
  assert.equal(freshness.state(1201), "lost");
  freshness.take(frame(100), 3100);
  assert.equal(freshness.state(3100), "live");
  assert.deepEqual(freshness.loss, { frames: 2, outages: 1, longest_ms: 2000 });
});

test("a silence without an end of the socket is an outage, too", () => {
  const freshness = new Freshness();
  freshness.take(frame(1), 1000);
  freshness.take(frame(2), 4000);
  assert.deepEqual(freshness.loss, { frames: 0, outages: 1, longest_ms: 3000 });
});

test("ages in words", () => {
  assert.deepEqual([Infinity, 12.4, 999, 1234, 125_000].map(ageText), ["never", "12 ms", "999 ms", "1.2 s", "2 min"]);
});

test("a simulated robot gets old as fast as its time passes, and not at all while it rests", () => {
  const freshness = new Freshness();
  freshness.take(frame(1, [1.2, 1.2, 1.2, 1.2, 1.2]), 1000);
  assert.equal(freshness.state(1010), "old");
  freshness.pace = 0.1;
  assert.equal(freshness.state(1010), "live");
  freshness.pace = 40;
  assert.equal(freshness.pictureAge_ms(1010), 1210, "no faster than ours");
  freshness.pace = 0;
  freshness.take(frame(2, [NaN, NaN, NaN, NaN, NaN]), 1033);
  assert.equal(freshness.state(1043), "live");
  assert.equal(freshness.state(2100), "lost", "nothing comes, whether it rests or not");
});
