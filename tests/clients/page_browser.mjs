// A headless Chromium, and a page in it as a person sees and handles it.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const puppeteer = createRequire(path.join(process.env.GAITWAY_PAGE_PACKAGES, "package.json"))("puppeteer-core");
const patience_ms = 20_000;

// `elsewhere.example` is this computer, too.
export const openBrowser = (more = {}) => puppeteer.launch({
  ...more,
  executablePath: process.env.GAITWAY_CHROMIUM,
  args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox", "--host-resolver-rules=MAP elsewhere.example 127.0.0.1"],
});

// Processor time that the browser and all of its processes have taken.
export function processorSeconds(browser) {
  const parents = new Map(), ticks = new Map();
  for (const entry of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    const text = readFileOr(`/proc/${entry}/stat`, "");
    const fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
    parents.set(Number(entry), Number(fields[1]));
    ticks.set(Number(entry), Number(fields[11]) + Number(fields[12]));
  }
  const root = browser.process().pid;
  const belongs = (id) => id === root || (parents.has(id) && belongs(parents.get(id)));
  const ticksPerSecond = 100; // of /proc, on every Linux
  return [...ticks].reduce((sum, [id, count]) => sum + (belongs(id) && count > 0 ? count / ticksPerSecond : 0), 0);
}

function readFileOr(file, otherwise) {
  try {
    return readFileSync(file, "utf8");
  } catch {
    return otherwise; // the process has ended
  }
}

// How many pixels of a page's window satisfy `condition` of r, g and b, and the middle of them. `eye`: another page, which looks at the picture: the
// page's own policy lets no script read one.
export async function pixelsOf(page, eye, condition) {
  const shot = await page.screenshot({ encoding: "base64" });
  return eye.evaluate(async (png, text) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    canvas.drawImage(bitmap, 0, 0);
    const { data, width } = canvas.getImageData(0, 0, bitmap.width, bitmap.height);
    const holds = new Function("r", "g", "b", `return ${text}`);
    let [count, x, y] = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (!holds(data[i], data[i + 1], data[i + 2])) continue;
      count += 1;
      x += (i / 4) % width;
      y += Math.floor(i / 4 / width);
    }
    return { count, x: x / count + 0.5, y: y / count + 0.5 };
  }, shot, condition);
}

export class RobotPage {
  errors = [];

  static async open(browser, url, viewport = { width: 1280, height: 800 }) {
    const opened = new RobotPage();
    opened.page = await browser.newPage();
    opened.page.on("pageerror", (error) => opened.errors.push(error.message));
    opened.page.on("console", (message) => message.type() === "error" && opened.errors.push(message.text()));
    await opened.page.setViewport(viewport);
    await opened.page.goto(url);
    return opened;
  }

  // `look`: a function of the page's own; waits until it gives something true, and gives that.
  async until(look, what, timeout_ms = patience_ms, ...inputs) {
    try {
      const found = await this.page.waitForFunction(look, { polling: 20, timeout: timeout_ms }, ...inputs);
      return await found.jsonValue();
    } catch (error) {
      assert.fail(`not within ${timeout_ms} ms: ${what} (${error.message}); the page says: ${await this.said()}`);
    }
  }
  live(timeout_ms) {
    return this.until(() => document.getElementById("link").classList.contains("live"), "live", timeout_ms);
  }
  // Of the top line and the hint below the stick.
  says(id, text, timeout_ms) {
    return this.until((where, words) => document.getElementById(where)?.textContent.includes(words), `${id} says '${text}'`, timeout_ms, id, text);
  }
  hints(text, timeout_ms) {
    return this.until((words) => document.querySelector(".drive .hint").textContent.includes(words), `hint '${text}'`, timeout_ms, text);
  }
  newsOf(text, timeout_ms) {
    return this.until((words) => document.getElementById("news").textContent.includes(words), `news '${text}'`, timeout_ms, text);
  }
  text(id) {
    return this.page.$eval(`#${id}`, (element) => element.textContent);
  }
  said() {
    return this.page.evaluate(() => document.getElementById("top").innerText.replaceAll("\n", " | ") + ` || ${document.querySelector(".drive .hint")?.textContent} || ${document.getElementById("news").innerText}`);
  }
  hold(key) {
    return this.page.keyboard.down(key);
  }
  letGo(key) {
    return this.page.keyboard.up(key);
  }
  press(id) {
    return this.page.click(`#${id}`);
  }
  async tab(title) {
    await this.page.evaluate((wanted) => {
      const tab = [...document.querySelectorAll("[role=tab]")].find(({ textContent }) => textContent === wanted);
      tab.focus(); // as a click does: keys go there
      tab.click();
    }, title);
  }
  close() {
    return this.page.close();
  }
}
