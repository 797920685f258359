// The behaviour tree as it comes from the robot: nodes, statuses, transitions.
import assert from "node:assert/strict";
import test from "node:test";
import { BehaviourTree, labelOf, type Status, type Transition } from "../src/behaviour_tree.ts";
import { authorityOf, stateOf } from "../src/behaviour_messages.ts";

const nodes = { revision: 3, parent: [0, 0, 1, 0], type: ["Fallback", "Sequence", "Fallen", "WalkTo"], name: ["", "after a fall", "", ""] };
const state = (transitions: number, newest: Transition[], revision = 3, node_count = 4) => ({ revision, node_count, transitions, newest, status: ["running", "failure", "failure", "running"] as Status[] });
const change = (time_s: number, node: number, to: Status): Transition => ({ time_s, node, to });

test("rows come with the nodes, in the tree's order, with what the state says of them", () => {
  const tree = new BehaviourTree();
  tree.takeState(state(0, []));
  assert.equal(tree.rows(), undefined);
  tree.takeNodes(nodes);
  assert.deepEqual(tree.rows()?.map(({ node, status }) => [node.depth, labelOf(node), status]), [
    [0, "Fallback", "running"], [1, "Sequence “after a fall”", "failure"], [2, "Fallen", "failure"], [1, "WalkTo", "running"]]);
});

test("a node's name is told, and its number where the name was made of it", () => {
  assert.equal(labelOf({ depth: 0, type: "Say", name: "" }), "Say");
  assert.equal(labelOf({ depth: 0, type: "Say", name: "hello" }), "Say “hello”");
  assert.equal(labelOf({ depth: 0, type: "Say", name: "Say#2" }), "Say #2");
});

test("nodes that come before their state have no status yet", () => {
  const tree = new BehaviourTree();
  tree.takeState(state(0, [], 2));
  tree.takeNodes(nodes);
  assert.deepEqual(tree.rows()?.map(({ status }) => status), [undefined, undefined, undefined, undefined]);
});

test("transitions are told once, the newest first, by their nodes' names", () => {
  const tree = new BehaviourTree();
  tree.takeState(state(7, [change(1, 3, "running")]));
  assert.deepEqual(tree.log, []); // nobody knows what node 3 is
  tree.takeNodes(nodes);
  tree.takeState(state(7, [change(1, 3, "running")]));
  tree.takeState(state(9, [change(1, 3, "running"), change(2, 2, "success"), change(2, 3, "idle")]));
  assert.deepEqual(tree.log, [{ time_s: 2, what: "WalkTo", to: "idle" }, { time_s: 2, what: "Fallen", to: "success" }, { time_s: 1, what: "WalkTo", to: "running" }]);
  assert.equal(tree.missed, 0);
  tree.takeState(state(20, [change(3, 3, "running")]));
  assert.equal(tree.missed, 10);
});

test("another tree has other nodes, and what the last one did stays told", () => {
  const tree = new BehaviourTree();
  tree.takeNodes(nodes);
  tree.takeState(state(1, [change(1, 3, "success")]));
  tree.takeState(state(2, [change(1, 3, "success"), change(2, 0, "running")], 4, 1));
  assert.equal(tree.rows(), undefined);
  tree.takeNodes({ revision: 4, parent: [0], type: ["Say"], name: [""] });
  assert.deepEqual(tree.log.map(({ what }) => what), ["Say", "WalkTo"]);
});

test("counters that begin anew tell of a robot that did", () => {
  const tree = new BehaviourTree();
  tree.takeNodes(nodes);
  tree.takeState(state(500, [change(90, 3, "success")]));
  tree.takeState(state(1, [change(0.5, 3, "running")]));
  assert.equal(tree.log[0]?.time_s, 0.5);
  assert.equal(tree.missed, 0);
});

const behaviour = (state: string) => stateOf({ state, mission: "Patrol", text: "", ticks: 1, revision: 1, node_count: 1, status: [1], transitions: 1, transition_time: [1.5], transition_node: [0], transition_to: [1] });

test("who commands is told where a mission is concerned, and a person can let go", () => {
  const command = (commander: string, reason = "", text = "") => ({ commander, reason, text });
  assert.equal(authorityOf(command("person"), undefined), undefined);
  assert.equal(authorityOf(command("person"), behaviour("succeeded")), undefined);
  assert.equal(authorityOf(command("nobody"), behaviour("runs")), undefined);
  assert.equal(authorityOf(undefined, behaviour("runs")), undefined);
  assert.deepEqual(authorityOf(command("behaviour"), behaviour("runs")), { text: "the behaviour commands: Patrol", why: "", lets_go: false });
  assert.deepEqual(authorityOf(command("person", "person_stops", "it stands until somebody orders something"), behaviour("waits")), { text: "a person has stopped the robot, Patrol waits", why: "it stands until somebody orders something", lets_go: true });
  assert.equal(authorityOf(command("person", "person_orders"), behaviour("waits"))?.text, "a person commands, Patrol waits");
  assert.equal(authorityOf(command("emergency_stop"), behaviour("waits"))?.lets_go, false);
});

test("a message's transitions have time, node and status", () => {
  assert.deepEqual(behaviour("runs").newest, [{ time_s: 1.5, node: 0, to: "running" }]);
});
