// The twin's part of the simulator's page in a real browser, against a simulator of the test's own: what is drawn, compared, told and sent.
// Arguments: see page_twin_page.mjs.
import assert from "node:assert/strict";
import test from "node:test";
import { answered, channels, enter, hidden, pause, phone, picture, pixels, sends, set, there, verdict, withPage } from "./page_twin_page.mjs";

test("the robot there is drawn as a second one, goes where it is measured, and can be hidden", () => withPage(async (robot, fake) => {
  await robot.says("twin-chip", "Real and simulated agree");
  let shown = await there(robot);  // on a slow computer the page tells of the robot before it has drawn it
  for (let looks = 1; looks < 20 && shown.count <= 2500; ++looks) {
    await pause(250);
    shown = await there(robot);
  }
  assert.ok(shown.count > 2500, `the robot there has ${shown.count} pixels`);
  await picture(robot, "twin_world.png");
  assert.ok((await robot.page.$$eval(".legend li", (all) => all.map(({ textContent }) => textContent))).includes("robot there, measured"));
  fake.twin.offset = [0, -0.45, 0];
  await pause(600);
  const moved = await there(robot);
  assert.ok(moved.count > 2500 && moved.x - shown.x > 80, `it stands at ${moved.x}, and stood at ${shown.x}`);
  await enter(robot, "twin-show");
  await pause(300);
  assert.ok((await there(robot)).count < shown.count / 10, "it is hidden");
  await enter(robot, "twin-show");
  await pause(300);
  assert.ok((await there(robot)).count > 2500, "it is shown again");
}));

test("what is measured is faded when it is old, and gone when nothing is known", () => withPage(async (robot, fake) => {
  const fresh = await there(robot);
  fake.twin.hears = false;
  await verdict(robot, "lost");
  await pause(300);
  const old = await there(robot);
  assert.ok(old.count < fresh.count / 4, `${old.count} of ${fresh.count} pixels are as clear as before`);
  const faint = await pixels(robot, "r > g * 1.06 && b > g * 1.02 && g > 120");
  assert.ok(faint.count > 1500, `it is still to be seen: ${faint.count} pixels`);
  fake.twin.hears = true;
  await verdict(robot, "agree");
  fake.twin.knows = false;
  await pause(500);
  assert.ok((await pixels(robot, "r > g * 1.06 && b > g * 1.02 && g > 120")).count < faint.count / 5, "nothing of it is drawn");
}));

test("a difference above its limit is on top, and any channel is plotted with measured and simulated", () => withPage(async (robot, fake) => {
  await robot.tab("Twin");
  await robot.says("twin-verdict", "agree");
  fake.twin.differ("right_knee", 0.07);
  await verdict(robot, "differ");
  await robot.until(() => document.querySelector(".differences tbody tr")?.dataset.channel === "right_knee", "the right knee is on top");
  await robot.says("twin-verdict", "1 of 29 differ. Most of all: right knee, 4.0° (limit 2.0°).");
  await robot.says("twin-chip", "right knee differs by 4.0°");
  await robot.says("twin-told", "right_knee is 4.0 deg from the simulated one");
  assert.ok(await robot.page.$eval('[data-channel="right_knee"]', (row) => row.classList.contains("above")));
  fake.twin.differ("left foot", 40);
  await robot.until(() => document.querySelector(".differences tbody tr")?.dataset.channel === "left foot", "the left foot is worse");
  await picture(robot, "twin_differs.png");
  assert.match(await robot.text("twin-told"), /^[\d.]+ s left foot is 40\.0 N.*right_knee/, "the newest first");
  fake.twin.told.push([1.5, "connected"], [0.5, "motion kick: done"]);
  await robot.says("twin-told", "0.5 s motion kick: done1.5 s connected");
  assert.deepEqual(await robot.page.$$eval("#twin-told li", (all) => all.map((line) => line.classList.contains("warning"))), [false, false, true, true]);
  await robot.page.focus('[data-channel="right_knee"] button');
  await robot.page.keyboard.press("Enter");
  await robot.says("twin-plot-title", "right knee, °");
  await pause(1500);
  const drawn = await robot.page.$$eval(".twin-plot canvas", (all) => all.map((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const count = (holds) => Array.from({ length: data.length / 4 }, (_none, i) => data.subarray(4 * i, 4 * i + 4)).filter(([r, g, b, a]) => a > 100 && holds(r, g, b)).length;
    return { measured: count((r, g, b) => r > 150 && g < 90 && b > 80), simulated: count((r, g, b) => r < 90 && b > 150), limits: count((r, g, b) => r > 140 && g < 80 && b < 80) };
  }));
  assert.ok(drawn[0].measured > 50 && drawn[0].simulated > 50, `measured and simulated are drawn: ${JSON.stringify(drawn)}`);
  assert.ok(drawn[1].limits > 20, `the limits are drawn: ${JSON.stringify(drawn)}`);
  assert.equal((await channels(robot)).length, 8);
  await enter(robot, "twin-all");
  assert.equal((await channels(robot)).length, 29);
  fake.twin.differ("place x", 0.36);
  fake.twin.differ("place y", 0.48);
  fake.twin.off["left foot"] = fake.twin.off.right_knee = 0;
  await robot.says("twin-chip", "stands 0.6 m beside");
  await robot.says("twin-verdict", "Most of all: place y, 0.48 m (limit 0.25 m).");
  await pause(1200);
  await picture(robot, "twin_beside.png");
}));

test("what was driven is tried, does not pass, and is sent with a reason", () => withPage(async (robot, fake) => {
  await robot.hold("w");
  await robot.hints("Driving");
  await pause(1500);
  await robot.letGo("w");
  await robot.tab("Twin");
  await robot.says("twin-walk-from", "As it was driven here last.");
  assert.ok(await robot.page.$eval(".sending", (card) => card.hidden), "nothing has been sent yet");
  await set(robot, "twin-settings", "trajectory.step_time = 0.3\nzmp.gain=1");
  await enter(robot, "twin-send");
  await answered("it is sent to be tried", () => sends(fake).length === 1);
  const [first] = sends(fake);
  assert.ok(first.walk[0] > 0.1 && first.walk[1] === 0 && first.walk[2] === 0 && first.duration >= 1 && first.duration < 4, JSON.stringify(first));
  assert.deepEqual([first.motion, first.goal, first.settings, first.reason], ["", [], ["trajectory.step_time=0.3", "zmp.gain=1"], ""]);
  await robot.says("twin-sending", "Being tried");
  assert.ok(await robot.page.$eval("#twin-send", (press) => press.disabled), "one at a time");
  await picture(robot, "twin_trying.png");
  fake.twin.falls = 3;
  fake.twin.judge();
  await robot.says("twin-sending", "Not sent");
  await robot.says("twin-sending-text", "17 of 20 simulated robots stayed up and did it; robot 4 fell after 3.20 s");
  assert.deepEqual(await robot.page.$eval(".robots", (row) => ["up", "fell", "failed"].map((kind) => row.querySelectorAll(`.${kind}`).length)), [17, 1, 2]);
  await robot.says("twin-robots", "17 stayed up and did it, 1 fell, 2 fell or did not do it");
  await robot.newsOf("Not sent: walk");
  await robot.until(() => document.getElementById("twin-worst").width === 480 && !document.querySelector(".worst").hidden, "the picture of the worst one");
  assert.deepEqual(await robot.page.$eval("#twin-worst", (canvas) => [...canvas.getContext("2d").getImageData(240, 180, 1, 1).data]), [220, 30, 30, 255]);
  assert.deepEqual(fake.of("/simulation/twin/picture").map((args) => args.first), Array.from({ length: Math.ceil(fake.twin.picture_bytes / 48_000) }, (_none, part) => 48_000 * part));
  assert.ok(fake.twin.picture_bytes > 48_000, "it comes in several parts");
  await robot.page.focus("#twin-reason");
  await picture(robot, "twin_not_passed.png");
  await robot.page.keyboard.type("because w");
  await robot.says("twin-reason-note", "9 of 10 characters.");
  assert.ok(await robot.page.$eval("#twin-nevertheless", (press) => press.disabled), "9 are too few");
  assert.equal(sends(fake).length, 1);
  await set(robot, "twin-forward", "0.01"); // what is typed meanwhile was not tried
  await robot.page.focus("#twin-reason");
  await robot.page.keyboard.press("End");
  await robot.page.keyboard.type("e hold it");
  await robot.says("twin-reason-note", "18 characters. The reason is recorded with what is sent. It is tried again on simulated robots first");
  await enter(robot, "twin-nevertheless");
  await answered("it is sent with the reason", () => sends(fake).length === 2);
  assert.deepEqual(sends(fake)[1], { ...first, reason: "because we hold it" });
  fake.twin.judge();
  await robot.says("twin-sending", "The robot there does it");
  fake.twin.finish();
  await robot.says("twin-sending", "Done");
  await robot.newsOf("The robot there has done it: walk");
}));

test("motions and the goal of the map are sent; what is wrong or refused is said", () => withPage(async (robot, fake) => {
  await robot.tab("Twin");
  await enter(robot, "twin-kind-motion");
  await enter(robot, "twin-send");
  await robot.newsOf("No motion is chosen");
  await robot.page.select("#twin-motion", "kick");
  await enter(robot, "twin-send");
  await answered("the motion is tried", () => sends(fake).length === 1);
  assert.deepEqual([sends(fake)[0].motion, sends(fake)[0].walk], ["kick", []]);
  fake.twin.judge();
  fake.twin.finish();
  await robot.says("twin-sending", "Done");
  await enter(robot, "twin-kind-goal");
  await robot.says("twin-goal", "No goal is chosen");
  await robot.page.mouse.click(60, 540); // floor, beside the card
  await robot.says("way-text", "steps");
  await robot.says("twin-goal", "of the map");
  await enter(robot, "twin-send");
  await answered("the way is tried", () => sends(fake).length === 2);
  const { x, y, yaw } = fake.of("/simulation/plan")[0];
  assert.deepEqual(sends(fake)[1].goal, [x, y, yaw]);
  fake.twin.judge();
  fake.twin.finish();
  await robot.says("twin-sending", "Done");
  await robot.until(() => !document.getElementById("twin-send").disabled, "it may be sent");
  await enter(robot, "twin-kind-settings");
  await set(robot, "twin-settings", "step_time=0.3");
  await enter(robot, "twin-send");
  await robot.newsOf("Line 1 of the settings is 'step_time=0.3', and must be PLUGIN.PARAMETER=VALUE");
  await set(robot, "twin-settings", "trajectory.step_time=0.3");
  fake.twin.refusal = "trajectory has no parameter 'step_time' that can be changed while it walks";
  await enter(robot, "twin-send");
  await robot.newsOf("Send to the robot there: trajectory has no parameter 'step_time'");
  assert.deepEqual(fake.of("/command/acquire"), [], "none of it wants the command of the simulated robot");
}));

test("what was sent before its connection was lost is still of this page once it is back", () => withPage(async (robot, fake) => {
  await robot.tab("Twin");
  fake.losesAnswerOf = "/simulation/twin/send";
  await enter(robot, "twin-send");
  await robot.newsOf("Look whether it was carried out");
  await robot.says("twin-sending", "Being tried");
  fake.twin.falls = 1;
  fake.twin.judge();
  await robot.until(() => document.getElementById("twin-reason").checkVisibility(), "it is this page's");
  assert.equal(sends(fake).length, 1, "it is not sent again by itself");
  await robot.page.focus("#twin-reason");
  await robot.page.keyboard.type("it hangs in its crane");
  await enter(robot, "twin-nevertheless");
  await answered("it is sent with the reason", () => sends(fake).length === 2);
  assert.deepEqual(sends(fake)[1], { ...sends(fake)[0], reason: "it hangs in its crane" });
}));

test("who did not do it is not marked as fallen, and what fails before it was sent fails at the trial", () => withPage(async (robot, fake) => {
  const stages = () => robot.page.$$eval(".stages li", (all) => all.map(({ className }) => className));
  await robot.tab("Twin");
  assert.equal(await robot.page.$eval("#twin-settings", ({ placeholder }) => placeholder), "stability.ankle_pitch=0.3");
  assert.deepEqual(await robot.page.$eval("#twin-seconds", ({ min, max }) => [min, max]), ["0.5", "599"]);
  await set(robot, "twin-seconds", "600");
  await enter(robot, "twin-send");
  await robot.newsOf("“for” is '600', and must be 0.5 … 599 s");
  await set(robot, "twin-seconds", "599");
  await enter(robot, "twin-send");
  await answered("it is sent", () => sends(fake).length === 1);
  Object.assign(fake.twin, { falls: 4, worstEnds: "; robot 2: the gait has no such step" });
  fake.twin.judge();
  await robot.says("twin-robots", "16 stayed up and did it, 4 did not do it");
  assert.equal(await robot.page.$$eval(".robots .refused", (all) => all.length), 4);
  assert.deepEqual(await stages(), ["good", "bad", ""]);
  await robot.until(() => !document.querySelector(".worst").hidden, "the picture of the worst one");
  await pause(300);
  await picture(robot, "twin_refused_by_some.png");
  await enter(robot, "twin-send");
  await robot.says("twin-sending", "Being tried");
  fake.twin.fail("not tried: the robot walks and must stand");
  await robot.says("twin-sending", "Failed");
  assert.deepEqual(await stages(), ["bad", "", ""]);
}));

test("a lost link is told, a refused one can be tried again, and the robot is followed or not", () => withPage(async (robot, fake) => {
  await robot.tab("Twin");
  Object.assign(fake.twin, { state: "lost", hears: false, text: "nothing has come for 1.0 s" });
  await robot.newsOf("The robot there is lost: nothing has come for 1.0 s. It is tried again by itself.");
  await robot.says("twin-link", "lost");
  await robot.says("twin-why", "nothing has come for 1.0 s");
  await robot.says("twin-send-why", "The robot there is not connected");
  await robot.says("twin-stop", "it is not heard of");
  await robot.press("twin-stop");
  await answered("it can be told to stop all the same", () => fake.of("/simulation/twin/stop").length === 1);
  await robot.newsOf("Stop the robot there: it is tried, but the robot there is not heard of");
  assert.ok(await robot.page.$eval("#twin-send", (press) => press.disabled));
  assert.ok(await hidden(robot, "twin-again"), "it tries by itself");
  await pause(300);
  await picture(robot, "twin_lost.png");
  Object.assign(fake.twin, { state: "refused", text: "it is another robot: humanoid12" });
  await robot.newsOf("The robot there has been refused: it is another robot: humanoid12");
  await enter(robot, "twin-again");
  await answered("it is tried again", () => fake.of("/simulation/twin/reconnect").length === 1);
  Object.assign(fake.twin, { state: "connected", hears: true, text: "" });
  await robot.newsOf("The robot there is connected: ws://10.0.0.7:9090");
  Object.assign(fake.twin, { follows: false, followsText: "the simulation is paused" });
  await robot.newsOf("The simulated robot does not follow any more: the simulation is paused");
  await robot.says("twin-follows-why", "It does not: the simulation is paused.");
  await robot.says("twin-verdict", "Not compared: the simulation is paused.");
  await robot.says("twin-chip", "Not compared: the simulation is paused");
  await pause(300);
  await picture(robot, "twin_not_compared.png");
  await enter(robot, "twin-follow");
  await answered("it follows", () => fake.of("/simulation/twin/follow").at(-1)?.data === true);
  await robot.until(() => document.getElementById("twin-follow").getAttribute("aria-checked") === "true", "it is said that it does");
  fake.tellsTwin = false;
  await robot.says("twin-link", "not heard of");
  await robot.says("twin-chip", "not heard of");
}));

test("on a phone it fits, and all of it can be reached", () => withPage(async (robot, fake) => {
  const fits = () => robot.page.evaluate(() => document.documentElement.scrollWidth <= 360 && document.getElementById("panels").scrollWidth <= document.getElementById("panels").clientWidth);
  await picture(robot, "twin_phone_world.png");
  assert.ok((await there(robot)).count > 300, "the robot there is drawn");
  await robot.page.tap("#twin-chip");
  await robot.says("twin-verdict", "agree");
  fake.twin.differ("left_ankle_roll", 0.05);
  await verdict(robot, "differ");
  await pause(1200);
  assert.ok(await fits(), "nothing is wider than a phone");
  await picture(robot, "twin_phone.png");
  await robot.page.tap("#twin-send");
  await answered("it is tried", () => sends(fake).length === 1);
  fake.twin.falls = 1;
  fake.twin.judge();
  await robot.until(() => !document.querySelector(".worst").hidden, "the picture of the worst one");
  assert.ok(await fits());
  await picture(robot, "twin_phone_not_passed.png");
  await robot.page.tap("#twin-reason");
  await robot.page.keyboard.type("it hangs in its crane");
  await robot.page.tap("#twin-nevertheless");
  await answered("it is sent", () => sends(fake).length === 2);
  await robot.page.tap("#twin-stop");
  await answered("it is stopped", () => fake.of("/simulation/twin/stop").length === 1);
}, { viewport: phone }));

test("a simulator without a twin has the page that it had", () => withPage(async (robot) => {
  assert.deepEqual(await robot.page.$$("#twin-chip, #twin-stop, #twin-show"), []);
  assert.ok(!(await robot.page.$$eval("[role=tab]", (tabs) => tabs.some(({ textContent }) => textContent === "Twin"))));
}, { twin: false }));
