// The twin: the robot there beside the simulated one, what differs, and what is sent to it.
import type { Context, Tab } from "../context.ts";
import { element } from "../dom.ts";
import type { Goal } from "../simulator/footstep_plan.ts";
import { Refused } from "../rosbridge.ts";
import { worstFirst, type Agreement } from "../twin/agreement.ts";
import { ChannelPlot } from "../twin/channel_plot.ts";
import { DifferenceTable } from "../twin/difference_table.ts";
import type { Walk } from "../twin/last_walk.ts";
import { SendForm } from "../twin/send_form.ts";
import { SendingCard } from "../twin/sending_card.ts";
import { SentHere, withReason, type SendRequest } from "../twin/send_request.ts";
import { StatusCard } from "../twin/status_card.ts";
import { isWarning } from "../twin/tidings.ts";
import type { TwinHistory } from "../twin/twin_history.ts";
import type { TwinOrders } from "../twin/twin_orders.ts";
import { isBusy, type TwinState } from "../twin/twin_state.ts";

export interface TwinNow {
  state: TwinState;
  agreement: Agreement;
  age_s: number; // of what was measured
  silent: boolean; // the simulator tells nothing
}

const again_ms = 2000; // after a picture that did not come

export class TwinTab implements Tab {
  readonly title = "Twin";
  readonly content: HTMLElement;
  shown = false;
  private readonly status: StatusCard;
  private readonly plot = new ChannelPlot();
  private readonly table: DifferenceTable;
  private readonly told = element("ol", { class: "events told", id: "twin-told" });
  private readonly noneTold = element("p", { class: "note" }, "Nothing has been told yet.");
  private readonly form: SendForm;
  private readonly sending: SendingCard;
  private readonly sent = new SentHere();
  private chosen: string | undefined;
  private picture = 0; // that is shown, or being fetched
  private pictureFailed_ms = -Infinity;
  private toldKey = "";
  private wantsToBeSeen = false; // what has just been sent

  constructor(
    private readonly context: Context,
    private readonly orders: TwinOrders,
    private readonly history: TwinHistory,
    private readonly now: () => TwinNow,
    known: { goal: () => Goal | undefined; walk: () => Walk | undefined },
  ) {
    this.status = new StatusCard(context, orders);
    this.table = new DifferenceTable((name) => this.choose(name));
    this.form = new SendForm(context, known, (request) => void this.send(request));
    this.sending = new SendingCard((reason) => this.sendNevertheless(reason));
    this.content = element("div", { class: "twin-tab" }, this.status.box,
      element("h2", {}, "Differences"), this.table.box, this.plot.box,
      this.form.box, this.sending.box,
      element("h2", {}, "What was told"), this.noneTold, this.told);
  }

  show(): void {
    this.shown = true;
    document.body.classList.add("views-twin");
  }
  hide(): void {
    this.shown = false;
    document.body.classList.remove("views-twin");
  }

  // Each state, also while the view is not shown.
  take(state: TwinState): void {
    this.sent.told(state);
  }
  // Something was asked for that may have begun without having been told of yet.
  isAsking(now_ms: number): boolean {
    return this.sent.isAsking(now_ms);
  }

  look(now_ms: number): void {
    const { state, agreement, age_s, silent } = this.now();
    this.status.show(state, agreement, age_s, silent);
    for (const box of [this.table.box, this.plot.box]) box.classList.toggle("was", agreement.verdict === "lost" || agreement.verdict === "unknown");
    this.table.show(state.channels, now_ms);
    this.chosen ??= worstFirst(state.channels)[0]?.name;
    const index = state.channels.findIndex(({ name }) => name === this.chosen);
    const channel = state.channels[index];
    this.plot.box.hidden = !channel;
    if (channel) {
      this.table.setChosen(channel.name);
      this.plot.draw(channel, index, this.history, now_ms);
    }
    this.form.look(this.hindrance(state, silent));
    const mine = this.sent.requestOf(state.sendingWhat) !== undefined;
    this.sending.show(state, mine);
    if (this.wantsToBeSeen && mine && !this.sending.box.hidden) {
      this.wantsToBeSeen = false;
      this.sending.box.scrollIntoView({ block: "start" });
    }
    this.showTold(state);
    this.keepPicture(state, now_ms);
  }

  private choose(name: string): void {
    this.chosen = name;
    this.table.setChosen(name);
    this.plot.makeAnew();
    this.look(performance.now());
    this.plot.box.scrollIntoView({ block: "nearest" });
  }

  private hindrance({ link, sending, text }: TwinState, silent: boolean): string {
    if (silent) return "The simulator tells nothing: nothing can be sent.";
    if (link !== "connected") return `The robot there is not connected: nothing can be sent.${text ? ` ${text}` : ""}`;
    return isBusy({ sending }) ? "Something is being sent already: wait for it, or stop the robot there." : "";
  }

  private async send(request: SendRequest): Promise<void> {
    this.sent.asks(request, this.now().state, performance.now());
    const begun = await this.context.attempt("Send to the robot there", () => this.ask(request), "it is tried on simulated robots first");
    if (!begun) return;
    this.wantsToBeSeen = true;
  }

  // What was not answered may have begun all the same.
  private async ask(request: SendRequest): Promise<void> {
    try {
      await this.orders.send(request);
      this.sent.begun();
    } catch (error) {
      if (error instanceof Refused) this.sent.refused();
      throw error;
    }
  }

  private sendNevertheless(reason: string): void {
    const request = this.sent.requestOf(this.now().state.sendingWhat);
    if (!request) return;
    try {
      void this.send(withReason(request, reason));
    } catch (error) {
      this.context.news.say((error as Error).message, "bad", "send");
    }
  }

  private showTold({ told }: TwinState): void {
    const key = told.map(({ at_s, text }) => `${at_s} ${text}`).join("\n");
    if (key === this.toldKey) return;
    this.toldKey = key;
    this.noneTold.hidden = told.length > 0;
    this.told.replaceChildren(...told.map(({ at_s, text }) => element("li", { class: isWarning(text) ? "warning" : "" }, element("span", { class: "number" }, Number.isFinite(at_s) ? `${at_s.toFixed(1)} s ` : "– "), text)));
  }

  private keepPicture({ picture, sending }: TwinState, now_ms: number): void {
    if (picture === this.picture || now_ms - this.pictureFailed_ms < again_ms || sending === "trying") return;
    this.picture = picture;
    if (picture === 0) {
      this.sending.worst.hide();
      return;
    }
    this.orders.picture().then((png) => this.sending.worst.show(png)).catch((error: Error) => {
      this.picture = 0;
      this.pictureFailed_ms = performance.now();
      this.context.news.say(`The picture of the worst simulated robot does not come: ${error.message}`, "bad", "twin picture");
    });
  }
}
