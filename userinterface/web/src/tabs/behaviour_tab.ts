// The behaviour: which mission runs, its tree as it is at this moment, and what its nodes did last.
import { BehaviourTree, labelOf, type Status, type Told } from "../behaviour_tree.ts";
import { commandOf, nodesOf, stateOf, type BehaviourState, type CommandState } from "../behaviour_messages.ts";
import type { Context, Tab } from "../context.ts";
import { button, element, setText } from "../dom.ts";
import { Facts } from "../facts.ts";

const old_ms = 3000; // a state comes each second at least
const patience_ms = 5000; // a mission is read, and a tree may take steps to end
const marks: Record<Status, string> = { idle: "·", running: "▶", success: "✓", failure: "✕", skipped: "↷" };
const stateTexts: Record<string, string> = { none: "no mission", runs: "runs", halts: "comes to its end", succeeded: "has succeeded", failed: "has failed", waits: "waits" };

function treeRow(): { row: HTMLElement; show: (depth: number, label: string, status: Status | undefined) => void } {
  const mark = element("span", { class: "mark", "aria-hidden": "true" });
  const label = element("span");
  const word = element("small");
  const row = element("li", {}, mark, " ", label, " ", word);
  return {
    row,
    show: (depth, text, status) => {
      row.className = status ?? "unknown";
      row.style.setProperty("--depth", String(depth));
      row.setAttribute("aria-level", String(depth + 1));
      setText(mark, status ? marks[status] : "?");
      setText(label, text);
      setText(word, status === "idle" || status === undefined ? "" : status);
    },
  };
}

function logRow({ time_s, what, to }: Told): HTMLElement {
  return element("li", { class: to }, element("span", { class: "number" }, time_s.toFixed(2)), " ", element("span", { class: "mark", "aria-hidden": "true" }, marks[to]), ` ${what}: ${to}`);
}

export function behaviourTab({ robot, attempt, command }: Context): Tab {
  const order = (service: string, args = {}) => command.during(() => robot.order(service, args, patience_ms));
  const tree = new BehaviourTree();
  let state: BehaviourState | undefined;
  let authority: CommandState | undefined;
  let came_ms = -Infinity;
  const facts = new Facts();
  const said = element("p", { class: "hint", role: "status" });
  const who = element("p", { class: "hint" });
  const mission = element("input", { id: "mission", placeholder: "name or file of a mission", "aria-label": "Mission", spellcheck: false, autocomplete: "off", enterkeyhint: "go" });
  const start = element("form", { class: "tools" }, mission, element("button", { type: "submit" }, "Start"));
  const end = button("End it", () => void attempt("End the mission", () => order("/behaviour/end")));
  const change = button("Take its file anew", () => void attempt("Change the mission", () => order("/behaviour/change")));
  start.addEventListener("submit", (event) => {
    event.preventDefault();
    const name = mission.value.trim();
    void attempt(name === "" ? "Start the mission" : `Start ${name}`, () => order("/behaviour/start", { mission: name }));
  });
  const rows: ReturnType<typeof treeRow>[] = [];
  const list = element("ol", { class: "tree", tabindex: 0, "aria-label": "The behaviour tree" });
  const log = element("ol", { class: "transitions", tabindex: 0, "aria-label": "Transitions, the newest first" });
  const missed = element("p", { class: "hint" });
  let told = 0;

  const showTree = () => {
    const shown = tree.rows() ?? [];
    while (rows.length > shown.length) rows.pop()?.row.remove();
    shown.forEach(({ node, status }, index) => {
      let row = rows[index];
      if (!row) {
        rows.push((row = treeRow()));
        list.append(row.row);
      }
      row.show(node.depth, labelOf(node), status);
    });
  };
  const showLog = () => {
    if (tree.told === told) return;
    told = tree.told;
    log.replaceChildren(...tree.log.slice(0, 60).map(logRow));
    setText(missed, tree.missed > 0 ? `${tree.missed} came faster than they were told.` : "");
  };
  const look = (now_ms: number) => {
    const isOld = now_ms - came_ms > old_ms;
    list.classList.toggle("old", isOld);
    facts.set("mission", state && state.mission !== "" ? state.mission : "–");
    facts.set("state", !state ? "not known" : isOld ? "not heard of" : (stateTexts[state.state] ?? state.state), isOld || state?.state === "failed");
    facts.set("ticks", state ? String(state.ticks) : "–");
    setText(said, !state ? "This robot tells of no behaviour." : state.text);
    setText(who, !authority || !robot.isOpen ? "" : `Command: ${authority.commander.replace("_", " ")}; ${authority.text}.`);
    end.disabled = change.disabled = !robot.isOpen || !state || state.state === "none";
    showTree();
    showLog();
  };
  robot.subscribe("/command/state", "gaitway_msgs/msg/CommandState", 0, (message) => (authority = commandOf(message)));
  // From the page's start on, so that transitions are told that were while another tab was open.
  robot.subscribe("/behaviour/state", "gaitway_msgs/msg/BehaviourState", 0, (message) => {
    state = stateOf(message);
    came_ms = performance.now();
    tree.takeState(state);
  });
  robot.subscribe("/behaviour/nodes", "gaitway_msgs/msg/BehaviourNodes", 0, (message) => tree.takeNodes(nodesOf(message)));
  const content = element("div", { class: "behaviour-tab" }, facts.list, said, who, start, element("div", { class: "buttons" }, end, change), list,
    element("h2", {}, "Transitions"), missed, log);
  return { title: "Behaviour", content, look };
}
