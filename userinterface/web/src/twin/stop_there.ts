// Stops the robot there: beside the stops of the simulated robot, so that it neither scrolls away nor goes with a view. It is there while the
// view of the twin is, and while something is tried or sent.
import type { Context } from "../context.ts";
import { button, byId, element, setText } from "../dom.ts";
import type { TwinOrders } from "./twin_orders.ts";
import { isBusy, type TwinState } from "./twin_state.ts";

export class StopThere {
  private readonly button: HTMLButtonElement;
  private readonly what = element("small");
  private isHeard = false;

  constructor(
    private readonly context: Context,
    private readonly orders: TwinOrders,
  ) {
    this.button = button("Stop the robot there", () => {}, { id: "twin-stop", class: "stop stop-there", hidden: true });
    this.button.append(this.what);
    // As soon as it is touched; a key, or assistive technology, brings a click alone.
    this.button.addEventListener("pointerdown", (event) => event.button === 0 && this.stop("Stop the robot there"));
    this.button.addEventListener("click", (event) => event.detail === 0 && this.stop("Stop the robot there"));
    byId("stops").prepend(this.button);
  }

  // With a stop of the simulated robot.
  too(): void {
    this.stop("Stop the robot there, too");
  }

  // It can be pressed whatever is known of the robot there.
  show(state: TwinState, viewed: boolean): void {
    const busy = isBusy(state);
    this.isHeard = state.link === "connected";
    this.button.hidden = !busy && !viewed;
    const unheard = state.link === "lost" ? "it is not heard of" : "";
    const doing = busy ? `${state.sending === "trying" ? "being tried" : "it does"}: ${state.sendingWhat}` : this.isHeard && state.commander ? `${state.commander} commands it` : "";
    setText(this.what, [unheard, doing].filter((text) => text !== "").join("; "));
    this.what.hidden = this.what.textContent === "";
  }

  private stop(what: string): void {
    void this.context.attempt(what, () => this.orders.stop(), this.isHeard ? "it is told" : "it is tried, but the robot there is not heard of: see What was told");
  }
}
