// The robot API's messages of the behaviour and of who commands, as the page works with them.
import type { Status, Transition, TreeNodes, TreeState } from "./behaviour_tree.ts";
import type { Message } from "./rosbridge.ts";

export interface BehaviourState extends TreeState {
  state: string; // "none", "runs", "halts", "succeeded", "failed", "waits"
  mission: string;
  text: string;
  ticks: number;
}

export interface CommandState {
  commander: string; // "nobody", "behaviour", "person", "emergency_stop"
  reason: string; // "person_stops"
  text: string; // the same for people
}

const statuses: readonly Status[] = ["idle", "running", "success", "failure", "skipped"]; // by their numbers
const statusOf = (number: number | undefined): Status => statuses[number ?? 0] ?? "idle";
const list = <Item>(message: Message, key: string) => message[key] as Item[];

export function stateOf(message: Message): BehaviourState {
  const nodes = list<number>(message, "transition_node");
  const to = list<number>(message, "transition_to");
  const status = list<number>(message, "status").map(statusOf);
  const newest = list<number>(message, "transition_time").map((time_s, index): Transition => ({ time_s, node: nodes[index] ?? -1, to: statusOf(to[index]) }));
  return {
    state: String(message["state"]),
    mission: String(message["mission"]),
    text: String(message["text"]),
    ticks: Number(message["ticks"]),
    revision: Number(message["revision"]),
    node_count: status.length, // of a very large tree the first ones are told
    status,
    transitions: Number(message["transitions"]),
    newest,
  };
}

export function nodesOf(message: Message): TreeNodes {
  return {
    revision: Number(message["revision"]),
    parent: list<number>(message, "parent"),
    type: list<string>(message, "type"),
    name: list<string>(message, "name"),
  };
}

export const commandOf = (message: Message): CommandState => ({ commander: String(message["commander"]), reason: String(message["reason"]), text: String(message["text"]) });

// What a person must know of who commands, where a mission is at work or waits; undefined: nothing.
export interface Authority {
  text: string;
  why: string;
  lets_go: boolean; // whether the behaviour would command again, if people let go
}
const ofPerson: Record<string, string> = { person_stops: "a person has stopped the robot", person_is_lost: "the person who commanded is lost", person_moves_joint: "a person moves a joint" };

export function authorityOf(command: CommandState | undefined, behaviour: BehaviourState | undefined): Authority | undefined {
  const mission = behaviour && ["runs", "halts", "waits"].includes(behaviour.state) ? behaviour.mission : "";
  if (!command || (mission === "" && command.commander !== "behaviour")) return undefined;
  const why = command.text;
  switch (command.commander) {
    case "behaviour":
      return { text: `the behaviour commands${mission === "" ? "" : `: ${mission}`}`, why, lets_go: false };
    case "person":
      return { text: `${ofPerson[command.reason] ?? "a person commands"}, ${mission} waits`, why, lets_go: true };
    case "emergency_stop":
      return { text: `emergency stop, ${mission} waits`, why, lets_go: false };
    default:
      return undefined;
  }
}
