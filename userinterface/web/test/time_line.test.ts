// The time line's arithmetic, and how one gets to an instant.
import assert from "node:assert/strict";
import test from "node:test";
import { Seeker } from "../src/simulator/seeker.ts";
import { forgottenText, instantAt, lineEnd_s, markText, placeMarks, shareOf, tickEvery_s } from "../src/simulator/time_line.ts";

test("a place on the line is an instant that was simulated, to the millisecond", () => {
  const state = { recorded_s: 30.2 };
  assert.equal(instantAt(0.5, state), 15.1);
  assert.equal(instantAt(0.123456, state), 3.728);
  assert.equal(instantAt(-0.2, state), 0);
  assert.equal(instantAt(7, state), 30.2);
  assert.equal(instantAt(1, { recorded_s: 0.25 }), 0.25, "the line is longer than what there is");
  assert.equal(lineEnd_s({ recorded_s: 0.25 }), 1);
  assert.ok(instantAt(1, { recorded_s: 2.0007 }) <= 2.0007, "none that has not been simulated");
  assert.equal(shareOf(45, 30), 1);
});

test("what comes after the instant is told in seconds and milliseconds, where there is any", () => {
  assert.equal(forgottenText(12.345, 30.2), "The 17.855 s after this instant will be forgotten when it plays on.");
  assert.equal(forgottenText(30.2, 30.2), "");
});

test("marks of a kind that would lie on one another are one", () => {
  const marks = placeMarks([{ at_s: 5, kind: "push" }, { at_s: 1, kind: "push" }, { at_s: 1.01, kind: "push" }, { at_s: 2, kind: "fault" }], 10, 0.01);
  assert.deepEqual(marks.map(({ kind, count, share }) => [kind, count, share]), [["push", 2, 0.1], ["fault", 1, 0.2], ["push", 1, 0.5]]);
  assert.equal(markText(marks[0]!), "2 × push from 1.000 s");
  assert.equal(markText(marks[1]!), "fault at 2.000 s");
});

test("ticks are round, and ten at most", () => {
  assert.deepEqual([1, 9.5, 30, 100, 3000, 90_000].map(tickEvery_s), [0.1, 1, 5, 10, 300, 10_800]);
});

test("while the simulator is on its way only the newest wish is kept", async () => {
  const asked: number[] = [];
  let arrive: () => void = () => {};
  const seeker = new Seeker((time_s) => {
    asked.push(time_s);
    return new Promise((resolve) => (arrive = resolve));
  }, () => assert.fail("nothing fails"));
  const done = seeker.to(1);
  for (const time_s of [2, 3, 4]) void seeker.to(time_s);
  assert.equal(seeker.target_s, 4);
  assert.deepEqual(asked, [1]);
  arrive();
  await new Promise(setImmediate);
  assert.deepEqual(asked, [1, 4]);
  arrive();
  await done;
  seeker.told(1);
  assert.equal(seeker.target_s, 4, "a state of before it arrived");
  seeker.told(4.0004);
  assert.equal(seeker.target_s, undefined);
});

test("a state that is of another instant for long is believed", async () => {
  let now_ms = 0;
  const seeker = new Seeker(async () => {}, () => assert.fail("nothing fails"), () => now_ms);
  await seeker.to(5);
  seeker.told(7);
  assert.equal(seeker.target_s, 5);
  now_ms = 600;
  seeker.told(7.6);
  assert.equal(seeker.target_s, undefined);
});

test("a refused way there is told, and does not hold up the next", async () => {
  const failures: string[] = [];
  let refuse = true;
  const seeker = new Seeker(async () => {
    if (refuse) throw new Error("no such instant");
  }, (error) => failures.push(error.message));
  await seeker.to(1);
  assert.equal(seeker.target_s, undefined);
  refuse = false;
  await seeker.to(2);
  assert.deepEqual(failures, ["no such instant"]);
  assert.equal(seeker.target_s, 2);
});
