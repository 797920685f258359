// The report of `gaitway simulate` from the disk: it shows its findings, is scrubbed, played slowly and turned, fits a phone, asks nobody
// for anything. GAITWAY_SCREENSHOTS: a folder for pictures of it.
import assert from "node:assert/strict";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { RobotPage, openBrowser } from "./page_browser.mjs";

const [compared, walk] = process.argv.slice(2).map((file) => pathToFileURL(file).href);
const browser = await openBrowser();
const clock = (page) => page.page.$eval(".clock", (shown) => parseFloat(shown.textContent));
// What the pictures show, as one text.
const pictures = (page) => page.page.$$eval("canvas", (all) => all.map((canvas) => canvas.toDataURL()).join());
async function picture(page, name) {
  if (process.env.GAITWAY_SCREENSHOTS) await page.page.screenshot({ path: path.join(process.env.GAITWAY_SCREENSHOTS, name), fullPage: true });
}
async function frames(page, count = 2) {
  for (let i = 0; i < count; ++i) await page.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
}

try {
  const page = await RobotPage.open(browser, compared, { width: 1280, height: 900 });
  await page.until(() => document.querySelectorAll("canvas").length >= 9, "both robots, both soles, curves");
  await frames(page);
  await picture(page, "compared.png");

  // It begins at the first finding, with the joint that it is of.
  assert.match(await page.page.$eval("p.bad", (line) => line.textContent), /^\d+ findings?$/);
  assert.equal(await page.page.$eval("h2 select", (choice) => choice.selectedOptions[0].textContent), "neck_pitch");
  const rows = await page.page.$$eval("tr.jump", (all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  const position = rows.findIndex((row) => row[1] === "neck_pitch" && row[2] === "position");
  assert.deepEqual(rows[position].slice(0, 2).concat(rows[position].slice(5)), ["1.000", "neck_pitch", "1.000", "1.090"]);

  // Scrubbing moves robot and clock; a finding leads back to its instant.
  await page.page.$eval("input[type=range]", (slider) => { slider.value = 0.3; slider.dispatchEvent(new Event("input")); });
  await frames(page);
  assert.equal(await clock(page), 0.3);
  const before = await pictures(page);
  await (await page.page.$$("tr.jump"))[position].click();
  await frames(page);
  assert.equal(await clock(page), 1.0);
  assert.notEqual(await pictures(page), before);

  // A row on, and slowly: a twentieth of a second for each second.
  await page.page.evaluate(() => document.activeElement.blur());
  await page.page.keyboard.press("ArrowRight");
  await frames(page);
  assert.equal(await clock(page), 1.01);
  await page.page.select(".bar select", "0.05");
  const run = await page.page.evaluate(async () => {
    const button = document.querySelector(".bar button");
    const at = () => parseFloat(document.querySelector(".clock").textContent);
    const frame = () => new Promise(requestAnimationFrame);
    button.click();
    await frame();
    const begin = [await frame(), at()];
    let end = begin;
    while (end[0] - begin[0] < 1000) end = [await frame(), at()];
    button.click();
    return { wall_s: (end[0] - begin[0]) / 1000, shown_s: end[1] - begin[1] };
  });
  assert.ok(run.shown_s > 0 && run.shown_s <= 0.05 * run.wall_s + 0.006, JSON.stringify(run));

  // Turned by dragging.
  const [robot] = await page.page.$$("canvas");
  const still = await pictures(page);
  const box = await robot.boundingBox();
  await page.page.mouse.move(box.x + 100, box.y + 100);
  await page.page.mouse.down();
  await page.page.mouse.move(box.x + 200, box.y + 100);
  await page.page.mouse.up();
  await frames(page);
  assert.notEqual(await pictures(page), still);
  assert.deepEqual(page.errors, []);

  const small = await RobotPage.open(browser, walk, { width: 360, height: 740 });
  await small.until(() => document.querySelectorAll("canvas").length >= 6, "robot, soles, curves");
  await frames(small);
  assert.equal(await small.page.$eval("p.good", (line) => line.textContent), "No finding");
  assert.ok(await small.page.evaluate(() => document.documentElement.scrollWidth <= 360), "nothing is wider than a phone");
  await picture(small, "walk_phone.png");
  const requests = await small.page.evaluate(() => performance.getEntriesByType("resource").length);
  assert.equal(requests, 0, "it asks nobody for anything");
  assert.deepEqual(small.errors, []);
  await small.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await small.page.setViewport({ width: 1280, height: 900 });
  await frames(small, 4);
  await picture(small, "walk_dark.png");
} finally {
  await browser.close();
}
