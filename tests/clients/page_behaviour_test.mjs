// The behaviour on the page in a real browser, against a robot of the test's own: its tree as it runs, its transitions, who commands, and
// what the page asks for. Argument: the port of a module, whose robot it is. GAITWAY_SCREENSHOTS: a folder for pictures of it.
import assert from "node:assert/strict";
import path from "node:path";
import test, { after, before } from "node:test";
import { openBrowser, RobotPage } from "./page_browser.mjs";
import { FakeSimulator, room } from "./page_simulator_fake.mjs";

const description = await (await fetch(`http://127.0.0.1:${process.argv[2]}/robot.json`)).json();
let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

// parent, type, name
const patrol = [[0, "ReactiveFallback", ""], [0, "Sequence", "after a fall"], [1, "Fallen", ""], [1, "SubTree", "StandUp"], [3, "GetUp", ""],
  [0, "KeepRunningUntilFailure", ""], [5, "Sequence", "round"], [6, "WaitUntil", ""], [6, "WalkTo", ""], [6, "LookTo", ""], [6, "LookAhead", ""]];
const statuses = ["idle", "running", "success", "failure", "skipped"]; // by their numbers

// Tells of a tree with each batch, and of who commands, as the robot does.
class FakeBehaviour {
  nodes = patrol;
  revision = 1;
  mission = "Patrol";
  state = "runs";
  text = "walks to a corner";
  status = patrol.map((_node, index) => ["running", "failure", "failure", "idle", "idle", "running", "running", "success", "running", "idle", "idle"][index]);
  commander = "behaviour";
  reason = "behaviour_orders";
  why = "the behaviour orders";
  #told = []; // time_s, node, to
  #ticks = 0;

  constructor(fake) {
    this.fake = fake;
    this.timer = setInterval(() => this.#tell(), 80);
  }
  end() {
    clearInterval(this.timer);
  }
  turn(node, to) {
    this.status[node] = to;
    this.#told.push([this.fake.time_s, node, to]);
  }
  #tell() {
    const newest = this.#told.slice(-64);
    this.fake.publish("/behaviour/state", {
      state: this.state, mission: this.mission, text: this.text, revision: this.revision, node_count: this.nodes.length, ticks: ++this.#ticks, transitions: this.#told.length,
      transition_time: newest.map(([time_s]) => time_s), transition_node: newest.map(([, node]) => node), transition_to: newest.map(([, , to]) => statuses.indexOf(to)), status: this.status.map((status) => statuses.indexOf(status)),
    });
    const column = (place) => this.nodes.map((node) => node[place]);
    this.fake.publish("/behaviour/nodes", { revision: this.revision, node_count: this.nodes.length, parent: column(0), type: column(1), name: column(2) });
    this.fake.publish("/command/state", { commander: this.commander, reason: this.reason, text: this.why });
  }
}

async function withPage(use, viewport) {
  const fake = await FakeSimulator.serve(description, room(), { silent: true });
  const behaviour = new FakeBehaviour(fake);
  const robot = await RobotPage.open(browser, fake.url, viewport);
  try {
    await robot.live();
    await use(robot, behaviour, fake);
    assert.deepEqual(robot.errors, []);
  } finally {
    behaviour.end();
    await robot.close();
    fake.end();
  }
}

async function picture(robot, name) {
  if (process.env.GAITWAY_SCREENSHOTS) await robot.page.screenshot({ path: path.join(process.env.GAITWAY_SCREENSHOTS, name) });
}

async function until(holds, what, patience_ms = 20_000) {
  for (const end = Date.now() + patience_ms; !holds(); await new Promise((resolve) => setTimeout(resolve, 20))) assert.ok(Date.now() < end, `not within ${patience_ms} ms: ${what}`);
}

const rows = (robot) => robot.page.$$eval(".tree li", (items) => items.map((item) => [item.className, Number(item.getAttribute("aria-level")), item.innerText.replaceAll(/\s+/g, " ").trim()]));

test("the tree is shown as it runs, with the status of each node and the newest transitions", () => withPage(async (robot, behaviour) => {
  await robot.tab("Behaviour");
  await robot.until(() => document.querySelectorAll(".tree li").length === 11, "the whole tree");
  const shown = await rows(robot);
  assert.deepEqual(shown[1].slice(0, 2), ["failure", 2]);
  assert.match(shown[1][2], /Sequence “after a fall” failure/);
  assert.deepEqual(shown[8].slice(0, 2), ["running", 4]);
  assert.match(await robot.page.$eval(".behaviour-tab .facts", (facts) => facts.textContent), /Patrol.*runs/s);
  await robot.until(() => document.querySelector(".behaviour-tab .hint").textContent === "walks to a corner", "what it says");
  behaviour.turn(8, "success");
  behaviour.turn(9, "running");
  await robot.until(() => document.querySelector(".transitions li")?.textContent.includes("LookTo: running"), "the newest transition above");
  assert.deepEqual(await robot.page.$$eval(".transitions li", (items) => items.map((item) => item.className)), ["running", "success"]);
  await robot.until(() => document.querySelectorAll(".tree li")[9].className === "running", "the tree, too");
  await picture(robot, "behaviour.png");
}));

test("a tree that is exchanged is shown anew", () => withPage(async (robot, behaviour) => {
  await robot.tab("Behaviour");
  await robot.until(() => document.querySelectorAll(".tree li").length === 11, "the first tree");
  Object.assign(behaviour, { nodes: [[0, "Say", "hello"]], status: ["success"], revision: 2, mission: "Greet", state: "succeeded", text: "" });
  await robot.until(() => document.querySelectorAll(".tree li").length === 1 && document.querySelector(".tree").textContent.includes("Say “hello”"), "the other tree");
  await robot.until(() => document.querySelector(".behaviour-tab .facts").textContent.includes("has succeeded"), "its state");
}));

test("missions are started, taken anew and ended", () => withPage(async (robot, behaviour, fake) => {
  await robot.tab("Behaviour");
  await robot.page.type("#mission", " follow_tag ");
  await robot.page.keyboard.press("Enter");
  await robot.newsOf("Start follow_tag: done");
  assert.deepEqual(fake.of("/behaviour/start"), [{ mission: "follow_tag" }]);
  await robot.page.evaluate(() => [...document.querySelectorAll(".behaviour-tab button")].find(({ textContent }) => textContent === "Take its file anew").click());
  await robot.newsOf("Change the mission: done");
  await robot.page.evaluate(() => [...document.querySelectorAll(".behaviour-tab button")].find(({ textContent }) => textContent === "End it").click());
  await robot.newsOf("End the mission: done");
  assert.equal(fake.of("/behaviour/change").length, 1);
  assert.equal(fake.of("/behaviour/end").length, 1);
}));

test("who commands is said above, and a person lets go by a button alone", () => withPage(async (robot, behaviour, fake) => {
  await robot.says("authority-text", "the behaviour commands: Patrol");
  assert.equal(await robot.page.$eval("#let-go", (button) => button.hidden), true);
  assert.equal(await robot.page.$eval("#commander", (text) => text.hidden), true, "'nobody commands' is not said beside it");
  Object.assign(behaviour, { commander: "person", reason: "person_stops", why: "it stands until somebody orders something", state: "waits" });
  await robot.says("authority-text", "a person has stopped the robot, Patrol waits");
  await picture(robot, "behaviour_waits.png");
  assert.deepEqual(fake.of("/command/let_go"), []);
  await robot.press("let-go");
  await until(() => fake.of("/command/release").length === 1, "the command is let go, and given back");
  assert.deepEqual(fake.asked.map(({ service }) => service).filter((service) => service.startsWith("/command/")), ["/command/acquire", "/command/let_go", "/command/release"]);
  Object.assign(behaviour, { commander: "emergency_stop", why: "" });
  await robot.says("authority-text", "emergency stop, Patrol waits");
  assert.equal(await robot.page.$eval("#let-go", (button) => button.hidden), true);
  behaviour.end(); // it is not heard of any more: nothing of it is said
  await robot.until(() => document.getElementById("authority").hidden, "no banner");
}));

test("on a phone, banner and tree fit", () => withPage(async (robot, behaviour) => {
  Object.assign(behaviour, { commander: "person", reason: "person_stops", why: "it stands until somebody orders something", state: "waits" });
  await robot.says("authority-text", "a person has stopped the robot");
  await robot.tab("Behaviour");
  await robot.until(() => document.querySelectorAll(".tree li").length === 11, "the tree");
  assert.equal(await robot.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
  assert.equal(await robot.page.evaluate(() => document.getElementById("panels").scrollWidth - document.getElementById("panels").clientWidth), 0);
  await picture(robot, "behaviour_phone.png");
}, { width: 360, height: 740 }));
