// The robot's behaviour tree: its nodes come in parts that take turns, their statuses all at once, transitions in the
// newest few. Passive.

export type Status = "idle" | "running" | "success" | "failure" | "skipped";
export interface TreeNode {
  depth: number; // of the root 0
  type: string; // as in the file: "Sequence", "WalkTo"
  name: string; // given by who wrote it; empty: none
}
export interface NodesPart {
  revision: number;
  node_count: number;
  first: number; // number of the first entry; a node is numbered before its children
  parent: readonly number[];
  type: readonly string[];
  name: readonly string[];
}
export interface Transition {
  time_s: number; // of the robot
  node: number;
  to: Status;
}
export interface TreeState {
  revision: number;
  node_count: number;
  status: readonly Status[]; // may be fewer than nodes
  transitions: number; // since the robot's start
  newest: readonly Transition[]; // the last of them, the newest last
}
// A transition in words, for it outlives the tree in which its node had that number.
export interface Told {
  time_s: number;
  what: string;
  to: Status;
}

const kept = 200;

export const labelOf = ({ type, name }: TreeNode): string => (name === "" ? type : `${type} “${name}”`);

export class BehaviourTree {
  private revision = -1;
  private nodes: (TreeNode | undefined)[] = [];
  private counted = -1; // transitions until now
  private waiting: Transition[] = []; // until all nodes are known
  state: TreeState | undefined;
  log: Told[] = []; // the newest first
  told = 0; // how many of them there were
  missed = 0; // transitions that came faster than they were told

  takePart({ revision, node_count, first, parent, type, name }: NodesPart): void {
    if (revision !== this.revision || node_count !== this.nodes.length) this.begin(revision, node_count);
    parent.forEach((above, index) => {
      const node = first + index;
      const known = above < node ? this.nodes[above] : undefined;
      if (node >= node_count || (node > 0 && !known)) return; // its parent comes in another part, a turn later
      this.nodes[node] = { depth: known ? known.depth + 1 : 0, type: type[index] ?? "", name: name[index] ?? "" };
    });
    this.tellWaiting();
  }

  takeState(state: TreeState): void {
    if (state.revision !== this.revision || state.node_count !== this.nodes.length) this.begin(state.revision, state.node_count);
    if (state.transitions < this.counted) this.counted = -1; // the robot's counters began anew
    const fresh = this.counted < 0 ? state.newest.length : state.transitions - this.counted;
    this.missed += this.counted < 0 ? 0 : Math.max(0, fresh - state.newest.length);
    this.counted = state.transitions;
    this.state = state;
    if (fresh > 0) this.waiting.push(...state.newest.slice(-fresh));
    this.tellWaiting();
  }

  // All nodes of the tree that the state speaks of; undefined: not all of them have come.
  rows(): readonly { node: TreeNode; status: Status | undefined }[] | undefined {
    if (!this.isComplete()) return undefined;
    return this.nodes.map((node, index) => ({ node: node as TreeNode, status: this.state?.status[index] }));
  }

  private isComplete(): boolean {
    return this.nodes.length > 0 && !this.nodes.includes(undefined);
  }

  private begin(revision: number, node_count: number): void {
    this.revision = revision;
    this.nodes = new Array<TreeNode | undefined>(node_count).fill(undefined);
    this.waiting = [];
  }

  private tellWaiting(): void {
    if (!this.isComplete()) return;
    for (const { time_s, node, to } of this.waiting) {
      const known = this.nodes[node];
      if (!known) continue;
      this.log.unshift({ time_s, what: labelOf(known), to });
      ++this.told;
    }
    this.waiting = [];
    this.log.length = Math.min(this.log.length, kept);
  }
}
