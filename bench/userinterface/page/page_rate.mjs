#!/usr/bin/env node
// How smoothly and how cheaply the page draws while the robot walks: pictures a second, processor time of the whole browser, first
// picture, growth of the JavaScript heap. The browser is headless Chromium that draws in software; all of it is pinned to one core.
//
//     ./dev bench --build; .deps/python/bin/node bench/userinterface/page/page_rate.mjs [--seconds 20] [--core 1] [--view Drive] [--dark]
//         [--solids 2000] [--twin]
//
// --solids: the page of a simulator (the one of tests/clients/page_simulator_test.mjs) whose world has so many, while the robot goes there and back.
// --twin: that simulator has a twin: a second robot in the picture, and the view Twin.
// A picture counts when the page has given it to WebGL; the browser asks for the next one only when it has taken the former, so pictures
// that are given are shown.
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { cpus, loadavg, tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../..");
process.env.GAITWAY_PAGE_PACKAGES ??= path.join(root, ".deps/web");
process.env.GAITWAY_CHROMIUM ??= "/usr/bin/chromium";
const { openBrowser, processorSeconds, RobotPage } = await import("../../../tests/clients/page_browser.mjs");
const { values: options } = parseArgs({ options: {
  seconds: { type: "string", default: "20" },
  core: { type: "string", default: String(cpus().length - 1) },
  view: { type: "string", default: "Drive" },
  dark: { type: "boolean", default: false },
  pictures: { type: "string" },
  solids: { type: "string" },
  twin: { type: "boolean", default: false },
} });
const viewports = [{ width: 1280, height: 720 }, { width: 360, height: 740, hasTouch: true, isMobile: true }];

async function freePort() {
  const probe = createServer().listen(0, "127.0.0.1");
  await new Promise((resolve) => probe.once("listening", resolve));
  const { port } = probe.address();
  await new Promise((resolve) => probe.close(resolve));
  return port;
}

// Gives a robot that serves, and how to end it.
async function serveRobot(folder) {
  const port = await freePort();
  const robot = spawn(path.join(root, "build/release/bin/gaitway"), ["serve", "--port", String(port), "--out", path.join(folder, "out")], { stdio: ["ignore", "pipe", "pipe"] });
  let said = "";
  await new Promise((resolve, reject) => {
    const take = (text) => /serves ws/.test((said += text)) && resolve();
    robot.stdout.on("data", take);
    robot.stderr.on("data", take);
    robot.once("exit", (code) => reject(new Error(`gaitway serve ended with ${code}: ${said}`)));
  });
  const ended = new Promise((resolve) => robot.once("exit", resolve));
  return { url: `http://127.0.0.1:${port}/`, end: () => (robot.kill("SIGINT"), ended), walk: (page) => page.hold("w"), stand: (page) => page.letGo("w") };
}

// A simulator whose world has so many solids, a tenth of which move.
async function serveWorld(folder, count) {
  const real = await serveRobot(folder);
  const description = await (await fetch(`${real.url}robot.json`)).json();
  await real.end();
  const { FakeSimulator, solid } = await import("../../../tests/clients/page_simulator_fake.mjs");
  const side = Math.ceil(Math.sqrt(count)), shapes = ["box", "box", "box", "cylinder", "sphere"];
  const solids = Array.from({ length: count }, (_none, index) => {
    const [x, y] = [(index % side) - side / 2, Math.floor(index / side) - side / 2].map((at) => at * 0.45);
    return solid(`solid_${index}`, "thing", shapes[index % 5], [0.15, 0.15, 0.15], [x, y + 0.2], index, [0.3 + 0.6 * ((index * 7) % 11) / 11, 0.6, 0.4], index < 64);
  });
  const fake = await FakeSimulator.serve(description, solids, { twin: options.twin });
  let way;
  const moves = setInterval(() => solids.slice(0, 64).forEach((one, index) => (one.pose[0] += 0.004 * Math.sin(index + Date.now() / 300))), 50);
  const walk = async () => {
    fake.walk([2, 0.3, 0]);
    way = setInterval(() => fake.walk([fake.robot[0] > 0 ? -2 : 2, 0.3, 0]), 9000);
  };
  return { url: fake.url, end: () => (clearInterval(moves), fake.end()), walk, stand: () => clearInterval(way) };
}

// What is started by `job` runs on one core.
async function onOneCore(core, job) {
  const pin = (list) => execFileSync("taskset", ["-acp", list, String(process.pid)], { stdio: "ignore" });
  pin(core);
  try {
    return await job();
  } finally {
    pin(`0-${cpus().length - 1}`);
  }
}

const at = (sorted, share) => sorted[Math.min(Math.floor(share * sorted.length), sorted.length - 1)];
const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function countPictures() {
  window.pictures_ms = [];
  const clear = WebGL2RenderingContext.prototype.clear;
  WebGL2RenderingContext.prototype.clear = function (mask) {
    const now_ms = performance.now(); // two clears of one picture are one
    if (now_ms - (window.pictures_ms.at(-1) ?? 0) > 2) window.pictures_ms.push(now_ms);
    return clear.call(this, mask);
  };
}

async function heapBytes(page, session) {
  await session.send("HeapProfiler.collectGarbage");
  return (await page.metrics()).JSHeapUsedSize;
}

async function measure(browser, served, viewport) {
  const robot = new RobotPage();
  robot.page = await browser.newPage();
  await robot.page.setViewport(viewport);
  if (options.dark) await robot.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await robot.page.evaluateOnNewDocument(countPictures);
  await robot.page.goto(served.url);
  await robot.until(() => performance.getEntriesByName("first-picture").length > 0, "a picture");
  const first_ms = await robot.page.evaluate(() => performance.getEntriesByName("first-picture")[0].startTime);
  await robot.live();
  await robot.until((title) => [...document.querySelectorAll("[role=tab]")].some(({ textContent }) => textContent === title), `the view ${options.view}`, undefined, options.view);
  await robot.tab(options.view);
  await served.walk(robot);
  await robot.says("activity", "walks");
  await pause(4000); // the page finds its resolution
  const session = await robot.page.createCDPSession();
  const heap = await heapBytes(robot.page, session);
  const [began_ms, began_s] = [await robot.page.evaluate(() => performance.now()), processorSeconds(browser)];
  await pause(1000 * Number(options.seconds));
  const [ended_ms, ended_s] = [await robot.page.evaluate(() => performance.now()), processorSeconds(browser)];
  const times_ms = await robot.page.evaluate((from, to) => window.pictures_ms.filter((time) => time >= from && time < to), began_ms, ended_ms);
  const walks = (await robot.text("activity")) === "walks";
  const grown = (await heapBytes(robot.page, session)) - heap;
  const pixels = await robot.page.$eval("#scene", ({ width, height, clientWidth, clientHeight }) => `${width}x${height} in ${clientWidth}x${clientHeight}`);
  if (options.pictures) await robot.page.screenshot({ path: `${options.pictures}_${viewport.width}.png` });
  await served.stand(robot);
  await robot.close();
  const intervals_ms = times_ms.slice(1).map((time, index) => time - times_ms[index]).sort((a, b) => a - b);
  const span_s = (ended_ms - began_ms) / 1000;
  console.log(`${viewport.width}x${viewport.height}: ${(times_ms.length / span_s).toFixed(1)} pictures/s (median ${(1000 / at(intervals_ms, 0.5)).toFixed(1)}, p5 ${(1000 / at(intervals_ms, 0.95)).toFixed(1)}, ` +
    `longest gap ${intervals_ms.at(-1).toFixed(0)} ms), browser ${((ended_s - began_s) / span_s).toFixed(2)} cores, first picture ${first_ms.toFixed(0)} ms, ` +
    `heap ${(grown / 1024).toFixed(0)} KiB more after ${span_s.toFixed(0)} s, drawn ${pixels}, ${walks ? "walks" : "DOES NOT WALK"}, load of the computer ${loadavg()[0].toFixed(1)}`);
}

const folder = mkdtempSync(path.join(tmpdir(), "gaitway_page_rate_"));
const robot = options.solids ? await serveWorld(folder, Number(options.solids)) : await serveRobot(folder);
try {
  for (const viewport of viewports) {
    const browser = await onOneCore(options.core, openBrowser);
    try {
      await measure(browser, robot, viewport);
    } finally {
      await browser.close();
    }
  }
} finally {
  await robot.end();
  rmSync(folder, { recursive: true });
}
