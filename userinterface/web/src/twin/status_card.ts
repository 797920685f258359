// The robot there at a glance: which it is, whether it is heard, what it does, who commands it, whether the simulated one agrees with it and
// does what it does.
import type { Context } from "../context.ts";
import { button, element, setText } from "../dom.ts";
import { Facts } from "../facts.ts";
import { ageText } from "../freshness.ts";
import type { Agreement } from "./agreement.ts";
import type { TwinOrders } from "./twin_orders.ts";
import { oldAfter_s, type TwinState } from "./twin_state.ts";

const lampOf = { connected: "live", connecting: "old", lost: "lost", refused: "lost" } as const; // as the top line has it

export class StatusCard {
  readonly box: HTMLElement;
  private readonly lamp = element("p", { class: "lamp lost", id: "twin-link", role: "status" });
  private readonly address = element("span", { class: "path" });
  private readonly why = element("p", { class: "twin-why", id: "twin-why", role: "status" });
  private readonly again: HTMLButtonElement;
  private readonly verdict = element("p", { class: "twin-verdict", id: "twin-verdict" });
  private readonly facts = new Facts();
  private readonly followButton: HTMLButtonElement;
  private readonly followsWhy = element("small", { id: "twin-follows-why", role: "status" });
  private follows = false;

  constructor(
    private readonly context: Context,
    private readonly orders: TwinOrders,
  ) {
    this.again = button("Connect again", () => void context.attempt("Connect again", () => orders.reconnect(), "begun"), { id: "twin-again", hidden: true });
    this.followButton = button("", () => this.setFollows(), { role: "switch", id: "twin-follow", class: "switch", "aria-checked": "false", "aria-describedby": "twin-follows-why" });
    this.followButton.append(element("span", { class: "knob-box" }), "The simulated robot does what it does");
    this.box = element("section", { class: "twin-status", "aria-label": "The robot there" },
      element("div", { class: "twin-head" }, this.lamp, this.address, this.again), this.why, this.verdict, this.facts.list,
      element("div", { class: "twin-follows" }, this.followButton, this.followsWhy));
  }

  // `age_s`: of what was measured, by now. `silent`: the simulator itself tells nothing.
  show(state: TwinState, agreement: Agreement, age_s: number, silent: boolean): void {
    const old = state.link === "connected" && !(age_s <= oldAfter_s);
    this.lamp.className = `lamp ${silent ? "lost" : old ? "old" : lampOf[state.link]}`;
    setText(this.lamp, silent ? "not heard of" : old ? "connected, old" : state.link);
    setText(this.address, state.robot);
    this.again.hidden = state.link !== "refused" || silent;
    setText(this.why, silent ? "The simulator tells nothing of it any more." : state.text);
    this.why.hidden = this.why.textContent === "";
    this.verdict.className = `twin-verdict ${agreement.verdict}`;
    setText(this.verdict, agreement.text);
    const known = state.link === "connected" && !silent; // what was is not what is
    this.facts.set("does", known && state.activity ? state.activity : "not known", known && ["falls", "fallen", "gone"].includes(state.activity));
    this.facts.set("commander", !known ? "not known" : state.commander || "nobody");
    this.facts.set("age", Number.isFinite(age_s) ? ageText(1000 * age_s) : "nothing yet", !(age_s <= oldAfter_s));
    this.facts.set("lag", known && Number.isFinite(state.lag_s) ? ageText(1000 * state.lag_s) : "not known");
    this.follows = state.follows;
    this.followButton.setAttribute("aria-checked", String(state.follows));
    this.followButton.disabled = silent;
    setText(this.followsWhy, state.follows || state.followsText === "" ? "" : `It does not: ${state.followsText}.`);
  }

  private setFollows(): void {
    const wanted = !this.follows;
    void this.context.attempt(wanted ? "Do what the robot there does" : "Do not follow the robot there", () => this.orders.follow(wanted));
  }
}
