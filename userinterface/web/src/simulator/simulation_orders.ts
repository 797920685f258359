// What the page asks of the simulator. None of it needs the command of the robot.
import { Refused, type Message } from "../rosbridge.ts";
import { readGeometry, type GeometryPart } from "./solids.ts";
import { readPlan, type FootstepPlan, type Goal } from "./footstep_plan.ts";

export interface Caller {
  call(service: string, args?: Message, wait_ms?: number): Promise<Message>;
  order(service: string, args?: Message, wait_ms?: number): Promise<Message>;
}
// A scenario event without its time: {push: …}, {fault: …}, {spawn: …}, {move: …} or {remove: …}.
export type ScenarioEvent = Record<string, Message>;

// Of the ROS package simulation_interfaces.
const resultOk = 1, alreadyThere = 101;
const statePlaying = 1, statePaused = 2;

const patience_ms = 5000;
const replay_ms = 15_000; // seek and reset simulate anew what leads there
const plan_ms = 10_000;

export class SimulationOrders {
  constructor(private readonly robot: Caller) {}

  async play(): Promise<void> {
    await this.ask("set_simulation_state", { state: { state: statePlaying } }, patience_ms, alreadyThere);
  }
  async pause(): Promise<void> {
    await this.ask("set_simulation_state", { state: { state: statePaused } }, patience_ms, alreadyThere);
  }
  // A step is a millisecond.
  async step(milliseconds: number): Promise<void> {
    await this.ask("step_simulation", { steps: milliseconds }, replay_ms);
  }
  async reset(): Promise<void> {
    await this.ask("reset_simulation", { scope: 0 }, replay_ms);
  }
  async setSpeed(times: number): Promise<void> {
    await this.robot.order("/simulation/set_speed", { speed: times }, patience_ms);
  }
  async seek(time_s: number): Promise<void> {
    await this.robot.order("/simulation/seek", { time: time_s }, replay_ms);
  }
  async apply(event: ScenarioEvent): Promise<void> {
    await this.robot.order("/simulation/apply", { event: JSON.stringify(event) }, patience_ms);
  }
  // Throws Refused with the planner's reason.
  async plan({ x, y, yaw }: Goal): Promise<FootstepPlan> {
    return readPlan(await this.robot.order("/simulation/plan", { x, y, yaw }, plan_ms));
  }
  async geometry(first: number): Promise<GeometryPart> {
    return readGeometry(await this.robot.order("/simulation/geometry", { first }, patience_ms));
  }

  private async ask(service: string, args: Message, wait_ms: number, alsoGood = resultOk): Promise<void> {
    const { result } = (await this.robot.call(`/simulation/${service}`, args, wait_ms)) as { result?: { result?: number; error_message?: string } };
    if (result?.result === resultOk || result?.result === alsoGood) return;
    throw new Refused(result?.error_message || `/simulation/${service} was refused with result ${result?.result}`);
  }
}
