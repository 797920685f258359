// The twin's part of the simulator's page: there from the first /simulation/twin on. Puts together the second robot in the picture, the view,
// what is told outside of it, and the stop of the robot there.
import type { Context } from "../context.ts";
import { button, byId, element, setText } from "../dom.ts";
import type { SimulatorPicture } from "../scene/simulator_picture.ts";
import { TwinRobot } from "../scene/twin_robot.ts";
import type { Goal } from "../simulator/footstep_plan.ts";
import type { StopBar } from "../stop_bar.ts";
import type { TabBar } from "../tab_bar.ts";
import { TwinTab, type TwinNow } from "../tabs/twin_tab.ts";
import { agreementOf } from "./agreement.ts";
import type { Walk } from "./last_walk.ts";
import { StopThere } from "./stop_there.ts";
import { tidingsOf } from "./tidings.ts";
import { TwinHistory } from "./twin_history.ts";
import { TwinOrders } from "./twin_orders.ts";
import { isBusy, oldAfter_s, readTwin, silentAfter_ms, twinTopic, type TwinState } from "./twin_state.ts";

export interface TwinPlace {
  picture: SimulatorPicture;
  tabs: TabBar;
  stops: StopBar;
  goal: () => Goal | undefined; // that is chosen on the map
  walk: () => Walk | undefined; // that was driven here last
}

class Twin {
  private readonly robot: TwinRobot;
  private readonly history = new TwinHistory();
  private readonly tab: TwinTab;
  private readonly stop: StopThere;
  private readonly toggle: HTMLButtonElement;
  private readonly chip: HTMLButtonElement;
  private came_ms = 0;

  constructor(
    private readonly context: Context,
    private readonly place: TwinPlace,
    private state: TwinState,
  ) {
    const { picture, tabs } = place;
    const orders = new TwinOrders(context.robot);
    this.robot = new TwinRobot(context.description);
    picture.addTwin(this.robot);
    void this.robot.loadMeshes(context.token(), () => picture.ask()).catch(() => undefined); // boxes will do
    this.tab = new TwinTab(context, orders, this.history, () => this.now(performance.now()), place);
    tabs.add(this.tab);
    this.stop = new StopThere(context, orders);
    place.stops.other = { isToStop: () => isBusy(this.state) || this.tab.isAsking(performance.now()), stop: () => this.stop.too() };
    this.toggle = button("Twin", () => this.setShown(this.toggle.getAttribute("aria-pressed") !== "true"), {
      id: "twin-show", class: "twin-show", "aria-pressed": "true", title: "Show the robot there, as measured" });
    this.chip = button("", () => tabs.open(this.tab), { id: "twin-chip", class: "twin-chip", title: "Open the view of the twin" });
    byId("picture").append(element("div", { class: "twin-glance", role: "group", "aria-label": "The robot there" }, this.toggle, this.chip));
    document.body.classList.add("has-twin");
    document.querySelector(".legend")?.append(element("li", { class: "there" }, "robot there, measured"));
    this.tell({ ...state, link: "connecting" }, state); // what is wrong from the beginning is told, too
  }

  take(state: TwinState, now_ms: number): void {
    if (state !== this.state) this.tell(this.state, state);
    this.state = state;
    this.came_ms = now_ms;
    const { base, joints } = state;
    this.robot.show(base && joints ? { base, joints } : undefined, now_ms);
    const fresh = state.link === "connected" && state.age_s <= oldAfter_s;
    this.history.add(fresh ? state.channels : [], now_ms / 1000);
    this.tab.take(state);
    this.look(now_ms);
    this.place.picture.ask();
  }

  look(now_ms: number): void {
    const { agreement, age_s, silent } = this.now(now_ms);
    this.robot.setFaded(silent || this.state.link !== "connected" || !(age_s <= oldAfter_s));
    this.stop.show(this.state, this.tab.shown);
    setText(this.chip, agreement.short);
    this.chip.dataset["verdict"] = agreement.verdict;
    const tabButton = byId(this.tab.content.getAttribute("aria-labelledby") ?? "");
    tabButton.dataset["verdict"] = agreement.verdict;
  }

  private now(now_ms: number): TwinNow {
    const passed_s = (now_ms - this.came_ms) / 1000;
    const silent = passed_s * 1000 > silentAfter_ms;
    const age_s = this.state.age_s + Math.max(passed_s, 0);
    const agreement = silent ? { verdict: "lost" as const, text: "Nothing is compared: the simulator tells nothing.", short: "Robot there: not heard of" } : agreementOf(this.state, age_s);
    return { state: this.state, agreement, age_s, silent };
  }

  private setShown(shown: boolean): void {
    this.toggle.setAttribute("aria-pressed", String(shown));
    this.robot.setWanted(shown);
    this.place.picture.ask();
  }

  private tell(before: TwinState, after: TwinState): void {
    for (const { text, weight, about } of tidingsOf(before, after)) this.context.news.say(text, weight, about);
  }
}

// Gives what is to be called several times a second.
export function watchForTwin(context: Context, place: TwinPlace): (now_ms: number) => void {
  let twin: Twin | undefined;
  context.robot.subscribe(twinTopic.name, twinTopic.type, 0, (message) => {
    const state = readTwin(message);
    twin ??= new Twin(context, place, state);
    twin.take(state, performance.now());
  });
  return (now_ms) => twin?.look(now_ms);
}
