// Stops the robot there: beside the stops of the simulated robot, so that it neither scrolls away nor goes with a view. It is there while the
// view of the twin is, and while something is tried or sent.
import type { Context } from "../context.ts";
import { button, byId, element, setText } from "../dom.ts";
import type { TwinOrders } from "./twin_orders.ts";
import { isBusy, type TwinState } from "./twin_state.ts";

export class StopThere {
  private readonly button: HTMLButtonElement;
  private readonly what = element("small");

  constructor(context: Context, orders: TwinOrders) {
    const press = () => void context.attempt("Stop the robot there", () => orders.stop(), "it is told");
    this.button = button("Stop the robot there", () => {}, { id: "twin-stop", class: "stop stop-there", hidden: true });
    this.button.append(this.what);
    // As soon as it is touched; a key, or assistive technology, brings a click alone.
    this.button.addEventListener("pointerdown", (event) => event.button === 0 && press());
    this.button.addEventListener("click", (event) => event.detail === 0 && press());
    byId("stops").prepend(this.button);
  }

  show(state: TwinState, viewed: boolean): void {
    const busy = isBusy(state);
    this.button.hidden = !busy && !viewed;
    setText(this.what, busy ? `${state.sending === "trying" ? "being tried" : "it does"}: ${state.sendingWhat}` : state.link === "connected" && state.commander ? `${state.commander} commands it` : "");
    this.what.hidden = this.what.textContent === "";
  }
}
