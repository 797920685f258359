// A page of a simulator that has a twin, in a real browser, as its tests handle it. Argument of the program: the port of a module, whose robot it
// is. GAITWAY_SCREENSHOTS: a folder for pictures of it.
import assert from "node:assert/strict";
import path from "node:path";
import { after, before } from "node:test";
import { openBrowser, pixelsOf, RobotPage } from "./page_browser.mjs";
import { FakeSimulator, room } from "./page_simulator_fake.mjs";

export const phone = { width: 360, height: 740, hasTouch: true, isMobile: true };
const clearColour = "r > 150 && g < 150 && b > 105 && r > g * 1.4 && b > g * 1.1"; // of the robot there
const description = await (await fetch(`http://127.0.0.1:${process.argv[2]}/robot.json`)).json();
let browser, eye;
before(async () => {
  browser = await openBrowser();
  eye = await browser.newPage();
});
after(() => browser.close());

export const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// `use`: with a page of a simulator that has a twin, and that simulator.
export async function withPage(use, { viewport, prepare = () => {}, twin = true } = {}) {
  const fake = await FakeSimulator.serve(description, room(), { twin });
  prepare(fake);
  const robot = await RobotPage.open(browser, fake.url, viewport);
  try {
    await robot.live();
    await robot.until(() => document.getElementById("simulator"), "the simulator's bar");
    if (twin) await robot.until(() => document.getElementById("twin-chip"), "the twin");
    await pause(500); // the world has come, and the robot there stands in it
    await use(robot, fake);
    assert.deepEqual(robot.errors, []);
  } finally {
    await robot.close();
    fake.end();
  }
}

export async function picture(robot, name) {
  if (process.env.GAITWAY_SCREENSHOTS) await robot.page.screenshot({ path: path.join(process.env.GAITWAY_SCREENSHOTS, name) });
}
export async function answered(what, look) {
  for (const end_ms = performance.now() + 5000; performance.now() < end_ms; await pause(20)) if (look()) return;
  assert.fail(`not within 5 s: ${what}`);
}
export const pixels = (robot, condition) => pixelsOf(robot.page, eye, condition);
export const there = (robot) => pixels(robot, clearColour);
export const hidden = (robot, id) => robot.page.$eval(`#${id}`, (found) => found.hidden);
export const set = (robot, id, value) => robot.page.$eval(`#${id}`, (field, text) => (field.value = text), value);
// By the keyboard.
export async function enter(robot, id) {
  await robot.until((name) => document.getElementById(name).checkVisibility() && !document.getElementById(name).disabled, `${id} can be pressed`, undefined, id);
  await robot.page.focus(`#${id}`);
  await robot.page.keyboard.press("Enter");
}
export const verdict = (robot, wanted) => robot.until((name) => document.getElementById("twin-chip").dataset.verdict === name, `the verdict is '${wanted}'`, undefined, wanted);
export const channels = (robot) => robot.page.$$eval(".differences tbody tr", (rows) => rows.filter((row) => !row.hidden).map(({ dataset }) => dataset.channel));
export const sends = (fake) => fake.of("/simulation/twin/send");
