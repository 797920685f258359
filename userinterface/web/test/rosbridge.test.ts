// Orders are answered, refused, or reported as unanswered, and none is sent twice.
import assert from "node:assert/strict";
import test, { beforeEach, mock } from "node:test";
import { Command } from "../src/command.ts";
import { Refused, Rosbridge, Unanswered, type Message } from "../src/rosbridge.ts";

class FakeSocket {
  static readonly OPEN = 1;
  static made: FakeSocket[] = [];
  readyState = 0;
  sent: Message[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: string }) => void) | null = null;
  onclose: ((event: { reason: string }) => void) | null = null;

  constructor() {
    FakeSocket.made.push(this);
  }
  send(text: string): void {
    this.sent.push(JSON.parse(text) as Message);
  }
  close(): void {
    this.readyState = 3;
  }
  open(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen?.();
  }
  answer(result: boolean, values: unknown): void {
    const call = this.sent.at(-1);
    this.onmessage?.({ data: JSON.stringify({ op: "service_response", id: call?.["id"], result, values }) });
  }
  lose(): void {
    this.readyState = 3;
    this.onclose?.({ reason: "" });
  }
}

const newest = () => FakeSocket.made.at(-1) as FakeSocket;

function connected(token?: string): Rosbridge {
  const robot = new Rosbridge("ws://robot", () => token);
  robot.start();
  newest().open();
  return robot;
}

mock.timers.enable({ apis: ["setTimeout", "setInterval"] });
(globalThis as { WebSocket: unknown }).WebSocket = FakeSocket;
beforeEach(() => (FakeSocket.made = []));

test("an answer belongs to its call; a refusal says why", async () => {
  const robot = connected();
  const done = robot.order("/stand");
  newest().answer(true, { success: true, message: "stands" });
  assert.equal((await done).message, "stands");
  const denied = robot.order("/stand");
  newest().answer(true, { success: false, message: "another commands" });
  await assert.rejects(denied, new Refused("another commands"));
  const wrong = robot.order("/nothing");
  newest().answer(false, "no such service");
  await assert.rejects(wrong, new Refused("no such service"));
});

test("without a connection an order is refused, and not sent later", async () => {
  const robot = new Rosbridge("ws://robot", () => undefined);
  robot.start();
  await assert.rejects(robot.order("/stop"), Refused);
  newest().open();
  assert.deepEqual(newest().sent, []);
});

test("an order whose answer the connection took along is unanswered, and not sent again", async () => {
  const robot = connected();
  let ended = 0;
  robot.onClose = () => (ended += 1);
  const order = robot.order("/play_motion", { motion: "wave" });
  newest().lose();
  await assert.rejects(order, Unanswered);
  assert.equal(ended, 1);
  mock.timers.tick(250);
  assert.equal(FakeSocket.made.length, 2, "looked for another connection");
  newest().open();
  assert.deepEqual(newest().sent, []);
});

test("an order that nobody answers is unanswered after its time", async () => {
  const robot = connected();
  const order = robot.order("/stand", {}, 900);
  mock.timers.tick(901);
  await assert.rejects(order, Unanswered);
});

test("subscriptions are taken up again, after the token", () => {
  const robot = connected("secret");
  robot.subscribe("/events", "rcl_interfaces/msg/Log", 0, () => {});
  newest().lose();
  mock.timers.tick(250);
  newest().open();
  assert.deepEqual(newest().sent.map((message) => message["op"]), ["auth", "subscribe"]);
});

test("a connection attempt without an answer is given up for another one", () => {
  new Rosbridge("ws://robot", () => undefined).start();
  mock.timers.tick(700);
  mock.timers.tick(200);
  assert.equal(FakeSocket.made.length, 2);
});

test("the command is asked for once, kept alive, and lost when keeping it is refused", async () => {
  const calls: string[] = [];
  let refuse = false;
  const robot = {
    order: async (service: string) => {
      calls.push(service);
      if (refuse) throw new Refused("you do not have it");
      return { success: true, message: "", lease: "abc", keep_alive_period: 0.5 };
    },
  };
  const command = new Command(robot, "page 1");
  await Promise.all([command.take(), command.take()]);
  assert.equal(command.mine, true);
  await command.keep(performance.now() + 300);
  await command.keep(performance.now() + 310);
  assert.deepEqual(calls, ["/command/acquire", "/command/keep_alive"]);
  refuse = true;
  await assert.rejects(command.keep(performance.now() + 900));
  assert.equal(command.mine, false);
});

test("a stop is said until it is answered, and is one call", async () => {
  const robot = connected();
  const stopped = robot.stop("/stop");
  mock.timers.tick(100);
  const said = newest().sent.length;
  assert.ok(said >= 5, "every 20 ms");
  assert.equal(new Set(newest().sent.map((message) => message["id"])).size, 1);
  newest().answer(true, { success: true, message: "stops" });
  assert.equal((await stopped).message, "stops");
  mock.timers.tick(1000);
  assert.deepEqual(newest().sent.slice(said).filter((message) => message["service"] === "/stop"), []);
});

test("a stop is said no more when its connection is lost", async () => {
  const robot = connected();
  const stopped = robot.stop("/emergency_stop", { data: false });
  newest().lose();
  await assert.rejects(stopped, Unanswered);
  mock.timers.tick(1000);
  newest().open();
  mock.timers.tick(100);
  assert.deepEqual(newest().sent.filter((message) => message["service"] === "/emergency_stop"), []);
});
