// What is said to be wrong between page and robot, and a calibration in words.
import assert from "node:assert/strict";
import test from "node:test";
import { gainText, offsetText, rollPitchYaw, summaryText, zeroText } from "../src/calibration.ts";
import { otherVersionText, pageVersion } from "../src/page_version.ts";
import { troubleOf, type LinkState } from "../src/trouble.ts";

const link = (state: LinkState["state"], text: string, seconds = 5): LinkState => ({ state, text, link: "unix:/run/link", seconds });
const known = { linkTold_ms: 1000, certificate: "" };

test("a link that is up is no trouble, and nothing is said while nothing is known", () => {
  assert.equal(troubleOf(known, 1000), undefined);
  assert.equal(troubleOf({ ...known, link: link("up", "") }, 1000), undefined);
});

test("a link that is down says why and for how long, by the robot's count and this page's", () => {
  assert.deepEqual(troubleOf({ ...known, link: link("down", "nobody listens at /run/link") }, 3000),
    { text: "The robot is not there: nobody listens at /run/link.", age: "For 7.0 s.", weight: "bad", action: undefined });
  assert.equal(troubleOf({ ...known, link: link("down", "is it on?") }, 3000)?.text, "The robot is not there: is it on?");
  assert.match(troubleOf({ ...known, link: link("down", "x"), certificate: "the certificate expired" }, 1000)?.text ?? "", /: x\. The certificate expired\.$/);
  assert.match(troubleOf({ ...known, link: link("refused", "refused: a robot has one") }, 1000)?.text ?? "", /refused: a robot has one/);
});

test("a page of another version goes before all else, and can only be loaded again", () => {
  const trouble = troubleOf({ ...known, link: link("down", "x"), certificate: "y", otherVersion: otherVersionText("0123") }, 1000);
  assert.equal(trouble?.action, "reload");
  assert.equal(trouble?.weight, "bad");
  assert.match(trouble?.text ?? "", /the robot has page 0123.*load the page again.*Stop still works/);
  assert.match(otherVersionText(""), /an older page, without a version/);
  assert.equal(pageVersion, "", "the bundle alone has one");
});

test("what does not keep the robot away is a caution that can be hidden", () => {
  assert.deepEqual(troubleOf({ ...known, link: link("up", "another calibration"), certificate: "the certificate expires" }, 1000),
    { text: "Another calibration. The certificate expires.", weight: "caution", action: "hide" });
});

test("calibrated values have signs, units and deviations, and what has none is as described", () => {
  assert.equal(zeroText({ value: [-Math.PI / 360], deviation: [Math.PI / 3600] }), "−0.500 ± 0.050");
  assert.equal(zeroText({ value: [Math.PI / 360], deviation: null }), "+0.500");
  assert.equal(zeroText(null), "as described");
  assert.equal(offsetText({ value: [0.004, -0.002, 0.01], deviation: [0.001, 0.001, 0.003] }, 1), "−2.0 ± 1.0");
  assert.equal(gainText({ value: [1.01, 0.99, 1, 1], deviation: null }, 1), "0.990");
});

test("a turn is told as roll, pitch and yaw", () => {
  const half = Math.SQRT1_2;
  assert.deepEqual(rollPitchYaw([0, 0, 0, 1]), [0, 0, 0]);
  assert.deepEqual(rollPitchYaw([half, 0, 0, half]).map(Math.round), [90, 0, 0]);
  assert.deepEqual(rollPitchYaw([0, half, 0, half]).map(Math.round), [0, 90, 0]);
  assert.deepEqual(rollPitchYaw([0, 0, -half, half]).map(Math.round), [0, 0, -90]);
});

test("a robot without a calibration is said to have none", () => {
  const robot = { joints: [], trunk_com_offset: null, feet: [], imu: { link: "trunk", place: [0, 0, 0], turn: [0, 0, 0, 1] } } as const;
  const of = (there: boolean, made: string | null) => summaryText({ ...robot, there, made } as unknown as Parameters<typeof summaryText>[0]);
  assert.match(of(false, null), /has no calibration/);
  assert.equal(of(true, null), "Calibrated; its file does not say when.");
  assert.equal(of(true, "2026-11-25T03:21:29Z"), "Calibrated, made 2026-11-25 03:21 UTC.");
  assert.equal(of(true, "2026-11-25"), "Calibrated, made 2026-11-25.");
});
