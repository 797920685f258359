// roslib, as it comes from the registry (whose archive has no tests): clients' own topics and services, each case of which a rosbridge
// would bear. Arguments: the API's port.
import assert from "node:assert/strict";
import { Ros, Service, Topic } from "roslib";

const url = `ws://127.0.0.1:${process.argv[2]}`;

async function until(condition, what, timeout_ms = 10000) {
  for (const end = Date.now() + timeout_ms; !condition();) {
    assert.ok(Date.now() < end, `not within ${timeout_ms} ms: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
}
const pause = (duration_ms) => new Promise((resolve) => setTimeout(resolve, duration_ms));

async function connect() {
  const ros = new Ros({});
  const statuses = [];
  ros.on("status", (status) => statuses.push(status));
  ros.connect(url);
  await until(() => ros.isConnected, "the connection");
  await new Promise((resolve, reject) => ros.getTopics(resolve, reject));
  return { ros, statuses };
}
const chat = (ros, options = {}) => new Topic({ ros, name: "/example_topic", messageType: "std_msgs/String", ...options });
const call = (ros, name, request = {}, serviceType = "std_srvs/Trigger") =>
  new Promise((resolve, reject) => new Service({ ros, name, serviceType }).callService(request, resolve, reject, 5));

const { ros, statuses } = await connect();
const { ros: other } = await connect();
const cases = {
  async "two topics of one client talk to each other"() {
    const first = chat(ros), second = chat(ros);
    const heard = [[], []];
    first.subscribe((message) => heard[0].push(message.data));
    second.subscribe((message) => heard[1].push(message.data));
    first.publish({ data: "hello" });
    await until(() => heard[1].includes("hello"), "the greeting");
    second.publish({ data: "hi" });
    await until(() => heard.every((texts) => texts.includes("hello") && texts.includes("hi")), "both at both");
    first.unsubscribe();
    second.publish({ data: "still there?" });
    await until(() => heard[1].includes("still there?"), "a subscription that is left");
    second.unsubscribe();
    await pause(200);
    const before = heard[1].length;
    first.publish({ data: "nobody hears" });
    await pause(300);
    assert.equal(heard[1].length, before);
    first.unadvertise();
    second.unadvertise();
  },
  async "clients hear each other in each encoding"() {
    const publisher = chat(ros, { latch: true });
    publisher.advertise();
    publisher.publish({ data: "kept" });
    await pause(200);
    for (const compression of ["none", "cbor"]) {
      const texts = [];
      const listener = chat(other, { compression });
      listener.subscribe((message) => texts.push(message.data));
      await until(() => texts.length > 0, `what is kept, ${compression}`);
      publisher.publish({ data: "kept" });
      await until(() => texts.length > 1, `a message, ${compression}`);
      assert.deepEqual([...new Set(texts)], ["kept"]);
      listener.unsubscribe();
    }
    const { topics, types } = await new Promise((resolve, reject) => other.getTopics(resolve, reject));
    assert.equal(types[topics.indexOf("/example_topic")], "std_msgs/msg/String");
    publisher.unadvertise();
  },
  async "a service with a callback"() {
    const server = new Service({ ros, name: "/test_service", serviceType: "std_srvs/Trigger" });
    await server.advertise((_request, response) => Object.assign(response, { success: true, message: "bar" }) && true);
    assert.deepEqual(await call(other, "/test_service"), { success: true, message: "bar" });
    assert.deepEqual(await call(ros, "/test_service"), { success: true, message: "bar" }, "its own");
    await server.unadvertise();
    await assert.rejects(call(other, "/test_service"));
  },
  async "a service with a promise, of a type that the robot does not know"() {
    const server = new Service({ ros, name: "/add", serviceType: "example_interfaces/AddTwoInts" });
    await server.advertiseAsync(async ({ a, b }) => pause(50).then(() => ({ sum: a + b })));
    const sums = await Promise.all([1, 2, 3].map((a) => call(other, "/add", { a, b: 40 }, "example_interfaces/AddTwoInts")));
    assert.deepEqual(sums.map(({ sum }) => sum), [41, 42, 43]);
    await server.unadvertise();
  },
  async "advertised again and again"() {
    const server = new Service({ ros, name: "/test_readvertise", serviceType: "std_srvs/Trigger" });
    const say = (message) => (_request, response) => Object.assign(response, { success: true, message }) && true;
    await server.advertise(say("first"));
    await server.advertise(say("second"));
    assert.equal((await call(other, "/test_readvertise")).message, "second");
    await Promise.all([server.unadvertise(), server.advertise(say("third")), server.unadvertise(), server.advertise(say("fourth"))]);
    assert.equal((await call(other, "/test_readvertise")).message, "fourth");
    await server.unadvertise();
    await server.unadvertise();
  },
  async "a failure reaches the caller, and so does the provider's end"() {
    const { ros: brief } = await connect();
    const server = new Service({ ros: brief, name: "/brief", serviceType: "std_srvs/Trigger" });
    await server.advertise(() => false);
    await assert.rejects(call(other, "/brief"));
    const silent = new Service({ ros: brief, name: "/silent", serviceType: "std_srvs/Trigger" });
    await silent.advertiseAsync(() => new Promise(() => {}));
    const waiting = assert.rejects(call(other, "/silent"), (why) => /connection has ended/.test(String(why?.message ?? why)));
    await pause(200);
    brief.close();
    await waiting;
  },
  async "the robot's own names stay its own"() {
    statuses.length = 0;
    chat(ros, { name: "/joint_states" }).advertise();
    const server = new Service({ ros, name: "/stop", serviceType: "std_srvs/Trigger" });
    await server.advertise(() => true);
    await pause(300);
    const refused = JSON.stringify(statuses);
    assert.ok(statuses.length === 0 || refused.includes("own"), refused);
    assert.equal((await call(other, "/stop")).success, true, "the robot answers");
  },
};
for (const [name, run] of Object.entries(cases)) {
  await run();
  console.log("fine:", name);
}
process.exit(0);
