// The robot's behaviour tree: its nodes come once, their statuses at each change, transitions in the newest few. Passive.

export type Status = "idle" | "running" | "success" | "failure" | "skipped";
export interface TreeNode {
  depth: number; // of the root 0
  type: string; // as in the file: "Sequence", "WalkTo"
  name: string; // given by who wrote it; empty: none
}
export interface TreeNodes {
  revision: number; // which tree it is
  parent: readonly number[]; // of each node, which is numbered before its children; of the root, the root
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
  status: readonly Status[];
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

// A name that was made of the type, to tell it from others beside it ("WalkTo#2"), is its number.
export function labelOf({ type, name }: TreeNode): string {
  if (name === "") return type;
  return name.startsWith(`${type}#`) ? `${type} ${name.slice(type.length)}` : `${type} “${name}”`;
}

export class BehaviourTree {
  private revision = -1;
  private nodes: TreeNode[] | undefined; // undefined: they have not come
  private counted = -1; // transitions until now
  private waiting: Transition[] = []; // until the nodes are known
  state: TreeState | undefined;
  log: Told[] = []; // the newest first
  told = 0; // how many of them there were
  missed = 0; // transitions that came faster than they were told

  takeNodes({ revision, parent, type, name }: TreeNodes): void {
    if (revision !== this.revision) this.begin(revision);
    const depths: number[] = [];
    parent.forEach((above, node) => depths.push(node === 0 ? 0 : (depths[above] ?? 0) + 1));
    this.nodes = depths.map((depth, node) => ({ depth, type: type[node] ?? "", name: name[node] ?? "" }));
    this.tellWaiting();
  }

  takeState(state: TreeState): void {
    if (state.revision !== this.revision) this.begin(state.revision);
    if (state.transitions < this.counted) this.counted = -1; // the robot's counters began anew
    const fresh = this.counted < 0 ? state.newest.length : state.transitions - this.counted;
    this.missed += this.counted < 0 ? 0 : Math.max(0, fresh - state.newest.length);
    this.counted = state.transitions;
    this.state = state;
    if (fresh > 0) this.waiting.push(...state.newest.slice(-fresh));
    this.tellWaiting();
  }

  // The nodes of the tree that the state speaks of; undefined: they have not come.
  rows(): readonly { node: TreeNode; status: Status | undefined }[] | undefined {
    return this.nodes?.map((node, index) => ({ node, status: this.state?.revision === this.revision ? this.state.status[index] : undefined }));
  }

  private begin(revision: number): void {
    this.revision = revision;
    this.nodes = undefined;
    this.waiting = [];
  }

  private tellWaiting(): void {
    if (!this.nodes) return;
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
