// roslib, as it comes from the registry: connects, lists, subscribes to everything in each encoding, drives, reconnects.
// Arguments: the API's port.
import assert from "node:assert/strict";
import { Ros, Service, Topic } from "roslib";

const url = `ws://127.0.0.1:${process.argv[2]}`;
const kSteady = ["/joint_states", "/imu/data", "/foot/left/wrench", "/foot/right/wrench", "/zmp", "/zmp/reference", "/com", "/odom", "/tf",
  "/clock", "/diagnostics"];
const kLatched = ["/robot_description", "/footsteps"];

function within(promise, what, timeout_ms = 30000) {
  let timer;
  const late = new Promise((_resolve, reject) => {
    timer = setTimeout(() => reject(new Error(`not within ${timeout_ms} ms: ${what}`)), timeout_ms);
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

function connect() {
  const ros = new Ros({});
  const connected = new Promise((resolve, reject) => {
    ros.on("connection", () => resolve(ros));
    ros.on("error", reject);
  });
  ros.connect(url);
  return within(connected, "the connection");
}

function call(ros, name, serviceType, request = {}) {
  const service = new Service({ ros, name, serviceType });
  return within(new Promise((resolve, reject) => service.callService(request, resolve, (text) => reject(new Error(text)))), name);
}

// The topic's next `count` messages.
function messages(ros, name, messageType, count, options = {}) {
  const topic = new Topic({ ros, name, messageType, ...options });
  const seen = [];
  return within(new Promise((resolve) => {
    topic.subscribe((message) => {
      seen.push(message);
      if (seen.length === count) {
        topic.unsubscribe();
        resolve(seen);
      }
    });
  }), `${count} messages of ${name}`);
}

const ros = await connect();
const listing = await within(new Promise((resolve, reject) => ros.getTopics(resolve, reject)), "topics");
for (const topic of [...kSteady, ...kLatched, "/events"]) {
  assert.ok(listing.topics.includes(topic), topic);
}
const typeOf = (topic) => listing.types[listing.topics.indexOf(topic)];
const services = await within(new Promise((resolve, reject) => ros.getServices(resolve, reject)), "services");
assert.ok(services.includes("/emergency_stop"));
console.log("listed", listing.topics.length, "topics,", services.length, "services");

for (const compression of ["none", "cbor"]) {
  const options = { compression, queue_length: 10 };
  await Promise.all(kSteady.map((topic) => messages(ros, topic, typeOf(topic), 2, options)));
  await Promise.all(kLatched.map((topic) => messages(ros, topic, typeOf(topic), 1, options)));
  const [joints] = await messages(ros, "/joint_states", typeOf("/joint_states"), 1, options);
  assert.equal(joints.name.length, 22);
  assert.equal(joints.position.length, 22);
  assert.ok(joints.position.every((angle) => Math.abs(angle) < 3.2), "decoded as numbers");
  console.log("subscribed to everything,", compression);
}

const details = await within(new Promise((resolve, reject) => ros.getMessageDetails("sensor_msgs/msg/JointState", resolve, reject)), "details");
assert.ok(ros.decodeTypeDefs(details), "message details are understood");

const stand = await call(ros, "/stand", "std_srvs/Trigger");
assert.equal(stand.success, true);
const plugins = await call(ros, "/plugins/list", "gaitway_msgs/ListPlugins");
assert.ok(plugins.plugins.some((plugin) => plugin.name === "trajectory"));
await assert.rejects(call(ros, "/no/such/service", "std_srvs/Trigger"));

// Drives until it has gone 30 cm, and lets go.
let start, walked = 0;
const odometry = new Topic({ ros, name: "/odom", messageType: "nav_msgs/Odometry", throttle_rate: 20 });
odometry.subscribe((message) => {
  const { x, y } = message.pose.pose.position;
  start ??= { x, y };
  walked = Math.hypot(x - start.x, y - start.y);
});
const velocity = new Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/Twist" });
const driving = setInterval(() => velocity.publish({ linear: { x: 0.15, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } }), 50);
await within(new Promise((resolve) => {
  const look = setInterval(() => walked > 0.3 && (clearInterval(look), resolve()), 20);
}), "30 cm of walk", 60000);
clearInterval(driving);
console.log("walked", walked.toFixed(2), "m");

const closed = new Promise((resolve) => ros.on("close", resolve));
ros.close();
await within(closed, "the end of the connection");
const again = await connect();
await messages(again, "/joint_states", "sensor_msgs/JointState", 3);
again.close();
console.log("connected again");
process.exit(0);
