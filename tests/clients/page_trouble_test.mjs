// What the page says of bad input, in a real browser. Arguments: ports of a served robot, of a second module on it, of a module of
// another robot's folder, of one with nobody at its link and an expired certificate; the token of that one; its folder.
// GAITWAY_PAGE_PICTURES: a folder for a picture of each banner.
import assert from "node:assert/strict";
import http from "node:http";
import path from "node:path";
import test, { after, before } from "node:test";
import { openBrowser, RobotPage } from "./page_browser.mjs";

const [port, secondPort, otherPort, alonePort, token, folder] = process.argv.slice(2);
const address = (ofPort) => `http://127.0.0.1:${ofPort}/`;
const sizes = [{ width: 1280, height: 720 }, { width: 360, height: 740 }];
let browser;
before(async () => {
  browser = await openBrowser({ acceptInsecureCerts: true });
});
after(() => browser.close());

// Not by fetch: that of Node.js 24 fails an assertion of its own where a long answer's connection ends before it has been read.
const read = (url) => new Promise((resolve, reject) => {
  http.get(url, async (answer) => resolve(Buffer.concat(await answer.toArray()).toString())).on("error", reject);
});

// The banner says all of this, at every size, within the picture, and hides no Stop.
async function assertBanner(robot, name, ...texts) {
  await robot.until((words) => words.every((text) => document.getElementById("trouble-text").textContent.includes(text)) && !document.getElementById("trouble").hidden,
    `the banner says ${texts.join(", ")}`, undefined, texts);
  for (const size of sizes) {
    await robot.page.setViewport(size);
    const [banner, picture] = await Promise.all(["#trouble", "#picture"].map(async (id) => (await robot.page.$(id)).boundingBox()));
    assert.ok(banner.x >= picture.x && banner.x + banner.width <= picture.x + picture.width, `${name}: it is too wide`);
    assert.ok(banner.y >= picture.y && banner.y + banner.height <= picture.y + picture.height, `${name}: it is too high`);
    assert.equal(await robot.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
    const file = process.env.GAITWAY_PAGE_PICTURES && path.join(process.env.GAITWAY_PAGE_PICTURES, `${name}_${size.width}.png`);
    if (file) await robot.page.screenshot({ path: file });
  }
}

test("a page of another version than its server's asks to be loaded again, draws nothing, and stops all the same", async () => {
  const robot = await RobotPage.open(browser, "about:blank");
  await robot.page.setRequestInterception(true);
  let version;
  const change = async (request) => {
    if (!request.url().endsWith("/page.js")) return request.continue();
    const [script, served] = await Promise.all([read(request.url()), read(`${address(port)}version.json`)]);
    version = JSON.parse(served).page;
    assert.ok(script.includes(version));
    return request.respond({ contentType: "text/javascript", body: script.replaceAll(version, "feedfeedfeedfeed") });
  };
  robot.page.on("request", change);
  await robot.page.goto(address(port));
  await assertBanner(robot, "other_version", "this is page feedfeedfeedfeed, the robot has page ", "load the page again", "Stop still works");
  assert.ok((await robot.text("trouble-text")).includes(version));
  assert.equal(await robot.text("link-text"), "no connection");
  await robot.hold("w");
  await robot.press("stop");
  await robot.newsOf("Stop: done");
  assert.notEqual(await robot.text("commander"), "you command", "it drives no more");
  await robot.letGo("w");
  await robot.until(() => document.getElementById("news").textContent === "", "old news goes");
  await robot.page.evaluate(() => (navigator.getGamepads = () => [{ connected: true, axes: [0, -1, 0, 0], buttons: Array.from({ length: 4 }, () => ({ pressed: true })) }]));
  await robot.newsOf("Stop: done"); // a game pad's buttons stop, too
  assert.notEqual(await robot.text("commander"), "you command", "and its stick drives no more");
  assert.deepEqual(await robot.page.evaluate(() => ["top", "camera", "panel", "stops"].map((part) => document.getElementById(part).inert)), [true, true, true, false]);
  robot.page.off("request", change);
  robot.page.on("request", (request) => request.continue());
  await Promise.all([robot.page.waitForNavigation(), robot.press("trouble-button")]);
  await robot.live();
  assert.equal(await robot.page.$eval("#trouble", (banner) => banner.hidden), true);
  await robot.close();
});

test("a second module on a robot says whose the link is", async () => {
  const robot = await RobotPage.open(browser, address(secondPort));
  await assertBanner(robot, "second_module", "The robot is not there: refused: ", "linked to another module, 'user_interface ", "a robot has one: end that one, or this one");
  assert.ok(!(await robot.page.$eval("#link", (lamp) => lamp.classList.contains("live"))));
  await robot.close();
});

test("a module of another robot's folder says what differs", async () => {
  const robot = await RobotPage.open(browser, address(otherPort));
  await assertBanner(robot, "wrong_robot", "has the robot's description ", "'controller of humanoid22', has ", "give both the same robot.urdf and robot.yaml", "/other");
  await robot.close();
});

test("a link with nobody at its other end says where, and an expired certificate is spoken of", async () => {
  const robot = await RobotPage.open(browser, `https://127.0.0.1:${alonePort}/`);
  await robot.page.waitForSelector("dialog[open]");
  await robot.page.type("#token-text", token);
  await robot.page.keyboard.press("Enter");
  await assertBanner(robot, "link_down", `'${folder}/link.sock': cannot connect`, "Is main_controller running", "The certificate of 'localhost' in certificate_file", "expired on", "1 day ago");
  const age = await robot.text("trouble-age");
  assert.match(age, /^For \d/);
  await robot.until((before) => document.getElementById("trouble-age").textContent !== before, "time passes", undefined, age);
  await robot.close();
});

test("shows what the robot is calibrated with, or that it is not, on a narrow phone, too", async () => {
  for (const [ofPort, summary, knee] of [[secondPort, "Calibrated, made 2026-11-25 03:21 UTC.", "−0.500 ± 0.030"], [port, "This robot has no calibration", "as described"]]) {
    const robot = await RobotPage.open(browser, address(ofPort), sizes[1]);
    await robot.until(() => document.querySelectorAll("[role=tab]").length > 0, "tabs");
    await robot.tab("State");
    await robot.page.evaluate(() => document.querySelector(".calibration summary").click());
    await robot.until((words) => document.querySelector(".calibration").textContent.includes(words), summary, undefined, summary);
    const of = (row) => robot.page.$$eval(".calibration tr", (rows, name) => rows.find((one) => one.cells[0].textContent === name)?.cells[1].textContent, row);
    assert.equal(await of("left knee"), knee);
    assert.equal((await robot.page.$$(".calibration .zeros tbody tr")).length, 22);
    assert.equal(await of("front right"), ofPort === secondPort ? "0.990" : "as described");
    assert.equal(await of("y, pitch"), ofPort === secondPort ? "−2.0 ± 1.0" : "as described");
    for (const size of sizes) {
      await robot.page.setViewport(size);
      assert.equal(await robot.page.$eval("#panels", (panels) => panels.scrollWidth - panels.clientWidth), 0);
      await robot.page.$eval(".calibration", (box) => box.scrollIntoView());
      if (process.env.GAITWAY_PAGE_PICTURES) await robot.page.screenshot({ path: path.join(process.env.GAITWAY_PAGE_PICTURES, `calibration_${ofPort === secondPort ? "there" : "none"}_${size.width}.png`) });
    }
    await robot.close();
  }
});
