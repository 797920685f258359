// Faults and things as the scenario events that they make.
import assert from "node:assert/strict";
import test from "node:test";
import { faultEvent, faultForms } from "../src/simulator/fault_events.ts";
import { checkThing, freeName, mayBeTaken, moveEvent, removeEvent, rgbOf, spawnEvent, type NewThing } from "../src/simulator/thing_events.ts";

const form = (fault: string) => faultForms.find((one) => one.fault === fault)!;
const defaults = (fault: string, more: Record<string, string> = {}) => {
  const values = new Map(form(fault).fields.map((field) => [field.key, field.kind === "number" ? String(field.value) : typeof field.of === "string" ? "left_knee" : field.of[0]!.value]));
  for (const [key, value] of Object.entries(more)) values.set(key, value);
  return faultEvent(form(fault), values);
};

test("each fault's sensible values make its event", () => {
  assert.deepEqual(faultForms.map(({ fault }) => defaults(fault)["fault"]), [
    { kind: "lose_frames", probability: 0.02, duration_s: 2 },
    { kind: "disturb_bus", corruption: 0.01, omission: 0.001, duplicate: 0.001, duration_s: 10 },
    { kind: "jam", duration_s: 0.002 },
    { kind: "bus_off", node: "left_knee" },
    { kind: "joint_restarts", joint: "left_knee", duration_s: 0.02 },
    { kind: "main_controller_silent", duration_s: 1 },
    { kind: "plugin_fails", plugin: "left_knee", how: "throws", duration_s: 1 },
    { kind: "sensor_fails", sensor: "left_knee", how: "freezes", duration_s: 0.5 }]);
  assert.deepEqual(defaults("jam", { stuck: "true" })["fault"], { kind: "jam", duration_s: 0.002, stuck: true });
});

test("a value that is out of bounds, or none, is refused with its field and its bounds", () => {
  assert.throws(() => defaults("jam", { duration_s: "11" }), /“for” is '11', and must be 0\.00001 … 10 s/);
  assert.throws(() => defaults("lose_frames", { probability: "-1" }), /“lost” is '-1', and must be 0 … 100 %/);
  assert.throws(() => defaults("joint_restarts", { duration_s: "soon" }), /'soon'/);
  assert.throws(() => defaults("joint_restarts", { duration_s: "" }), /“for”/);
  assert.throws(() => defaults("plugin_fails", { plugin: "" }), /no plug-in is chosen/);
});

const thing: NewThing = { shape: "box", size: [0.2, 0.3, 0.1], mass_kg: 0.5, colour: "#ff8000" };

test("a thing stands on the ground where it is put, with its mass or fast", () => {
  assert.deepEqual(spawnEvent(thing, "box_2", [1.23456, -0.5, 0.02]), { spawn: { name: "box_2", shape: "box", size_m: [0.2, 0.3, 0.1], position_m: [1.235, -0.5, 0.07], yaw_deg: 0, mass_kg: 0.5, colour: [1, 0.502, 0] } });
  const fast = spawnEvent({ ...thing, shape: "sphere", mass_kg: undefined }, "sphere", [0, 0, 0])["spawn"]!;
  assert.deepEqual([fast["size_m"], fast["position_m"], "mass_kg" in fast], [[0.2, 0.2, 0.2], [0, 0, 0.1], false]);
});

test("names are free, colours and turns are of the scenario's units", () => {
  assert.equal(freeName("box", new Set(["ball"])), "box");
  assert.equal(freeName("box", new Set(["box", "box_2"])), "box_3");
  assert.deepEqual(rgbOf("nonsense"), rgbOf("#808080"));
  assert.deepEqual(moveEvent("box", [-0.0001, 1, 0.05], Math.PI / 2), { move: { name: "box", position_m: [0, 1, 0.05], yaw_deg: 90 } });
  assert.deepEqual(removeEvent("box"), { remove: { name: "box" } });
});

test("what has no size, or weighs nothing, is refused", () => {
  checkThing(thing);
  assert.throws(() => checkThing({ ...thing, size: [0.2, 0, 0.1] }), /width is 0 m, and must be 0\.01 … 5 m/);
  assert.throws(() => checkThing({ ...thing, mass_kg: 0 }), /mass is 0 kg/);
  assert.throws(() => checkThing({ ...thing, mass_kg: NaN }), /mass is NaN/);
});

test("walls, steps and tiles stay where they are", () => {
  const takes = (kind: string, movable = false) => mayBeTaken({ kind, movable } as Parameters<typeof mayBeTaken>[0]);
  assert.deepEqual(["wall", "step", "slope", "tile", "box", "thing"].map((kind) => takes(kind)), [false, false, false, false, true, true]);
  assert.ok(takes("wall", true));
});
