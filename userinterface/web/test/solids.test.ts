// What a ray through the picture meets of the world, how high one stands, and how the world is kept up to date.
import assert from "node:assert/strict";
import test from "node:test";
import type { Triple, Turn } from "../src/description.ts";
import { distanceTo, firstHit, groundHeight, readGeometry, type GeometryPart, type Solid } from "../src/simulator/solids.ts";
import { WorldKeeper } from "../src/simulator/world_keeper.ts";

const about = ([x, y, z]: Triple, angle: number): Turn => [x * Math.sin(angle / 2), y * Math.sin(angle / 2), z * Math.sin(angle / 2), Math.cos(angle / 2)];
const make = (more: Partial<Solid>): Solid => ({ name: "one", kind: "box", shape: "box", size: [1, 1, 1], place: [0, 0, 0], turn: [0, 0, 0, 1], colour: [1, 1, 1], movable: false, ...more });
const from = (origin: Triple, [x, y, z]: Triple) => {
  const length = Math.hypot(x, y, z);
  return { origin, direction: [x / length, y / length, z / length] as Triple };
};
const near = (is: number | undefined, expected: number) => assert.ok(is !== undefined && Math.abs(is - expected) < 1e-9, `${is} is not ${expected}`);

test("boxes are met where their faces are, however they are turned", () => {
  near(distanceTo(make({}), from([-3, 0.2, 0.1], [1, 0, 0])), 2.5);
  assert.equal(distanceTo(make({}), from([-3, 0.6, 0], [1, 0, 0])), undefined);
  assert.equal(distanceTo(make({}), from([3, 0, 0], [1, 0, 0])), undefined, "behind");
  near(distanceTo(make({ turn: about([0, 0, 1], Math.PI / 4) }), from([-3, 0, 0], [1, 0, 0])), 3 - Math.SQRT1_2);
  near(distanceTo(make({ size: [2, 1, 0.1], turn: about([0, 1, 0], -0.3), place: [0, 0, 1] }), from([0, 0, 5], [0, 0, -1])), 4 - 0.05 / Math.cos(0.3));
  near(distanceTo(make({}), from([0, 0, 0.1], [0, 1, 0])), 0);
});

test("balls and cylinders are round", () => {
  near(distanceTo(make({ shape: "sphere", size: [2, 2, 2] }), from([-3, 0.6, 0], [1, 0, 0])), 3 - 0.8);
  const can = make({ shape: "cylinder", size: [1, 1, 2] });
  near(distanceTo(can, from([-3, 0.3, 0.9], [1, 0, 0])), 3 - 0.4);
  near(distanceTo(can, from([0.2, 0.2, 4], [0, 0, -1])), 3);
  assert.equal(distanceTo(can, from([0.45, 0.45, 4], [0, 0, -1])), undefined, "beside it, in its box");
  assert.equal(distanceTo(can, from([-3, 0, 1.2], [1, 0, 0])), undefined, "above it");
  near(distanceTo(make({ shape: "cylinder", size: [1, 1, 4], turn: about([0, 1, 0], Math.PI / 2) }), from([1.5, 0, 3], [0, 0, -1])), 2.5); // it lies
});

test("the nearest is seen: solids before the floor, each where it is now", () => {
  const box = make({ place: [2, 0, 0.5] });
  const over = from([0, 0, 2], [1, 0, -1]);
  const hit = firstHit(over, [box])!;
  assert.equal(hit.solid, box);
  near(hit.place[0], 1.5);
  const floor = firstHit(over, [box], () => ({ place: [9, 0, 0.5], turn: [0, 0, 0, 1] }))!;
  assert.equal(floor.solid, undefined);
  assert.deepEqual(floor.place.map((value) => Math.round(value * 1e9) / 1e9 + 0), [2, 0, 0]);
  assert.equal(firstHit(from([0, 0, 2], [1, 0, 0.1]), [box]), undefined, "the sky");
});

test("one stands on steps and slopes, and not on boxes", () => {
  const solids = [make({ kind: "step", size: [1, 1, 0.02], place: [1, 0, 0.01] }), make({ kind: "step", size: [0.5, 1, 0.04], place: [1.25, 0, 0.02] }), make({ place: [-1, 0, 0.5] })];
  near(groundHeight(solids, 0.6, 0), 0.02);
  near(groundHeight(solids, 1.2, 0), 0.04);
  near(groundHeight(solids, 0, 0), 0);
  near(groundHeight(solids, -1, 0), 0);
});

test("the geometry reads as it was told, and a shape that is not known is refused by name", () => {
  const told = (shape: string) => ({ geometry: 4, world: "boxes", total: 1, floor_colour: [0.5, 0.5, 0.5], solids: [{ name: "a", kind: "box", shape, size: { x: 1, y: 2, z: 3 },
    pose: { position: { x: 0, y: 0, z: 1.5 }, orientation: { x: 0, y: 0, z: 0, w: 1 } }, colour: [1, 0, 0], movable: true }] });
  assert.deepEqual(readGeometry(told("box")).solids[0], make({ name: "a", size: [1, 2, 3], place: [0, 0, 1.5], colour: [1, 0, 0], movable: true }));
  assert.throws(() => readGeometry(told("cone")), /'a' has the shape 'cone'/);
});

const part = (geometry: number, first: number, count: number, total: number): GeometryPart => ({ geometry, world: "w", total, floorColour: [1, 1, 1],
  solids: Array.from({ length: count }, (_none, index) => make({ name: `${geometry}.${first + index}` })) });

test("the world is fetched part by part, once for each number, and anew where it changes meanwhile", async () => {
  const asked: number[] = [];
  const shown: string[][] = [];
  let changes = true;
  const keeper = new WorldKeeper(async (first) => {
    asked.push(first);
    if (first === 2 && changes) {
      changes = false;
      return part(8, 2, 1, 3);
    }
    return part(changes ? 7 : 8, first, Math.min(2, 3 - first), 3);
  }, (solids) => shown.push(solids.map(({ name }) => name)), (error) => assert.fail(error));
  await Promise.all([keeper.take(7, 0), keeper.take(7, 10)]);
  assert.deepEqual(asked, [0, 2, 0, 2]);
  assert.deepEqual(shown, [["8.0", "8.1", "8.2"]]);
  await keeper.take(8, 100);
  assert.equal(asked.length, 4);
});

test("a world that does not come is told, and asked for again later", async () => {
  const failures: string[] = [];
  let parts = 0;
  const keeper = new WorldKeeper(async (first) => (++parts, part(1, first, 0, 5)), () => assert.fail("nothing is shown"), (error) => failures.push(error.message));
  await keeper.take(1, 0);
  await keeper.take(1, 100);
  assert.deepEqual(failures, ["the world has 5 solids, of which only 0 came"]);
  await keeper.take(1, 3000);
  assert.equal(parts, 2);
});
