// Walking to a place, from the click to the arrival: puts the tool, the planner, the card and what is drawn together.
import type { Context } from "../context.ts";
import type { PictureTools } from "../picture_tools.ts";
import type { Scene } from "../scene/scene.ts";
import type { SimulatorPicture } from "../scene/simulator_picture.ts";
import type { SimulationOrders } from "./simulation_orders.ts";
import { WalkTool } from "./walk_tool.ts";
import { WayCard } from "./way_card.ts";
import { WayPlanner } from "./way_planner.ts";
import { readWay, wayTopic } from "./way_state.ts";
import type { FootstepPlan, Goal } from "./footstep_plan.ts";

const walk_ms = 15_000; // it is answered when there is a way

export class WayTool {
  readonly tool: WalkTool;
  readonly card: WayCard;
  private readonly planner: WayPlanner;
  private aimed: Goal | undefined; // while it is dragged
  private drawn: FootstepPlan | undefined;
  private drawnGoal: Goal | undefined;

  // `plays`: the simulator plays, or is made to. `escapeStops`: Escape is a stop, whatever else it breaks off.
  constructor(
    private readonly context: Context,
    private readonly orders: SimulationOrders,
    private readonly picture: SimulatorPicture,
    scene: Scene,
    canvas: HTMLCanvasElement,
    tools: PictureTools,
    private readonly plays: () => boolean,
    private readonly escapeStops: () => boolean,
  ) {
    this.planner = new WayPlanner((goal) => orders.plan(goal));
    this.card = new WayCard(this.planner, { walk: () => this.walk(), cancel: () => this.planner.discard(), leave: () => this.leave() });
    this.tool = new WalkTool(picture, canvas, tools, (on) => scene.turnBySecond(on), {
      aim: (goal) => this.aim(goal),
      choose: (goal) => {
        this.aimed = undefined;
        void this.planner.choose(goal);
      },
      broken: () => this.aim(undefined),
    });
    this.tool.onToggle = (on) => {
      this.card.toolOn = on;
      if (!on) this.planner.discard();
      this.show();
    };
    this.planner.onChange = () => this.show();
    context.robot.subscribe(wayTopic.name, wayTopic.type, 0, (message) => this.planner.take(readWay(message)));
    // A stop goes further, unless nothing is there to be stopped.
    window.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !this.breakOff() || this.escapeStops()) return;
      event.preventDefault();
      event.stopImmediatePropagation();
    }, { capture: true });
  }

  // The goal that is chosen, or was walked to last.
  get goal(): Goal | undefined {
    return this.planner.goal;
  }

  // The robot was put to another instant.
  jumped(): void {
    this.card.forget();
    this.planner.jumped();
  }
  // Another world: what lies on its ground lies elsewhere.
  worldChanged(): void {
    this.drawn = this.drawnGoal = undefined;
    this.show();
  }
  look(now_ms: number): void {
    this.planner.at(this.picture.robotPlace());
    this.card.show(now_ms);
  }

  private breakOff(): boolean {
    const dragged = this.tool.cancel();
    const drafted = this.planner.draft !== undefined;
    this.planner.discard();
    return dragged || drafted;
  }

  private aim(goal: Goal | undefined): void {
    this.aimed = goal;
    this.show();
  }

  private show(): void {
    const shown = this.aimed ? { goal: this.aimed, plan: undefined, passed: 0 } : this.planner.shown;
    if (!shown) this.picture.clearWay();
    else {
      if (shown.goal !== this.drawnGoal) this.picture.showGoal(shown.goal);
      if (shown.plan !== this.drawn) this.picture.showPlan(shown.plan);
      this.picture.fadeSteps(shown.passed);
    }
    this.drawn = shown?.plan;
    this.drawnGoal = shown?.goal;
    this.card.show(performance.now());
  }

  private walk(): void {
    const { attempt, command, robot } = this.context;
    const goal = this.planner.draft?.goal;
    if (!goal) return;
    void attempt("Walk to the goal", async () => {
      if (!this.plays()) await this.orders.play();
      if (!command.mine) await command.take();
      await robot.order("/walk_to", { x: goal.x, y: goal.y, yaw: goal.yaw }, walk_ms);
      if (this.planner.draft?.goal === goal) this.planner.begun();
    }, "begun");
  }

  private leave(): void {
    const { attempt, command, robot } = this.context;
    void attempt("Leave the way", async () => {
      if (!command.mine) await command.take();
      await robot.order("/walk_to/cancel");
    });
  }
}
