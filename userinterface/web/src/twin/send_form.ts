// What is to be sent to the robot there: a walk, a motion, the goal of the map, or settings, after it has been tried on simulated robots.
import type { Context } from "../context.ts";
import { button, element, setText } from "../dom.ts";
import { goalText, type Goal } from "../simulator/footstep_plan.ts";
import { spoken } from "./agreement.ts";
import type { Walk } from "./last_walk.ts";
import { exampleSetting, longest_s, readRequest, shortest_s, type SendKind, type SendRequest } from "./send_request.ts";

const kinds: readonly (readonly [SendKind, string])[] = [["walk", "Walk"], ["motion", "Motion"], ["goal", "Goal on the map"], ["settings", "Settings only"]];

function numberField(id: string, name: string, unit: string, value: number, step: number, bounds: { min?: number; max?: number } = {}): { label: HTMLElement; input: HTMLInputElement } {
  const input = element("input", { id: `twin-${id}`, type: "number", step, value, ...bounds, inputmode: "text" });
  return { label: element("label", { for: `twin-${id}` }, name, input, unit), input };
}

export class SendForm {
  readonly box: HTMLFormElement;
  private readonly forward = numberField("forward", "forward", "m/s", 0.1, 0.01);
  private readonly left = numberField("left", "left", "m/s", 0, 0.01);
  private readonly turn = numberField("turn", "turn", "rad/s", 0, 0.01);
  private readonly seconds = numberField("seconds", "for", `s (${shortest_s} to ${longest_s})`, 10, 0.1, { min: shortest_s, max: longest_s });
  private readonly walkFrom = element("p", { class: "note", id: "twin-walk-from" });
  private readonly motion: HTMLSelectElement;
  private readonly goalShown = element("p", { id: "twin-goal" });
  private readonly settings = element("textarea", { id: "twin-settings", rows: 2, spellcheck: false, autocomplete: "off", autocapitalize: "off", placeholder: exampleSetting });
  private readonly submit = element("button", { type: "submit", class: "primary send", id: "twin-send" }, "Try, then send");
  private readonly why = element("p", { class: "note", id: "twin-send-why", role: "status" });
  private readonly parts: Record<SendKind, HTMLElement>;
  private readonly choices = new Map<SendKind, HTMLButtonElement>();
  private kind: SendKind = "walk";
  private filled: Walk | undefined;

  constructor(
    private readonly context: Context,
    private readonly known: { goal: () => Goal | undefined; walk: () => Walk | undefined },
    private readonly send: (request: SendRequest) => void,
  ) {
    const { motions } = context.description;
    this.motion = element("select", { id: "twin-motion" }, element("option", { value: "" }, "choose…"), ...motions.map((name) => element("option", { value: name }, spoken(name))));
    const fields = [this.forward, this.left, this.turn, this.seconds].map(({ label }) => label);
    this.parts = {
      walk: element("div", {}, element("div", { class: "fields" }, ...fields), this.walkFrom),
      motion: element("div", { class: "fields" }, element("label", { for: "twin-motion" }, "motion", this.motion)),
      goal: element("div", {}, this.goalShown),
      settings: element("div", {}),
    };
    const group = element("div", { class: "segments", role: "group", "aria-label": "What is sent" });
    for (const [kind, name] of kinds) {
      const press = button(name, () => this.choose(kind), { "aria-pressed": "false", id: `twin-kind-${kind}` });
      this.choices.set(kind, press);
      group.append(press);
    }
    this.box = element("form", { class: "twin-send", novalidate: true, "aria-labelledby": "twin-send-title" },
      element("h2", { id: "twin-send-title" }, "Send to the robot"), group, ...Object.values(this.parts),
      element("label", { class: "settings", for: "twin-settings" }, "Settings that go first: PLUGIN.PARAMETER=VALUE, one a line", this.settings), this.submit, this.why);
    this.box.addEventListener("submit", (event) => {
      event.preventDefault();
      this.read();
    });
    this.choose("walk");
  }

  // `hindrance`: why nothing can be sent now; "": it can.
  look(hindrance: string): void {
    this.fillWalk();
    const goal = this.known.goal();
    setText(this.goalShown, goal ? `To ${goalText(goal)} of the map.` : "No goal is chosen: press Walk to, and click the floor in the picture.");
    this.submit.disabled = hindrance !== "";
    setText(this.why, hindrance || "Nothing reaches the robot there unless all simulated robots that try it stay up.");
  }

  private choose(kind: SendKind): void {
    this.kind = kind;
    for (const [other, press] of this.choices) press.setAttribute("aria-pressed", String(other === kind));
    for (const [other, part] of Object.entries(this.parts)) part.hidden = other !== kind;
  }

  // The last walk that was driven here, whenever there is a new one.
  private fillWalk(): void {
    const walk = this.known.walk();
    if (!walk || walk === this.filled) return;
    this.filled = walk;
    this.forward.input.value = String(walk.forward);
    this.left.input.value = String(walk.left);
    this.turn.input.value = String(walk.turn);
    this.seconds.input.value = String(Math.min(walk.duration_s, longest_s));
    setText(this.walkFrom, "As it was driven here last.");
  }

  private read(): void {
    const { news, description } = this.context;
    try {
      this.send(readRequest({
        kind: this.kind, forward: this.forward.input.value, left: this.left.input.value, turn: this.turn.input.value, seconds: this.seconds.input.value,
        motion: this.motion.value, goal: this.known.goal(), settings: this.settings.value,
      }, description.bounds));
    } catch (error) {
      news.say((error as Error).message, "bad", "send");
    }
  }
}
