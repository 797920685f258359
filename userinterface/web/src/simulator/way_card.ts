// A card over the picture that says how one makes the robot walk somewhere, how the way is that was planned, and how far it is by now.
import { button, element, setText } from "../dom.ts";
import { planText } from "./footstep_plan.ts";
import { leftText } from "./way_state.ts";
import type { WayPlanner } from "./way_planner.ts";

const arrived_ms = 4000;

export class WayCard {
  readonly box: HTMLElement;
  private readonly text = element("p", { role: "status", id: "way-text" });
  private readonly walk: HTMLButtonElement;
  private readonly cancel: HTMLButtonElement;
  private readonly leave: HTMLButtonElement;
  private arrivedUntil_ms = 0;
  private went = false;
  private readonly more = element("small", {}, "Turn the view: the right button, or two fingers.");
  toolOn = false;

  constructor(
    private readonly planner: WayPlanner,
    orders: { walk: () => void; cancel: () => void; leave: () => void },
  ) {
    this.walk = button("Walk", orders.walk, { class: "primary", id: "way-walk", title: "The robot walks there (Enter)" });
    this.cancel = button("Cancel", orders.cancel, { id: "way-cancel", title: "Forget this goal (Escape)" });
    this.leave = button("Leave the way", orders.leave, { id: "way-leave", title: "The robot stands after its next steps" });
    this.box = element("div", { class: "way-card", id: "way", role: "group", "aria-label": "Walk to a place", hidden: true }, this.text, this.more, this.walk, this.cancel, this.leave);
  }

  // Another instant: what was there is not told.
  forget(): void {
    this.arrivedUntil_ms = 0;
    this.went = false;
  }

  show(now_ms: number): void {
    const { draft, way } = this.planner;
    const goes = way?.goes ?? false;
    if (this.went && !goes && way?.result === "arrived") this.arrivedUntil_ms = now_ms + arrived_ms;
    this.went = goes;
    const arrived = !goes && !draft && now_ms < this.arrivedUntil_ms;
    this.box.className = `way-card${draft?.refusal ? " refused" : draft?.plan ? " ready" : goes ? " goes" : arrived ? " arrived" : ""}`;
    const text = this.words(arrived);
    setText(this.text, text);
    this.box.hidden = text === "";
    const begins = !this.walk.hidden;
    this.more.hidden = draft !== undefined || goes || arrived;
    this.walk.hidden = !draft?.plan;
    this.cancel.hidden = !draft;
    this.leave.hidden = !goes || draft !== undefined;
    if (!begins && !this.walk.hidden && (document.activeElement === document.body || document.activeElement === null)) this.walk.focus({ preventScroll: true }); // Enter walks
  }

  private words(arrived: boolean): string {
    const { draft } = this.planner;
    if (draft?.refusal !== undefined) return draft.refusal;
    if (draft?.plan) return draft.plan.steps.length === 0 ? "The robot stands there already." : planText(draft.plan);
    if (draft) return "Looking for a way…";
    const { left } = this.planner;
    const text = left && leftText(left.steps, left.distance_m);
    if (left) return `On its way${text ? `: ${text} left` : "…"}`;
    if (arrived) return "Arrived.";
    return this.toolOn ? "Click the floor, then press Walk: the robot walks there. Drag to choose where it looks." : "";
  }
}
