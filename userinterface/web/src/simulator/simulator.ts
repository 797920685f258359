// The simulator's part of the page: there from the first /simulation/state on, so a real robot's page has nothing of it.
import type { Context } from "../context.ts";
import { button, byId, element } from "../dom.ts";
import type { Driver } from "../driver.ts";
import type { LinkBanner } from "../link_banner.ts";
import type { PictureTools } from "../picture_tools.ts";
import type { Scene } from "../scene/scene.ts";
import { SimulatorPicture } from "../scene/simulator_picture.ts";
import type { StopBar } from "../stop_bar.ts";
import type { TabBar } from "../tab_bar.ts";
import { faultsTab } from "../tabs/faults_tab.ts";
import { thingsTab } from "../tabs/things_tab.ts";
import { SimulationOrders } from "./simulation_orders.ts";
import { paceOf, readState, silentAfter_ms, stateTopic, type SimulationState } from "./simulation_state.ts";
import { ViewTrail } from "./view_trail.ts";
import { SimulatorBar } from "./simulator_bar.ts";
import { WayTool } from "./way_tool.ts";
import { WorldKeeper } from "./world_keeper.ts";
import { watchForTwin } from "../twin/twin.ts";

const firstZoom = 1.3; // so that there is floor to be clicked

export interface SimulatorPlace {
  scene: Scene;
  canvas: HTMLCanvasElement;
  tools: PictureTools;
  driver: Driver;
  tabs: TabBar;
  stops: StopBar;
  banner: LinkBanner;
}

class Simulator {
  private readonly bar: SimulatorBar;
  private readonly picture: SimulatorPicture;
  private readonly way: WayTool;
  private readonly world: WorldKeeper;
  private readonly worldChanged: () => void;
  private readonly lookAtTwin: (now_ms: number) => void;
  private readonly trail = new ViewTrail();
  private state: SimulationState | undefined;
  private came_ms = 0;

  constructor(
    private readonly context: Context,
    private readonly place: SimulatorPlace,
  ) {
    const { scene, canvas, tools, tabs } = place;
    const orders = new SimulationOrders(context.robot);
    this.picture = new SimulatorPicture(scene, context.description, context.token());
    const plays = () => this.state?.state === "playing";
    this.way = new WayTool(context, orders, this.picture, scene, canvas, tools, plays, () => plays() || place.stops.stopsOther || document.querySelector("dialog[open]") !== null);
    const faults = faultsTab(context, orders);
    const things = thingsTab(context, orders, this.picture, canvas, tools);
    tabs.add(things, faults);
    tools.add(this.way.tool, things.tool);
    this.bar = new SimulatorBar(context, orders, [
      button("Things", () => tabs.open(things), { id: "open-things", title: "Put things into the world, move them" }),
      button("Faults", () => tabs.open(faults), { id: "open-faults", title: "Let something go wrong" })]);
    this.worldChanged = () => {
      this.way.worldChanged();
      things.worldChanged();
    };
    this.world = new WorldKeeper((first) => orders.geometry(first), (solids, floorColour) => {
      this.picture.setSolids(solids, floorColour);
      if (this.state) this.picture.show(this.state, this.trail.originFor(this.state));
      this.worldChanged();
    }, (error) => context.news.say(`The world is not known: ${error.message}`, "bad", "world"));
    context.frameTakers.push((frame) => this.trail.take(frame));
    document.body.classList.add("simulated");
    byId("panel").before(this.bar.box);
    byId("camera").prepend(this.way.tool.toggle);
    byId("picture").append(this.way.card.box);
    document.querySelector(".legend")?.append(element("li", { class: "left-step" }, "left step"), element("li", { class: "right-step" }, "right step"));
    scene.zoom(firstZoom);
    this.lookAtTwin = watchForTwin(context, { picture: this.picture, tabs, stops: place.stops, goal: () => this.way.goal, walk: () => place.driver.lastWalk.walk });
    this.way.tool.setOn(true); // the first that somebody wants to do
  }

  take(state: SimulationState, now_ms: number): void {
    const jumped = this.state !== undefined && this.state.run !== state.run;
    if (jumped || now_ms - this.came_ms > silentAfter_ms || this.state?.world !== state.world) this.world.forget(); // another instant may count to the same number
    this.state = state;
    this.came_ms = now_ms;
    this.context.freshness.pace = paceOf(state);
    if (jumped) this.jumped();
    this.picture.show(state, this.trail.originFor(state));
    this.bar.show(state);
    void this.world.take(state.geometry, now_ms);
  }

  // The robot was put to another instant: what was before is not what is.
  private jumped(): void {
    this.context.command.lost();
    this.trail.forget();
    this.place.scene.forgetSteps();
    this.way.jumped();
  }

  look(now_ms: number): void {
    const silent = now_ms - this.came_ms > silentAfter_ms;
    const { stops, banner } = this.place;
    if (silent) this.context.freshness.pace = 1; // then nothing is known of its time
    stops.setSpaceStops(silent);
    banner.rests = !silent && this.state?.state !== "playing";
    this.bar.setSilent(silent);
    this.way.look(now_ms);
    this.lookAtTwin(now_ms);
  }
}

// Gives what is to be called several times a second.
export function watchForSimulator(context: Context, place: SimulatorPlace): (now_ms: number) => void {
  let simulator: Simulator | undefined;
  context.robot.subscribe(stateTopic.name, stateTopic.type, 0, (message) => {
    simulator ??= new Simulator(context, place);
    simulator.take(readState(message), performance.now());
  });
  return (now_ms) => simulator?.look(now_ms);
}
