// A planned way: how it reads, what of it is still to come, where a drag puts the goal, and which steps are shown.
import assert from "node:assert/strict";
import test from "node:test";
import { goalOfDrag, length_m, passedSteps, planText, readPlan, type FootstepPlan, type Goal } from "../src/simulator/footstep_plan.ts";
import { WayPlanner } from "../src/simulator/way_planner.ts";
import { leftText, readWay } from "../src/simulator/way_state.ts";

const answer = { sides: [0, 1, 0], steps: [0.1, 0.05, 0, 0.2, -0.05, 0, 0.2, 0.05, 0], feet: [0, 0.05, 0, 0, -0.05, 0], duration: 4.2 };
const plan = readPlan(answer);
const goal: Goal = { x: 0.2, y: 0, yaw: 0 };
const way = (more: Record<string, unknown> = {}) => readWay({ state: "walks", result: "none", text: "", steps_left: 2, replans: 0, distance_left: 0.26, goal: [0.2, 0, 0], ...more });

test("a plan reads as lists of bytes and as their base64, and must be whole", () => {
  assert.deepEqual(plan.steps[1], { side: 1, x: 0.2, y: -0.05, yaw: 0 });
  assert.deepEqual(readPlan({ ...answer, sides: btoa("\u0000\u0001\u0000") }), plan);
  assert.deepEqual(plan.feet, [{ x: 0, y: 0.05, yaw: 0 }, { x: 0, y: -0.05, yaw: 0 }]);
  assert.throws(() => readPlan({ ...answer, steps: [1, 2] }), /3 sides, 2 numbers/);
  assert.throws(() => readPlan({ ...answer, feet: [0, 0, 0, 0, 0, NaN] }), /the plan has/);
  assert.equal(readPlan({ ...answer, sides: [], steps: [] }).steps.length, 0);
});

test("its length is that of the way of the middle between the feet", () => {
  assert.ok(Math.abs(length_m(plan) - 0.2) < 1e-9);
  assert.equal(planText(plan), "3 steps, 0.2 m, about 4 s");
});

test("steps that are behind are those that the robot does not count any more", () => {
  assert.deepEqual([3, 2, 0, 9].map((left) => passedSteps(plan, left)), [0, 1, 3, 0]);
});

test("a tap looks the way the robot comes, a drag where it goes, and near the robot it keeps its heading", () => {
  const robot = { x: 0, y: 0, yaw: 1 };
  assert.deepEqual(goalOfDrag([1, 1], [1.02, 1], robot), { x: 1, y: 1, yaw: Math.PI / 4 });
  assert.deepEqual(goalOfDrag([1, 1], [1, 0.5], robot), { x: 1, y: 1, yaw: -Math.PI / 2 });
  assert.deepEqual(goalOfDrag([0.1, 0], [0.1, 0], robot), { x: 0.1, y: 0, yaw: 1 });
});

test("what is left is told in metres and steps", () => {
  assert.equal(leftText(way()), "0.3 m, 2 steps");
  assert.equal(leftText(way({ steps_left: 0, distance_left: NaN })), "");
  assert.equal(way({ state: "idle" }).goes, false);
  assert.equal(way({ goal: [] }).goal, undefined);
});

function planner(give: (goal: Goal) => Promise<FootstepPlan> = async () => plan) {
  const asked: Goal[] = [];
  const made = new WayPlanner((to) => (asked.push(to), give(to)));
  return { asked, made };
}
const settled = () => new Promise(setImmediate);

test("of two goals the later one's plan is shown, whichever comes first", async () => {
  const answers = new Map<number, (plan: FootstepPlan) => void>();
  const { made } = planner(({ x }) => new Promise((resolve) => answers.set(x, resolve)));
  void made.choose({ x: 1, y: 0, yaw: 0 });
  void made.choose({ x: 2, y: 0, yaw: 0 });
  answers.get(2)!(plan);
  answers.get(1)!({ ...plan, steps: [] });
  await settled();
  assert.equal(made.shown?.goal.x, 2);
  assert.equal(made.shown?.plan, plan);
});

test("a refusal keeps the planner's reason; to discard it shows nothing", async () => {
  const { made } = planner(() => Promise.reject(new Error("the goal stands in box_1")));
  await made.choose(goal);
  assert.equal(made.draft?.refusal, "the goal stands in box_1");
  made.discard();
  assert.equal(made.shown, undefined);
});

test("the plan that was chosen is the one that is walked, and is not asked for again", async () => {
  const { asked, made } = planner();
  await made.choose(goal);
  made.begun();
  made.take(way({ state: "plans", steps_left: 3 }));
  made.take(way());
  await settled();
  assert.equal(asked.length, 1);
  assert.deepEqual([made.shown?.plan, made.shown?.passed], [plan, 1]);
  made.take(way({ state: "idle", result: "arrived" }));
  assert.equal(made.shown, undefined);
});

test("somebody else's way, and one that was planned anew, is asked for once", async () => {
  const { asked, made } = planner();
  made.take(way());
  made.take(way({ steps_left: 1 }));
  await settled();
  assert.equal(asked.length, 1);
  made.take(way({ replans: 1 }));
  made.take(way({ replans: 1, steps_left: 1 }));
  await settled();
  assert.equal(asked.length, 2);
  assert.equal(made.shown?.passed, 2);
});

test("at another instant the feet are elsewhere: what is chosen is planned anew, what was walked is forgotten", async () => {
  const { asked, made } = planner();
  await made.choose(goal);
  made.jumped();
  await settled();
  assert.equal(asked.length, 2);
  assert.equal(made.shown?.plan, plan);
});
