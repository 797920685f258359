// The simulator's page in a real browser, against a simulator of the test's own. Argument: the port of a module, whose robot it is.
// GAITWAY_SCREENSHOTS: a folder for pictures of it.
import assert from "node:assert/strict";
import path from "node:path";
import test, { after, before } from "node:test";
import { openBrowser, pixelsOf, RobotPage } from "./page_browser.mjs";
import { FakeSimulator, room, solid } from "./page_simulator_fake.mjs";

const near_m = 0.02;
const marks = { pink: [0.55, -0.5], green: [1.05, -0.2] }; // on the floor of the world
const isColour = { pink: "r > 120 && b > 90 && g < 70", green: "g > 170 && r < 70 && b < 70" };
const description = await (await fetch(`http://127.0.0.1:${process.argv[2]}/robot.json`)).json();
let browser, eye;
before(async () => {
  browser = await openBrowser();
  eye = await browser.newPage(); // looks at pictures: the page's own policy lets no script read one
});
after(() => browser.close());

function markedRoom() {
  const mark = (name, colour, place) => solid(name, "tile", "cylinder", [0.06, 0.06, 0.001], place, 0, colour);
  return [...room(), mark("pink", [1, 0, 0.8], marks.pink), mark("green", [0, 1, 0], marks.green)];
}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// `use`: with a page of a simulator, and that.
async function withPage(use, { viewport, solids = markedRoom(), prepare = () => {} } = {}) {
  const fake = await FakeSimulator.serve(description, solids);
  prepare(fake);
  const robot = await RobotPage.open(browser, fake.url, viewport);
  try {
    await robot.live();
    await robot.until(() => document.getElementById("simulator"), "the simulator's bar");
    await pause(400); // the world has come, and stands where it belongs
    await use(robot, fake);
    assert.deepEqual(robot.errors, []);
  } finally {
    await robot.close();
    fake.end();
  }
}

async function picture(robot, name) {
  if (process.env.GAITWAY_SCREENSHOTS) await robot.page.screenshot({ path: path.join(process.env.GAITWAY_SCREENSHOTS, name) });
}

const pixels = (robot, condition) => pixelsOf(robot.page, eye, condition);
// Where in the window a mark on the floor is seen, once it is drawn and the camera rests.
async function seen(robot, colour) {
  let found = await pixels(robot, isColour[colour]);
  for (const end_ms = performance.now() + 10_000; performance.now() < end_ms; ) {
    const before = found;
    found = await pixels(robot, isColour[colour]);
    if (found.count > 8 && Math.hypot(found.x - before.x, found.y - before.y) < 0.5) return found;
  }
  assert.fail(`the ${colour} mark is not seen, or does not rest: ${found.count} pixels at ${found.x} ${found.y}`);
}
async function clickOn(robot, { x, y }) {
  await robot.page.mouse.move(x, y);
  await robot.page.mouse.down();
  await robot.page.mouse.up();
}
async function answered(what, look) {
  for (const end_ms = performance.now() + 5000; performance.now() < end_ms; await pause(20)) if (look()) return;
  assert.fail(`not within 5 s: ${what}`);
}
const cardSays = (robot, text) => robot.says("way-text", text);
const notShown = (robot, id) => robot.until((name) => { const found = document.getElementById(name); return !found || found.hidden; }, `${id} is hidden`, undefined, id);

test("the world is drawn under the robot, and its things go where the simulator has them", () => withPage(async (robot, fake) => {
  await picture(robot, "simulator_world.png");
  assert.ok((await pixels(robot, "r > 90 && r < 210 && r > g * 1.2 && g > b * 1.2")).count > 5000, "cartons are seen");
  const blue = "b > 90 && b > r * 2.2 && b > g * 1.3 && g > 20 && r < 60";
  const inScene = async () => (await pixels(robot, `${blue} && !(r < 40 && g > 90 && g < 115)`)).x;
  const before = await inScene();
  const ball = fake.solids.find(({ name }) => name === "ball");
  ball.pose = [1.2, -0.75, ...ball.pose.slice(2)];
  await pause(700);
  assert.ok(Math.abs((await inScene()) - before) > 40, "the ball is drawn elsewhere");
  assert.ok(fake.of("/simulation/geometry").length <= 2, "the geometry is asked for when it is another, or when nothing came for long"); // of some 30 states
  const pink = await seen(robot, "pink");
  fake.odometry[0] += 0.02; // it drifts, and the robot stays where it is in the world
  await pause(900);
  const later = await seen(robot, "pink");
  assert.ok(Math.hypot(later.x - pink.x, later.y - pink.y) < 4, "what the robot stands on goes with it");
}));

test("a click on the floor makes a plan, and Walk walks there", () => withPage(async (robot, fake) => {
  await cardSays(robot, "Click the floor");
  const [from, to] = [await seen(robot, "pink"), await seen(robot, "green")];
  await robot.page.mouse.move(from.x, from.y);
  await robot.page.mouse.down();
  await robot.page.mouse.move(to.x, to.y, { steps: 4 });
  await robot.page.mouse.up();
  await cardSays(robot, "steps");
  await picture(robot, "simulator_plan.png");
  const [plan] = fake.of("/simulation/plan");
  const off_m = Math.hypot(plan.x - marks.pink[0], plan.y - marks.pink[1]);
  const yaw = Math.atan2(marks.green[1] - marks.pink[1], marks.green[0] - marks.pink[0]);
  console.log(`the goal is ${(1000 * off_m).toFixed(1)} mm from the mark that was pressed, its heading ${Math.abs(plan.yaw - yaw).toFixed(4)} rad from the drag's`);
  assert.ok(off_m < near_m, `${plan.x} ${plan.y} is not at the mark`);
  assert.ok(Math.abs(plan.yaw - yaw) < 0.05, `heading ${plan.yaw}, not ${yaw}`);
  await robot.press("way-walk");
  await answered("it walks", () => fake.of("/walk_to").length === 1);
  assert.deepEqual(fake.of("/walk_to")[0], { x: plan.x, y: plan.y, yaw: plan.yaw });
  assert.equal(fake.of("/command/acquire").length, 1, "with the command");
  await cardSays(robot, "left");
  await picture(robot, "simulator_walks.png");
  await robot.press("way-leave");
  await answered("it leaves the way", () => fake.of("/walk_to/cancel").length === 1);
  await cardSays(robot, "Click the floor");
}));

test("the goal is where the pointer is, wherever the camera looks from and however odometry lies", () => withPage(async (robot, fake) => {
  for (const look of ["Top", "Side", "Behind"]) {
    await robot.page.evaluate((name) => [...document.querySelectorAll("#camera button")].find(({ textContent }) => textContent === name).click(), look);
    await robot.page.click("[aria-label=Farther]");
    await robot.page.click("[aria-label=Farther]");
    await pause(300);
    await clickOn(robot, await seen(robot, "pink"));
    await cardSays(robot, "steps");
    const plan = fake.of("/simulation/plan").at(-1);
    assert.ok(Math.hypot(plan.x - marks.pink[0], plan.y - marks.pink[1]) < near_m, `from ${look}: ${plan.x} ${plan.y}`);
    await robot.press("way-cancel");
    await cardSays(robot, "Click the floor");
  }
}, { prepare: (fake) => Object.assign(fake, { odometry: [-0.2, 0.1, 0, -0.9], estimate: [4, 5, 0, 1] }) })); // the module has been linked anew: its odometry is not the robot's own

test("while it is paused Walk plays, and Escape only breaks off; a refusal says why", () => withPage(async (robot, fake) => {
  await robot.press("play");
  await robot.says("link-text", "paused");
  const down = { state: "down", text: "nothing is heard of it", link: "unix:link.sock", seconds: 3 };
  fake.publish("/link_state", down);
  await pause(400);
  assert.ok(await robot.page.$eval("#trouble", ({ hidden }) => hidden), "a robot that is paused is not away");
  assert.ok(await robot.page.$eval("#old", ({ hidden }) => hidden), "and not old, though its clock is 9 s behind");
  fake.publish("/link_state", { ...down, state: "up", text: "" });
  fake.refusal = "the goal stands in carton_1";
  await clickOn(robot, await seen(robot, "pink"));
  await cardSays(robot, "No way leads there: the goal stands in carton_1");
  await picture(robot, "simulator_refused.png");
  assert.ok(await robot.page.$eval("#way-walk", ({ hidden }) => hidden));
  await robot.page.keyboard.press("Escape");
  await cardSays(robot, "Click the floor");
  assert.deepEqual(fake.of("/stop"), [], "nothing moves, and nothing is stopped");
  fake.refusal = "";
  await clickOn(robot, await seen(robot, "pink"));
  await cardSays(robot, "steps");
  await robot.page.keyboard.press("Enter");
  await answered("it walks", () => fake.of("/walk_to").length === 1 && fake.playing);
  await robot.until(() => document.getElementById("play").classList.contains("plays"), "it knows that it plays");
  await clickOn(robot, { x: 150, y: 600 }); // floor, wherever the camera has followed the robot to
  await cardSays(robot, "steps,");
  await robot.page.keyboard.press("Escape");
  await answered("it stops", () => fake.of("/stop").length > 0);
}));

test("the time line goes to any instant, and says what will be forgotten", () => withPage(async (robot, fake) => {
  await robot.press("play");
  await robot.says("link-text", "paused");
  const recorded_s = fake.time_s;
  const line = await (await robot.page.$("#time-line")).boundingBox();
  const at = (share) => [line.x + share * line.width, line.y + 12];
  const geometries = fake.of("/simulation/geometry").length;
  await robot.page.mouse.move(...at(0.25));
  await robot.page.mouse.down();
  await robot.page.mouse.move(...at(0.6), { steps: 8 });
  await robot.page.mouse.move(...at(0.5), { steps: 4 });
  await robot.page.mouse.up();
  await answered("it is there", () => Math.abs(fake.time_s - recorded_s / 2) < recorded_s / 200);
  await answered("the world of that instant, which may count to the same number", () => fake.of("/simulation/geometry").length > geometries);
  await robot.says("simulator-note", `The ${(recorded_s - fake.time_s).toFixed(3)} s after this instant will be forgotten when it plays on.`);
  await robot.says("simulator-time", `${fake.time_s.toFixed(3)} s`);
  await picture(robot, "simulator_past.png");
  const marksShown = await robot.page.$$eval("#time-line .marks i", (all) => all.map((mark) => [mark.className, mark.title]));
  assert.deepEqual(marksShown.map(([kind]) => kind), ["push", "fault", "fall"]);
  assert.match(marksShown[1][1], /^fault at 8\.000 s: .*jam/);
  await robot.page.keyboard.press("ArrowRight");
  await answered("a tenth of a second on", () => Math.abs(fake.time_s - recorded_s / 2 - 0.1) < recorded_s / 200);
  await robot.press("play");
  await robot.until(() => document.getElementById("simulator-note").textContent === "", "nothing is to be forgotten any more");
  await robot.until(() => [...document.querySelectorAll("#time-line .marks i")].map((mark) => mark.className).join() === "push,fault", "the fall never was");
}, { prepare: (fake) => {
  for (const [kind, text] of [["push", "push: …"], ["fault", '{"fault":{"kind":"jam"}}'], ["fall", ""]]) {
    fake.run(kind === "fall" ? 9 : 4);
    fake.mark(kind, text);
  }
  fake.run(3);
} }));

test("keys and buttons play, pause, step, set the speed, and reset when it is confirmed", () => withPage(async (robot, fake) => {
  await robot.page.keyboard.press("Space");
  await answered("it is paused", () => !fake.playing);
  assert.deepEqual(fake.of("/stop"), [], "Space stops no simulated robot");
  await robot.says("link-text", "paused");
  assert.equal(await robot.page.$eval("#step-10", ({ title }) => title), "One step of 10 ms (.)");
  await robot.press("stop");
  await robot.newsOf("The simulation is paused: the robot stops as soon as it plays on.");
  await robot.page.keyboard.press(".");
  await robot.press("step-80");
  await answered("two steps", () => fake.of("/simulation/step_simulation").length === 2);
  await robot.page.keyboard.press(".");
  await answered("three steps", () => fake.of("/simulation/step_simulation").length === 3);
  assert.deepEqual(fake.of("/simulation/step_simulation").map(({ steps }) => steps), [10, 80, 80]);
  await robot.tab("Events");
  await robot.page.type(".events-tab input", "a . b");
  assert.equal(fake.of("/simulation/step_simulation").length, 3, "who types steps nothing");
  assert.ok(!fake.playing);
  await robot.page.evaluate(() => document.activeElement.blur());
  await robot.page.select("#speed", "5");
  await answered("it is faster", () => fake.of("/simulation/set_speed").at(-1)?.speed === 5);
  await robot.press("reset");
  await robot.page.click("#reset-keep");
  await robot.until(() => !document.querySelector("dialog[open]"), "it has been answered");
  assert.deepEqual(fake.of("/simulation/reset_simulation"), []);
  await robot.press("reset");
  await robot.page.click("#reset-go");
  await answered("it is reset", () => fake.of("/simulation/reset_simulation").length === 1 && fake.time_s < 0.5);
}));

test("Escape stops while it is asked whether to reset, even where it would only forget a goal", () => withPage(async (robot, fake) => {
  await robot.press("play");
  await robot.says("link-text", "paused");
  await clickOn(robot, await seen(robot, "pink"));
  await cardSays(robot, "steps");
  await robot.press("reset");
  await robot.page.keyboard.press("Escape");
  await answered("it stops", () => fake.of("/stop").length > 0);
  await robot.until(() => !document.getElementById("reset-dialog"), "and nothing is asked any more");
  assert.deepEqual(fake.of("/simulation/reset_simulation"), []);
}));

for (const [name, viewport] of [["a desktop", undefined], ["a phone", { width: 360, height: 740, hasTouch: true, isMobile: true }]]) {
  test(`all three stops act while it is asked whether to reset, on ${name}`, () => withPage(async (robot, fake) => {
    await robot.press("reset");
    await robot.until(() => document.getElementById("reset-dialog")?.open, "it is asked");
    await pause(300);
    await picture(robot, `simulator_reset${viewport ? "_phone" : ""}.png`);
    await robot.press("stop"); // by the pointer: whatever lies above it would take that
    await answered("Stop", () => fake.of("/stop").length > 0);
    await robot.press("emergency");
    await answered("Emergency stop", () => fake.of("/emergency_stop").length > 0);
    assert.ok(await robot.page.$("#reset-dialog[open]"), "it is still asked");
    fake.asked.length = 0;
    await robot.page.keyboard.press("Escape");
    await answered("Escape stops", () => fake.of("/stop").length > 0);
    await robot.until(() => !document.getElementById("reset-dialog"), "and closes it");
    await robot.press("reset");
    await robot.page.evaluate(() => document.getElementById("reset").click());
    assert.equal((await robot.page.$$("#reset-dialog")).length, 1, "it is asked once");
    assert.equal(await robot.page.evaluate(() => document.activeElement.id), "reset-keep");
    await robot.page.keyboard.press("Enter");
    await robot.until(() => !document.getElementById("reset-dialog"), "it has been answered");
    assert.deepEqual(fake.of("/simulation/reset_simulation"), []);
  }, { viewport }));
}

test("a fault is applied with its fields, and one that is out of bounds is not", () => withPage(async (robot, fake) => {
  await robot.press("open-faults");
  await robot.until(() => document.querySelectorAll("#fault-plugin_fails-plugin option").length === 5, "the plug-ins are listed");
  await picture(robot, "simulator_faults.png");
  const now = (kind) => robot.page.$eval(`#fault-${kind} [type=submit]`, (press) => press.click());
  await robot.page.select("#fault-plugin_fails-plugin", "zmp");
  await robot.page.select("#fault-plugin_fails-how", "not_a_number");
  await now("plugin_fails");
  await robot.page.$eval("#fault-lose_frames-probability", (field) => (field.value = "5"));
  await now("lose_frames");
  await robot.page.select("#fault-joint_restarts-joint", "left_knee");
  await now("joint_restarts");
  await robot.page.$eval("#fault-jam-duration_s", (field) => (field.value = "99"));
  await now("jam");
  await robot.newsOf("“for” is '99', and must be 0.00001 … 10 s");
  await answered("three", () => fake.of("/simulation/apply").length === 3);
  assert.deepEqual(fake.of("/simulation/apply").map(({ event }) => JSON.parse(event).fault), [
    { kind: "plugin_fails", plugin: "zmp", how: "not_a_number", duration_s: 1 },
    { kind: "lose_frames", probability: 0.05, duration_s: 2 },
    { kind: "joint_restarts", joint: "left_knee", duration_s: 0.02 }]);
}));

test("things are put where one clicks, dragged over the floor, and taken away", () => withPage(async (robot, fake) => {
  await robot.press("open-things");
  const [from, to] = [await seen(robot, "pink"), await seen(robot, "green")];
  await robot.page.click("#thing-cylinder");
  await robot.page.$eval("#thing-size-2", (field) => (field.value = "8"));
  await robot.press("thing-put");
  await clickOn(robot, from);
  await answered("it is there", () => fake.solids.some(({ name }) => name === "cylinder"));
  const { spawn } = JSON.parse(fake.of("/simulation/apply")[0].event);
  assert.deepEqual([spawn.shape, spawn.size_m, spawn.mass_kg], ["cylinder", [0.15, 0.15, 0.08], 0.5]);
  assert.ok(Math.hypot(spawn.position_m[0] - marks.pink[0], spawn.position_m[1] - marks.pink[1]) < near_m, `${spawn.position_m}`);
  assert.ok(Math.abs(spawn.position_m[2] - 0.04) < 0.003, "it stands on the floor");
  await robot.until(() => [...document.querySelectorAll(".things li")].some(({ textContent }) => textContent.includes("cylinder")), "it is listed");
  await robot.press("thing-put");
  await pause(300);
  await picture(robot, "simulator_things.png");
  await robot.page.mouse.move(from.x, from.y);
  await robot.page.mouse.down();
  await robot.page.mouse.move(to.x, to.y, { steps: 5 });
  await robot.page.mouse.up();
  await answered("it is moved", () => fake.of("/simulation/apply").length === 2);
  const { move } = JSON.parse(fake.of("/simulation/apply")[1].event);
  const [dx, dy] = [move.position_m[0] - spawn.position_m[0], move.position_m[1] - spawn.position_m[1]];
  assert.equal(move.name, "cylinder");
  assert.equal(move.position_m[2], spawn.position_m[2], "over the floor");
  assert.ok(dx > 0.25 && dy > 0.1, `it went by ${dx}, ${dy}`);
  assert.deepEqual(fake.of("/simulation/plan"), [], "no goal was chosen by all that");
  await robot.page.$eval('[aria-label="Take cylinder away"]', (press) => press.click());
  await answered("it is gone", () => !fake.solids.some(({ name }) => name === "cylinder"));
  await robot.tab("Drive");
  await cardSays(robot, "Click the floor");
}));

test("on a phone it fits, a tap chooses the goal, and two fingers turn the camera", () => withPage(async (robot, fake) => {
  assert.ok(await robot.page.evaluate(() => document.documentElement.scrollWidth <= 360), "nothing is wider than a phone");
  const place = await seen(robot, "pink");
  await robot.page.touchscreen.tap(place.x, place.y);
  await cardSays(robot, "steps");
  const plan = fake.of("/simulation/plan")[0];
  assert.ok(Math.hypot(plan.x - marks.pink[0], plan.y - marks.pink[1]) < near_m, `${plan.x} ${plan.y}`);
  await picture(robot, "simulator_phone.png");
  await robot.press("way-cancel");
  await cardSays(robot, "Click the floor");
  const first = await robot.page.touchscreen.touchStart(place.x - 30, place.y);
  const second = await robot.page.touchscreen.touchStart(place.x + 30, place.y);
  for (let i = 1; i <= 5; ++i) {
    await first.move(place.x - 30 + 8 * i, place.y);
    await second.move(place.x + 30 + 8 * i, place.y);
  }
  await first.end();
  await second.end();
  await pause(300);
  const turned = await seen(robot, "pink");
  assert.ok(Math.hypot(turned.x - place.x, turned.y - place.y) > 10, "the camera has turned");
  assert.equal(fake.of("/simulation/plan").length, 1, "no goal was chosen by that");
}, { viewport: { width: 360, height: 740, hasTouch: true, isMobile: true } }));

test("a robot whose simulator tells no state has the page that it had", async () => {
  const fake = await FakeSimulator.serve(description, markedRoom(), { silent: true });
  const robot = await RobotPage.open(browser, fake.url);
  await robot.live();
  await pause(500);
  assert.equal(await robot.page.$("#simulator"), null);
  assert.equal(await robot.page.$("#walk-to"), null);
  await robot.page.keyboard.press("Space");
  await answered("Space stops", () => fake.of("/stop").length > 0);
  await robot.close();
  fake.end();
});
