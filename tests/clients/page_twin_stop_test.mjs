// The stops of a page that has a twin: of the robot there, of both robots, and above what lies open. Arguments: see page_twin_page.mjs.
import assert from "node:assert/strict";
import test from "node:test";
import { answered, enter, hidden, pause, phone, picture, sends, withPage } from "./page_twin_page.mjs";

test("the stop of the robot there is in its view always, and elsewhere while something is sent", () => withPage(async (robot, fake) => {
  assert.ok(await hidden(robot, "twin-stop"), "nothing is sent");
  await robot.tab("Twin");
  await robot.until(() => !document.getElementById("twin-stop").hidden, "it is there");
  await enter(robot, "twin-send");
  await robot.says("twin-sending", "Being tried");
  await robot.tab("Drive");
  await robot.says("twin-stop", "being tried: walk 0.10 m/s, 10 s");
  await picture(robot, "twin_sending_elsewhere.png");
  fake.twin.judge();
  await robot.says("twin-stop", "it does: walk 0.10 m/s, 10 s");
  await robot.press("twin-stop");
  await answered("it is stopped", () => fake.of("/simulation/twin/stop").length > 0);
  await robot.newsOf("Stopped: walk 0.10 m/s, 10 s");
  await robot.until(() => document.getElementById("twin-stop").hidden, "nothing is sent any more");
  assert.equal(fake.of("/simulation/twin/stop").length, 1, "a press is one stop");
  assert.deepEqual(fake.of("/stop"), [], "the simulated robot is not stopped by it");
  await robot.tab("Twin");
  await enter(robot, "twin-stop");
  await answered("by the keyboard, too", () => fake.of("/simulation/twin/stop").length === 2);
}));

test("while something is tried or sent, each stop of the page is for the robot there, too, and first", () => withPage(async (robot, fake) => {
  const stops = () => fake.asked.map(({ service }) => service).filter((service) => ["/simulation/twin/stop", "/stop", "/emergency_stop"].includes(service));
  await robot.tab("Twin");
  const waysToStop = [
    ["Stop", "/stop", () => robot.press("stop")], ["Emergency stop", "/emergency_stop", () => robot.press("emergency")], ["Escape", "/stop", () => robot.page.keyboard.press("Escape")],
    ["Escape in a field", "/stop", async () => { await robot.page.focus("#twin-settings"); await robot.page.keyboard.press("Escape"); }],
  ];
  for (const [name, service, stop] of waysToStop) {
    fake.asked.length = 0;
    await enter(robot, "twin-send");
    await robot.says("twin-sending", "Being tried");
    if (name !== "Stop") fake.twin.judge();
    await stop();
    await answered(`${name}: both are stopped`, () => stops().includes(service));
    assert.equal(stops()[0], "/simulation/twin/stop", `${name}: the robot there first: ${stops()}`);
    await robot.newsOf("Stop the robot there, too: it is told");
    await robot.says("twin-sending", "Stopped");
  }
  fake.asked.length = 0;
  await robot.page.keyboard.press("Escape");
  await answered("Escape", () => stops().includes("/stop"));
  assert.deepEqual(stops().filter((service) => service !== "/stop"), [], "where nothing is tried or sent the robot there goes on");
  await enter(robot, "play");
  await robot.says("link-text", "paused");
  await robot.page.mouse.click(60, 540); // a goal that Escape would only forget
  await robot.says("way-text", "steps");
  await enter(robot, "twin-send");
  await robot.says("twin-sending", "Being tried");
  fake.asked.length = 0;
  await robot.page.keyboard.press("Escape");
  await answered("in a simulation that is paused, too", () => stops().includes("/simulation/twin/stop"));
  await robot.says("twin-sending", "Stopped");
  await enter(robot, "twin-send");
  await robot.says("twin-sending", "Being tried");
  await robot.page.evaluate(() => document.activeElement.blur());
  fake.asked.length = 0;
  fake.silence(); // Space is for the simulator only while it is heard of
  await robot.until(() => document.getElementById("stop").textContent.includes("Space"), "Space stops");
  await robot.page.keyboard.press("Space");
  await answered("Space", () => stops().includes("/stop"));
  assert.equal(stops()[0], "/simulation/twin/stop");
}));

for (const [name, viewport] of [["a desktop", undefined], ["a phone", phone]]) {
  test(`the picture of the worst robot opens large, and the stops act above it, on ${name}`, () => withPage(async (robot, fake) => {
    await robot.tab("Twin");
    await enter(robot, "twin-send");
    await answered("it is sent", () => sends(fake).length === 1);
    fake.twin.falls = 1;
    fake.twin.judge();
    await robot.until(() => !document.querySelector(".worst").hidden, "the picture of the worst one");
    const small = await robot.page.$eval("#twin-worst", (canvas) => canvas.getBoundingClientRect().width);
    await robot.press("twin-worst-open");
    await robot.until(() => document.getElementById("twin-worst-dialog")?.open, "it is open");
    await pause(300);
    await picture(robot, `twin_worst_large${viewport ? "_phone" : ""}.png`);
    const large = await robot.page.$eval("#twin-worst-large", (canvas) => ({ width: Math.min(canvas.getBoundingClientRect().width, (canvas.getBoundingClientRect().height * 4) / 3), pixel: [...canvas.getContext("2d").getImageData(240, 180, 1, 1).data] }));
    assert.ok(large.width > (viewport ? small : 1.5 * small), `${large.width} px wide, and was ${small}`);
    assert.deepEqual(large.pixel, [220, 30, 30, 255]);
    for (const [id, service] of [["twin-stop", "/simulation/twin/stop"], ["stop", "/stop"], ["emergency", "/emergency_stop"]]) {
      await robot.press(id); // by the pointer: whatever lies above it would take that
      await answered(`${id} acts`, () => fake.of(service).length > 0);
    }
    fake.asked.length = 0;
    await robot.page.keyboard.press("Escape");
    await answered("Escape stops", () => fake.of("/stop").length > 0);
    await robot.until(() => !document.getElementById("twin-worst-dialog"), "and closes it");
    await robot.press("twin-worst-open");
    await robot.press("twin-worst-close");
    await robot.until(() => !document.getElementById("twin-worst-dialog"), "and so does its button");
  }, { viewport }));
}
