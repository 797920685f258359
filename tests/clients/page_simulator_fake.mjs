// A simulator's user interface module as the page sees it: its files, the view, and the topics and services of a simulation, answered by a
// clock, a world and a robot that glides along its footsteps. What it was asked is kept, for tests to look at.
import { createRequire } from "node:module";
import { readFile } from "node:fs/promises";
import http from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { viewRows, viewVersion } from "../../userinterface/web/src/view_layout.ts";
import { FakeTwin } from "./page_twin_fake.mjs";

const bundle = path.join(path.dirname(fileURLToPath(import.meta.url)), "../../userinterface/web/bundle");
const { WebSocketServer } = createRequire(path.join(process.env.GAITWAY_PAGE_PACKAGES, "package.json"))("ws");
const kinds = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".json": "application/json" };
const policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"; // as the module has it
const bytesOf = { uint8: 1, int16: 2, uint16: 2, int32: 4, uint32: 4 };
const putOf = { uint8: "setUint8", int16: "setInt16", uint16: "setUint16", int32: "setInt32", uint32: "setUint32" };
const tick_ms = 20, glides_m_per_s = 0.25, solidsInAPart = 200;
const ok = { success: true, message: "" };

const turned = (yaw) => [0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2)];
export function solid(name, kind, shape, size, [x, y, z = size[2] / 2], yaw = 0, colour = [0.72, 0.54, 0.35], movable = false) {
  return { name, kind, shape, size, pose: [x, y, z, ...turned(yaw)], colour, movable };
}
const ros = ({ pose: [x, y, z, a, b, c, d] }) => ({ position: { x, y, z }, orientation: { x: a, y: b, z: c, w: d } });
const vector = ([x, y, z]) => ({ x, y, z });

export class FakeSimulator {
  asked = []; // {service, args}
  odometry = [0.3, -0.2, 0, 0.4]; // pose of the view's frame in the world
  estimate = [0.3, -0.2, 0, 0.4]; // of the frame of the robot's own estimate
  robot = [0, 0, 0]; // x, y, yaw of the middle between the feet, in the world
  refusal = ""; // of the next plan
  tellsTwin = true; // where there is one
  losesAnswerOf = ""; // the next call of this service is carried out, and the connection lost before its answer
  #time_s = 0;
  #recorded_s = 0;
  #playing = true;
  #speed = 1;
  #run = 0;
  #geometry = 1;
  #text = "";
  #events = [];
  #places = new Map(); // instant in ticks: where the robot was
  #way;
  #frame = 0;
  #commander = "";
  #sockets = new Set();

  // `silent`: it tells no state of the simulation. `twin`: it has one of a real robot.
  constructor(description, solids, { silent = false, twin = false } = {}) {
    if (twin) this.twin = new FakeTwin(description);
    this.description = { ...description, bounds: { ...description.bounds, push: { least: 0.1, most: 200, usual: 20, shortest: 0.01, longest: 2 } } };
    this.solids = solids;
    this.server = http.createServer((request, answer) => void this.#serve(request, answer));
    const views = new WebSocketServer({ noServer: true }), talks = new WebSocketServer({ noServer: true });
    this.server.on("upgrade", (request, socket, head) => {
      const view = request.url.startsWith("/view");
      (view ? views : talks).handleUpgrade(request, socket, head, (opened) => (view ? this.#show(opened) : this.#talk(opened)));
    });
    this.timer = setInterval(() => this.#tick(), tick_ms);
    if (!silent) this.teller = setInterval(() => this.#tellState(), 100);
  }

  static async serve(description, solids, more) {
    const fake = new FakeSimulator(description, solids, more);
    await new Promise((resolve) => fake.server.listen(0, "127.0.0.1", resolve));
    return fake;
  }
  get url() {
    return `http://127.0.0.1:${this.server.address().port}/`;
  }
  end() {
    clearInterval(this.timer);
    clearInterval(this.teller);
    for (const { socket } of this.#sockets) socket.terminate();
    this.server.close();
    this.server.closeAllConnections();
  }
  // What was asked of the service, the newest last.
  of(service) {
    return this.asked.filter((call) => call.service === service).map(({ args }) => args);
  }
  get playing() {
    return this.#playing;
  }
  get time_s() {
    return this.#time_s;
  }
  // Nothing is told any more, but what is asked is answered.
  silence() {
    clearInterval(this.teller);
  }
  // Until so much has been simulated, at once.
  run(seconds) {
    for (let i = 0; i < (seconds * 1000) / tick_ms; ++i) this.#advance(tick_ms / 1000);
  }
  // As /walk_to.
  walk(goal) {
    this.#way = { goal };
  }
  mark(kind, text) {
    this.#events.push({ at_s: this.#time_s, kind, text });
  }

  async #serve(request, answer) {
    const name = request.url === "/" ? "index.html" : path.basename(new URL(request.url, this.url).pathname);
    try {
      const body = name === "robot.json" ? JSON.stringify(this.description) : await readFile(path.join(bundle, name));
      answer.writeHead(200, { "Content-Type": kinds[path.extname(name)], "Content-Security-Policy": policy }).end(body);
    } catch {
      answer.writeHead(404).end("there is no such file");
    }
  }

  #tick() {
    if (this.#playing) this.#advance((tick_ms / 1000) * this.#speed);
  }
  #advance(passed_s) {
    if (this.#recorded_s > this.#time_s) this.#events = this.#events.filter(({ at_s }) => at_s <= this.#time_s);
    this.#time_s += passed_s;
    this.#recorded_s = this.#time_s;
    this.#glide(passed_s);
    this.#places.set(Math.round((this.#time_s * 1000) / tick_ms), [...this.robot]);
  }
  #glide(passed_s) {
    if (!this.#way) return;
    const { goal } = this.#way;
    const [dx, dy] = [goal[0] - this.robot[0], goal[1] - this.robot[1]];
    const left_m = Math.hypot(dx, dy), step_m = Math.min(glides_m_per_s * passed_s, left_m);
    if (left_m > 1e-9) this.robot = [this.robot[0] + (dx / left_m) * step_m, this.robot[1] + (dy / left_m) * step_m, left_m < 0.1 ? goal[2] : Math.atan2(dy, dx)];
    const arrived = left_m - step_m < 1e-6;
    if (arrived) this.robot = [...goal];
    this.#tellWay(arrived ? "idle" : "walks", arrived ? "arrived" : "none");
    if (arrived) this.#way = undefined;
  }

  #feet([x, y, yaw] = this.robot) {
    return [1, -1].flatMap((side) => [x - side * 0.055 * Math.sin(yaw), y + side * 0.055 * Math.cos(yaw), yaw]);
  }
  #steps(goal) {
    const [dx, dy] = [goal[0] - this.robot[0], goal[1] - this.robot[1]];
    const count = Math.max(Math.ceil(Math.hypot(dx, dy) / 0.1), 2);
    const ahead = Math.atan2(dy, dx);
    const steps = Array.from({ length: count + 1 }, (_none, index) => {
      const share = Math.min((index + 1) / count, 1), side = index % 2;
      const yaw = index >= count - 1 ? goal[2] : ahead;
      const feet = this.#feet([this.robot[0] + share * dx, this.robot[1] + share * dy, yaw]);
      return { side, pose: feet.slice(3 * side, 3 * side + 3) };
    });
    return { sides: steps.map(({ side }) => side), steps: steps.flatMap(({ pose }) => pose), feet: this.#feet(), duration: steps.length * 0.4 };
  }

  publish(topic, msg) {
    const text = JSON.stringify({ op: "publish", topic, msg });
    for (const { socket, topics } of this.#sockets) if (topics.has(topic)) socket.send(text);
  }
  #tellState() {
    if (this.twin && this.tellsTwin) this.publish("/simulation/twin", this.twin.message(this.robot));
    const things = this.solids.filter(({ movable }) => movable);
    const [x, y, yaw] = this.robot;
    this.publish("/simulation/state", {
      time: this.#time_s, recorded: this.#recorded_s, state: this.#text ? "busy" : this.#playing ? "playing" : "paused", text: this.#text, speed: this.#speed, pace: 0.98 * this.#speed,
      world: "boxes", geometry: this.#geometry, run: this.#run, fallen: false, odometry: this.estimate, base: [x, y, this.description.hip_height, ...turned(yaw)],
      thing_names: things.map(({ name }) => name), thing_poses: things.map(ros), mark_times: this.#events.map(({ at_s }) => at_s), mark_kinds: this.#events.map(({ kind }) => kind),
      event_times: this.#events.map(({ at_s }) => at_s), event_texts: this.#events.map(({ text }) => text),
    });
  }
  #tellWay(state, result) {
    const goal = this.#way?.goal ?? [0, 0, 0];
    const left_m = Math.hypot(goal[0] - this.robot[0], goal[1] - this.robot[1]);
    this.publish("/walk_to/state", { state, result, text: "", steps_left: Math.ceil(left_m / 0.1), replans: 0, distance_left: left_m, goal, pose: this.robot, pose_deviation: [0.01, 0.01, 0.01] });
  }

  #talk(socket) {
    const client = { socket, topics: new Set() };
    this.#sockets.add(client);
    socket.on("close", () => this.#sockets.delete(client));
    socket.on("message", (data) => {
      const message = JSON.parse(data);
      if (message.op === "subscribe") client.topics.add(message.topic);
      if (message.op !== "call_service") return;
      if (!message.service.startsWith("/rosapi/") && message.service !== "/command/keep_alive") this.asked.push({ service: message.service, args: message.args });
      const values = this.#answer(message.service, message.args);
      if (this.losesAnswerOf === message.service) {
        this.losesAnswerOf = "";
        socket.terminate();
        return;
      }
      socket.send(JSON.stringify({ op: "service_response", id: message.id, result: true, values }));
    });
  }

  #answer(service, args) {
    const done = { result: { result: 1, error_message: "" } };
    if (this.twin && service.startsWith("/simulation/twin/")) return this.twin.answer(service, args);
    switch (service) {
      case "/command/acquire":
        this.#commander = args.name;
        return { ...ok, lease: "1", keep_alive_period: 0.5 };
      case "/command/release":
        this.#commander = "";
        return ok;
      case "/walk/limits":
        return { ...ok, forward: 0.4, backward: 0.3, left: 0.15, turn: 1.5 };
      case "/plugins/list":
        return { ...ok, plugins: ["trajectory", "kinematics", "zmp", "stability", "navigation"].map((name) => ({ name, state: "works", steps: 1, faults: 0, overruns: 0, p50_step_us: 1, p99_step_us: 1, worst_step_us: 1 })) };
      case "/simulation/set_simulation_state":
        this.#playing = args.state.state === 1;
        return done;
      case "/simulation/step_simulation":
        if (this.#playing) return { result: { result: 4, error_message: "it plays: pause it first" } };
        this.#advance(args.steps / 1000);
        return done;
      case "/simulation/reset_simulation":
        this.#go(0);
        this.#recorded_s = 0;
        this.#events = [];
        return done;
      case "/simulation/set_speed":
        this.#speed = args.speed;
        return ok;
      case "/simulation/seek":
        this.#playing = false;
        this.#go(args.time);
        return { ...ok, time: args.time };
      case "/simulation/plan":
        return this.refusal ? { success: false, message: this.refusal } : { ...ok, ...this.#steps([args.x, args.y, args.yaw]) };
      case "/simulation/geometry":
        return { ...ok, ...this.#part(args.first) };
      case "/simulation/apply":
        return this.#apply(JSON.parse(args.event));
      case "/walk_to":
        this.walk([args.x, args.y, args.yaw]);
        this.mark("command", `walk_to`);
        return ok;
      case "/walk_to/cancel":
        this.#tellWay("idle", "cancelled");
        this.#way = undefined;
        return ok;
      default:
        return ok;
    }
  }
  #go(time_s) {
    this.#time_s = time_s;
    this.#run += 1;
    this.#way = undefined;
    this.robot = [...(this.#places.get(Math.round((time_s * 1000) / tick_ms)) ?? this.#places.get(1) ?? this.robot)];
  }
  #part(first) {
    const solids = this.solids.slice(first, first + solidsInAPart).map((one) => ({ name: one.name, kind: one.kind, shape: one.shape, size: vector(one.size), pose: ros(one), colour: one.colour, movable: one.movable }));
    return { geometry: this.#geometry, world: "boxes", total: this.solids.length, floor_colour: [0.78, 0.78, 0.78], solids };
  }
  #apply(event) {
    const text = JSON.stringify(event);
    const [kind] = Object.keys(event);
    const { name, shape, size_m, position_m, yaw_deg = 0, colour, mass_kg } = event[kind];
    const found = this.solids.find((one) => one.name === name);
    if (kind === "spawn") this.solids.push(solid(name, "thing", shape, size_m, position_m, (yaw_deg * Math.PI) / 180, colour, mass_kg !== undefined));
    if (kind === "move") {
      if (!found) return { success: false, message: `nothing is called '${name}'` };
      found.pose = [...position_m, ...turned((yaw_deg * Math.PI) / 180)];
    }
    if (kind === "remove") this.solids = this.solids.filter((one) => one !== found);
    if (kind !== "fault" && kind !== "push") this.#geometry += 1;
    this.mark(kind === "fault" || kind === "push" ? kind : "world", text);
    return ok;
  }

  // Where the base is in the frame of odometry.
  #base() {
    const [x, y, , yaw] = this.odometry;
    const [dx, dy] = [this.robot[0] - x, this.robot[1] - y];
    return [Math.cos(yaw) * dx + Math.sin(yaw) * dy, Math.cos(yaw) * dy - Math.sin(yaw) * dx, this.robot[2] - yaw];
  }
  #show(socket) {
    socket.on("message", () => {});
    const timer = setInterval(() => socket.send(this.#viewFrame()), 1000 / 30);
    socket.on("close", () => clearInterval(timer));
  }
  #viewFrame() {
    const { joints, hip_height } = this.description;
    const [x, y, yaw] = this.#base();
    const values = {
      version: [viewVersion], joint_count: [joints.length], frame: [++this.#frame], robot_time: [this.#time_s], mode: [0], activity: [this.#way ? 2 : 1], contact: [1, 1], age: [0.01, 0.01, 0.01, 0.01, this.#playing ? 0.01 : 9],
      round_trip: [0.002], base_place: [x, y], base_height: [hip_height], base_turn: turned(yaw), com: [0.01, 0, 0.4], zmp: [0.01, 0], planned_zmp: [0.012, 0], velocity: [0, 0, 0], commander: [...Buffer.from(this.#commander).subarray(0, 16)], joint: joints.map(({ home }) => home),
    };
    const bytes = viewRows.reduce((sum, row) => sum + bytesOf[row.type] * (row.count || joints.length), 0);
    const frame = new DataView(new ArrayBuffer(bytes));
    let offset = 0;
    for (const { name, type, count, scale } of viewRows) {
      for (let i = 0; i < (count || joints.length); ++i) {
        frame[putOf[type]](offset, Math.round((values[name]?.[i] ?? 0) / (scale || 1)), true);
        offset += bytesOf[type];
      }
    }
    return Buffer.from(frame.buffer);
  }
}

// A room with boxes, a step, a ball and a marker on the floor.
export function room() {
  const wall = (name, size, place) => solid(name, "wall", "box", size, place, 0, [0.88, 0.86, 0.8]);
  const boxes = [[1.1, 0.75, 0.2, 0.5], [0.9, -0.9, 0.3, -0.3], [1.9, 0.2, 0.15, 0.9], [-0.6, 1.2, 0.25, 0.2], [2.1, -1.6, 0.22, 1.1], [-1.4, -1.1, 0.18, 0.6], [0.3, 1.9, 0.25, -0.6], [1.7, 1.8, 0.2, 0.1]];
  return [
    wall("north", [0.1, 6, 0.3], [3, 0]), wall("south", [0.1, 6, 0.3], [-3, 0]), wall("west", [6, 0.1, 0.3], [0, 3]), wall("east", [6, 0.1, 0.3], [0, -3]),
    ...boxes.map(([x, y, height, yaw], index) => solid(`carton_${index + 1}`, "box", "box", [0.3, 0.24, height], [x, y], yaw)),
    solid("step_1", "step", "box", [0.9, 1, 0.02], [2.4, -0.6], 0, [0.6, 0.66, 0.72]),
    solid("pillar", "box", "cylinder", [0.2, 0.2, 0.5], [-1.3, 0.4], 0, [0.55, 0.6, 0.68]),
    solid("ball", "thing", "sphere", [0.15, 0.15, 0.15], [0.75, 0.35], 0, [0.15, 0.5, 0.85], true),
  ];
}
