// The twin of a real robot as the page sees it: the topic /simulation/twin and its services, answered by a robot there that glides, trembles at
// one joint, and lets a pre-flight pass or not. What it was asked is kept by the simulator that it belongs to.
import { deflateSync } from "node:zlib";

const ok = { success: true, message: "" };
const part_bytes = 48_000;
const robots = 20;
const window_s = 2; // of the differences

// A grey picture with noise, so that it takes several parts, and a red square in its middle.
export function makePng(width, height) {
  const table = Array.from({ length: 256 }, (_none, n) => { for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1; return n >>> 0; });
  const crc = (bytes) => (bytes.reduce((sum, byte) => table[(sum ^ byte) & 255] ^ (sum >>> 8), 0xffffffff) ^ 0xffffffff) >>> 0;
  const chunk = (kind, data) => {
    const body = Buffer.concat([Buffer.from(kind), data]);
    const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(crc(body));
    return Buffer.concat([length, body, sum]);
  };
  const rows = Buffer.alloc(height * (1 + 3 * width));
  let noise = 1;
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      noise = (Math.imul(noise, 1103515245) + 12345) & 0x7fffffff;
      const inside = Math.abs(x - width / 2) < width / 8 && Math.abs(y - height / 2) < height / 8;
      rows.set(inside ? [220, 30, 30] : [noise >> 16 & 63, 100 + (noise >> 16 & 63), 120], y * (1 + 3 * width) + 1 + 3 * x);
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 2, 0, 0, 0], 8);
  return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk("IHDR", head), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))]);
}

export class FakeTwin {
  state = "connected";
  text = "";
  hears = true; // measured states come
  knows = true; // where its base and its joints are
  refusal = ""; // of the next that is sent
  follows = true;
  followsText = "";
  offset = [0, 0.45, 0]; // of its place from the simulated robot's, m and rad
  off = { left_knee: 0.01 }; // rad or N, of channels that are not where they are simulated
  falls = 0; // of the next pre-flights' robots
  worstEnds; // what is told of the worst of them, where it did not fall
  sending = { state: "idle", what: "", text: "", passed: 0, tried: 0 };
  told = []; // [s, text], the newest last
  #came_s = 0;
  #picture = 0;
  #png = makePng(480, 360);
  #channels;

  constructor(description) {
    this.description = description;
    const channel = (name, unit, limit, value) => ({ name, unit, limit, value });
    this.#channels = [
      ...description.joints.map(({ name, home }, index) => channel(name, "rad", 0.035, (time_s) => home + 0.15 * Math.sin(2 * time_s + index))),
      channel("roll", "rad", 0.05, (time_s) => 0.02 * Math.sin(3 * time_s)), channel("pitch", "rad", 0.05, (time_s) => 0.03 * Math.cos(3 * time_s)),
      channel("left foot", "N", 15, (time_s) => 34 + 30 * Math.sin(3 * time_s)), channel("right foot", "N", 15, (time_s) => 34 - 30 * Math.sin(3 * time_s)),
      channel("place x", "m", 0.25, () => 0),
      channel("place y", "m", 0.25, () => 0), channel("heading", "rad", 0.349, () => 0)];
  }

  get picture_bytes() {
    return this.#png.length;
  }

  // `robot`: where the simulated one is: x, y, yaw.
  message(robot) {
    const time_s = performance.now() / 1000;
    if (this.hears) this.#came_s = time_s;
    const known = this.#came_s > 0;
    const [x, y, yaw] = robot.map((value, axis) => value + this.offset[axis]);
    const simulated = this.#channels.map(({ value }) => value(this.#came_s));
    const measured = this.#channels.map(({ name, value }) => value(this.#came_s) + (this.off[name] ?? 0) * Math.sin(7 * this.#came_s) * Math.SQRT2);
    const { joints, hip_height } = this.description;
    const compares = known && this.follows;
    return {
      robot: "ws://10.0.0.7:9090", state: this.state, text: this.text, age: known ? time_s - this.#came_s + 0.03 : null, activity: known ? "walks" : "", commander: known ? "page 07ab" : "",
      follows: this.follows, follows_text: this.followsText,
      base: known && this.knows ? [x, y, hip_height, 0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2)] : [], joints: known && this.knows ? measured.slice(0, joints.length) : [], lag: compares ? 0.14 : null,
      channels: this.#channels.map(({ name }) => name), units: this.#channels.map(({ unit }) => unit), measured: known ? measured : measured.map(() => null), simulated,
      difference: this.#channels.map(({ name, limit }) => (compares ? Math.abs(this.off[name] ?? 0.12 * limit) : null)), limits: this.#channels.map(({ limit }) => limit),
      told_times: this.told.map(([at_s]) => at_s), told_texts: this.told.map(([, text]) => text),
      sending: this.sending.state, sending_what: this.sending.what, sending_text: this.sending.text, passed: this.sending.passed, tried: this.sending.tried, picture: this.#picture,
    };
  }

  // The joint differs from now on by so much (RMS), and that is told.
  differ(name, by) {
    this.off[name] = by;
    const unit = this.#channels.find((one) => one.name === name).unit;
    this.told.push([performance.now() / 1000 - window_s, `${name} is ${unit === "rad" ? `${((by * 180) / Math.PI).toFixed(1)} deg` : `${by.toFixed(1)} ${unit}`} from the simulated one`]);
  }

  answer(service, args) {
    switch (service.split("/").at(-1)) {
      case "follow":
        this.follows = args.data;
        this.followsText = "";
        return ok;
      case "reconnect":
        this.state = "connecting";
        return ok;
      case "stop":
        if (this.sending.state === "trying" || this.sending.state === "sending") this.sending = { ...this.sending, state: "stopped", text: "stopped by you" };
        return ok;
      case "send":
        return this.#send(args);
      case "picture":
        return { ...ok, total: this.#png.length, data: this.#png.subarray(args.first, args.first + part_bytes).toString("base64") };
      default:
        return { success: false, message: `there is no service ${service}` };
    }
  }

  // The robots that are tried have ended.
  judge() {
    const passed = robots - this.falls;
    const good = this.falls === 0;
    const end = this.worstEnds ?? "; robot 4 fell after 3.20 s";
    const text = `${passed} of ${robots} simulated robots stayed up and did it${good ? "" : end}`;
    this.#picture += 1;
    this.sending = { ...this.sending, state: good || this.sending.reason ? "sending" : "not passed", text, passed, tried: robots };
  }
  // Nothing has come of it.
  fail(text) {
    this.sending = { ...this.sending, state: "failed", text };
  }
  // The robot there has done it.
  finish() {
    this.sending = { ...this.sending, state: "done" };
  }

  #send({ walk, duration, motion, goal, settings, reason }) {
    if (this.refusal) return { success: false, message: this.refusal };
    if (this.state !== "connected") return { success: false, message: `the robot there is ${this.state}` };
    const what = walk.length ? `walk ${walk[0].toFixed(2)} m/s, ${duration} s` : motion ? `motion ${motion}` : goal.length ? `way to ${goal.map((value) => value.toFixed(2)).join(", ")}` : settings.join(", ");
    this.sending = { state: "trying", what, text: "", passed: 0, tried: 0, reason };
    return ok;
  }
}
