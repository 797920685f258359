// A planned way: how it reads, what of it is still to come, where a drag puts the goal, and which steps are shown.
import assert from "node:assert/strict";
import test from "node:test";
import { Refused, Unanswered } from "../src/rosbridge.ts";
import { givenSteps, goalOfDrag, length_m, planText, progressOf, readPlan, type FootstepPlan, type Goal } from "../src/simulator/footstep_plan.ts";
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

test("steps that are behind are those of a way that the robot has come", () => {
  const at = (x: number, before = 0) => progressOf(plan, { x, y: 0.01 }, before);
  assert.deepEqual([at(-0.1).passed, at(0.06).passed, at(0.16).passed, at(0.5).passed], [0, 1, 2, 3]);
  assert.ok(Math.abs(at(0.06).left_m - 0.14) < 1e-9);
  assert.equal(at(0, 2).passed, 2, "nobody goes back");
  assert.deepEqual([3, 2, 0, 9].map((left) => givenSteps(plan, left)), [0, 1, 3, 0]);
});

test("a way that comes by where it began is gone in its order", () => {
  const round = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((k) => ({ angle: (k * Math.PI) / 4 })).flatMap(({ angle }) => [0, 1].map((side) => ({ side, pose: [Math.sin(angle), 1 - Math.cos(angle), angle] })));
  const circle = readPlan({ sides: round.map(({ side }) => side), steps: round.flatMap(({ pose }) => pose), feet: [0, 0, 0, 0, 0, 0], duration: 9 });
  assert.ok(progressOf(circle, { x: 0, y: 0 }).passed <= 2, "it has only begun");
  assert.equal(progressOf(circle, { x: 0, y: 0 }, 17).passed, 18);
});

test("a tap looks the way the robot comes, a drag where it goes, and near the robot it keeps its heading", () => {
  const robot = { x: 0, y: 0, yaw: 1 };
  assert.deepEqual(goalOfDrag([1, 1], [1.02, 1], robot), { x: 1, y: 1, yaw: Math.PI / 4 });
  assert.deepEqual(goalOfDrag([1, 1], [1, 0.5], robot), { x: 1, y: 1, yaw: -Math.PI / 2 });
  assert.deepEqual(goalOfDrag([0.1, 0], [0.1, 0], robot), { x: 0.1, y: 0, yaw: 1 });
});

test("what is left is told in metres and steps", () => {
  assert.equal(leftText(2, 0.26), "0.3 m, 2 steps");
  assert.equal(leftText(0, NaN), "");
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
  const { made } = planner(() => Promise.reject(new Refused("the goal stands in box_1")));
  await made.choose(goal);
  assert.equal(made.draft?.refusal, "No way leads there: the goal stands in box_1");
  made.discard();
  assert.equal(made.shown, undefined);
});

test("that nobody answered is not told as a refusal", async () => {
  const { made } = planner(() => Promise.reject(new Unanswered("/simulation/plan was not answered")));
  await made.choose(goal);
  assert.equal(made.draft?.refusal, "No plan has come: /simulation/plan was not answered");
});

test("the plan that was chosen is the one that is walked, and is not asked for again", async () => {
  const { asked, made } = planner();
  await made.choose(goal);
  made.begun();
  made.take(way({ state: "plans", steps_left: 3 }));
  made.take(way());
  await settled();
  assert.equal(asked.length, 1);
  made.at({ x: 0.06, y: 0 });
  assert.deepEqual([made.shown?.plan, made.shown?.passed, made.left?.steps], [plan, 1, 2]);
  made.at({ x: 0.2, y: 0 });
  assert.equal(made.shown?.passed, 1, "two are not even given to the walk");
  made.take(way({ steps_left: 0 }));
  made.at({ x: 0.2, y: 0 });
  assert.equal(made.left?.steps, 0);
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
  assert.equal(made.shown?.plan, plan);
});

test("at another instant the feet are elsewhere: what is chosen is planned anew, what was walked is forgotten", async () => {
  const { asked, made } = planner();
  await made.choose(goal);
  made.jumped();
  await settled();
  assert.equal(asked.length, 2);
  assert.equal(made.shown?.plan, plan);
});
