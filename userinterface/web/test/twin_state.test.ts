// What /simulation/twin tells, with all that may be unknown in it; whether real and simulated agree; what people are told of it.
import assert from "node:assert/strict";
import test from "node:test";
import { agreementOf, valueText, worstFirst } from "../src/twin/agreement.ts";
import { isWarning, tidingsOf } from "../src/twin/tidings.ts";
import { isBusy, readTwin } from "../src/twin/twin_state.ts";
import type { Message } from "../src/rosbridge.ts";

const message = (more: Message = {}): Message => ({
  robot: "ws://10.0.0.7:9090", state: "connected", text: "", age: 0.04, activity: "walks", commander: "page 07ab", follows: true, follows_text: "", base: [1, 2, 0.4, 0, 0, 0, 1], joints: [0.1, null],
  lag: 0.14, channels: ["left_knee", "pitch", "left foot", "place", "heading"], units: ["rad", "rad", "N", "m", "rad"], measured: [0.5, 0.01, 30, 0.002, null], simulated: [0.44, 0.02, 35, 0, 1],
  difference: [0.06, 0.01, 5, null, 0.2], limits: [0.035, 0.05, 4, 0.05, 0], told_times: [9, 3], told_texts: ["earlier", "later"],
  sending: "idle", sending_what: "", sending_text: "", passed: 0, tried: 0, picture: 0, ...more,
});
const state = (more: Message = {}) => readTwin(message(more));

test("the state reads as it was told, what was told last comes first", () => {
  const read = state();
  assert.deepEqual([read.link, read.age_s, read.lag_s, read.activity, read.commander, read.follows], ["connected", 0.04, 0.14, "walks", "page 07ab", true]);
  assert.deepEqual(read.base, { place: [1, 2, 0.4], turn: [0, 0, 0, 1] });
  assert.deepEqual(read.joints, [0.1, NaN], "a joint that is not known is not at 0");
  assert.deepEqual(read.channels[0], { name: "left_knee", unit: "rad", measured: 0.5, simulated: 0.44, difference: 0.06, limit: 0.035 });
  assert.deepEqual(read.told, [{ at_s: 3, text: "later" }, { at_s: 9, text: "earlier" }], "in the order of the message, whatever the times");
});

test("null is not known, and never 0", () => {
  const read = state({ age: null, lag: null, base: [], joints: [], measured: [null], simulated: null, difference: [null], limits: [null], passed: null, picture: null });
  assert.deepEqual([read.age_s, read.lag_s], [NaN, NaN]);
  assert.deepEqual([read.base, read.joints], [undefined, undefined]);
  assert.equal(state({ base: [1, 2, null, 0, 0, 0, 1] }).base, undefined);
  assert.deepEqual(read.channels.map(({ measured, simulated, difference, limit }) => [measured, simulated, difference, limit]), Array(5).fill([NaN, NaN, NaN, 0]));
  assert.deepEqual([read.passed, read.picture], [0, 0]);
});

test("a state that this page does not know is no connection, and says so", () => {
  const read = state({ state: "dreams", sending: "dreaming" });
  assert.deepEqual([read.link, read.sending], ["lost", "idle"]);
  assert.match(read.text, /'dreams'/);
  assert.deepEqual(readTwin({}).channels, []);
});

test("the worst share of its limit comes first; what is not known or never told comes last", () => {
  assert.deepEqual(worstFirst(state().channels).map(({ name }) => name), ["left_knee", "left foot", "pitch", "place", "heading"]);
});

test("values have the units that people read", () => {
  assert.deepEqual([valueText(0.06, "rad"), valueText(-0.06, "rad"), valueText(0.0123, "m"), valueText(34.4, "N"), valueText(0.5, "A"), valueText(NaN, "rad"), valueText(-0.0001, "rad")],
    ["3.4°", "−3.4°", "0.01 m", "34 N", "0.50 A", "–", "0.0°"]);
});

test("the verdict is of what is known now, and only of that", () => {
  const differ = agreementOf(state(), 0.04);
  assert.equal(differ.verdict, "differ");
  assert.equal(differ.text, "2 of 3 differ. Most of all: left knee, 3.4° (limit 2.0°).");
  assert.equal(differ.short, "left knee differs by 3.4°");
  const agree = agreementOf(state({ difference: [0.007, 0.01, 1, 0, 3] }), 0.04);
  assert.deepEqual([agree.verdict, agree.short], ["agree", "Real and simulated agree"]);
  for (const difference of [[], [0.06, 0.01, 5, null, 0.2]]) {
    const none = agreementOf(state({ difference, follows: false }), 0.04);
    assert.deepEqual([none.verdict, none.short], ["unknown", "Not compared"]);
    assert.match(none.text, /^Not compared: the simulated robot does not do what the robot there does/);
    const why = agreementOf(state({ difference, follows: false, follows_text: "the simulation is paused" }), 0.04);
    assert.deepEqual([why.verdict, why.short, why.text], ["unknown", "Not compared: the simulation is paused", "Not compared: the simulation is paused."]);
  }
  assert.equal(agreementOf(state({ difference: [] }), 0.04).verdict, "unknown");
  for (const age_s of [0.51, NaN]) assert.equal(agreementOf(state(), age_s).verdict, "lost", "it is old");
  assert.deepEqual(["connecting", "lost", "refused"].map((link) => agreementOf(state({ state: link }), 0.04).verdict), ["lost", "lost", "lost"]);
});

test("a place and a heading that differ are told as people say it", () => {
  const more = { channels: ["left_knee", "place x", "place y", "heading"], units: ["rad", "m", "m", "rad"], limits: [0.035, 0.25, 0.25, 0.349] };
  const agreement = (difference: (number | null)[]) => agreementOf(state({ ...more, difference }), 0.04);
  assert.equal(agreement([0.01, 0.36, 0.48, 0.1]).short, "stands 0.6 m beside");
  assert.equal(agreement([0.01, 0.36, 0.48, 0.1]).text, "2 of 4 differ. Most of all: place y, 0.48 m (limit 0.25 m).");
  assert.equal(agreement([0.01, null, 0.3, 0.1]).short, "stands 0.3 m beside");
  assert.equal(agreement([0.01, 0, 0, 0.5]).short, "looks 29° aside");
  assert.equal(agreement([0.01, 0.1, 0.1, 0.1]).verdict, "agree");
});

test("a link that is there and what was done are no warnings", () => {
  assert.deepEqual(["connected", "connected: release 1", "motion kick: done", "motion kick: done: 20 of 20 simulated robots stayed up and did it"].filter(isWarning), []);
  const warnings = ["lost: nothing has come for 1.0 s", "left_knee by 3.4 deg", "motion kick: failed: it is not done yet", "motion kick: not passed: 17 of 20", "disconnected"];
  assert.deepEqual(warnings.filter(isWarning), warnings);
});

test("people are told what changes, once", () => {
  const told = (before: Message, after: Message) => tidingsOf(state(before), state(after)).map(({ text, weight }) => `${weight}: ${text}`);
  assert.deepEqual(told({}, {}), []);
  assert.deepEqual(told({}, { state: "lost", text: "no answer" }), ["bad: The robot there is lost: no answer. It is tried again by itself."]);
  assert.match(told({ state: "connecting" }, { state: "refused", text: "another robot" })[0]!, /^bad: .*another robot.*Connect again/);
  assert.deepEqual(told({ state: "lost" }, {}), ["good: The robot there is connected: ws://10.0.0.7:9090"]);
  assert.deepEqual(told({}, { follows: false, follows_text: "the simulation is paused" }), ["plain: The simulated robot does not follow any more: the simulation is paused"]);
  assert.deepEqual(told({}, { follows: false }), [], "a person has ended it");
  const tried = { sending: "trying", sending_what: "motion kick" };
  assert.deepEqual(told(tried, { ...tried, sending: "not passed", sending_text: "17 of 20 stayed up" }), ["bad: Not sent: motion kick: 17 of 20 stayed up"]);
  assert.deepEqual(told(tried, { ...tried, sending: "failed", sending_text: "the link was lost" }), ["bad: Sending has failed: motion kick: the link was lost"]);
  assert.deepEqual(["idle", "trying", "sending", "done", "not passed", "failed", "stopped"].map((sending) => isBusy(state({ sending }))), [false, true, true, false, false, false, false]);
});
