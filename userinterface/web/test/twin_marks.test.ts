// What a pre-flight's robots and the stages of what was sent are marked with.
import assert from "node:assert/strict";
import test from "node:test";
import { marksOf, marksText, stagesOf } from "../src/twin/flight_marks.ts";

const marks = (passed: number, tried: number, sendingText: string) => marksText(marksOf({ passed, tried, sendingText }));

test("who fell and who did not do it are told apart as far as the verdict tells", () => {
  assert.equal(marks(20, 20, "20 of 20 simulated robots stayed up and did it"), "20 stayed up and did it");
  assert.equal(marks(17, 20, "17 of 20 simulated robots stayed up and did it; robot 4: no way leads there"), "17 stayed up and did it, 3 did not do it");
  assert.equal(marks(19, 20, "19 of 20 simulated robots stayed up and did it; robot 4 fell after 3.20 s"), "19 stayed up and did it, 1 fell");
  assert.equal(marks(17, 20, "17 of 20 simulated robots stayed up and did it; robot 4 fell after 3.20 s"), "17 stayed up and did it, 1 fell, 2 fell or did not do it");
  assert.equal(marks(17, 20, "the pre-flight was ended by signal 9"), "17 stayed up and did it, 3 fell or did not do it");
  assert.equal(marks(0, 0, ""), "");
  assert.equal(marks(0, 4e9, ""), "1000 fell or did not do it", "a number that cannot be");
  assert.deepEqual(marksOf({ passed: 9, tried: 1, sendingText: "" }), ["up"]);
});

test("what failed is at the stage at which it failed", () => {
  const all = { passed: 20, tried: 20 }, none = { passed: 0, tried: 0 };
  assert.deepEqual(stagesOf({ sending: "failed", ...none }), ["bad", "", ""], "before there was a verdict");
  assert.deepEqual(stagesOf({ sending: "failed", ...all }), ["good", "good", "bad"]);
  assert.deepEqual(stagesOf({ sending: "sending", passed: 17, tried: 20 }), ["good", "bad", "now"], "with a reason");
  assert.deepEqual(stagesOf({ sending: "not passed", passed: 17, tried: 20 }), ["good", "bad", ""]);
  assert.deepEqual(stagesOf({ sending: "trying", ...none }), ["now", "", ""]);
  assert.deepEqual(stagesOf({ sending: "done", ...all }), ["good", "good", "good"]);
});
