// How fast the robot goes: what its gait allows now, and at most what the robot API lets through.
import type { Bounds } from "./drive.ts";
import type { Description } from "./description.ts";
import type { Message, Rosbridge } from "./rosbridge.ts";

// The robot asks the plug-in for one after the other.
export const parametersWait_ms = 10_000;

export function apiBounds({ bounds }: Description): Bounds {
  return { forward: bounds.forward, backward: bounds.forward, left: bounds.forward, turn: bounds.turn };
}

// Of the parameters of the plug-in `trajectory`, as /plugins/get_parameters tells them.
export function gaitBounds(parameters: Message, most: Bounds): Bounds {
  const names = parameters["names"] as string[];
  const values = parameters["values"] as string[];
  const valueOf = (name: string) => Number.parseFloat(values[names.indexOf(name)] ?? "");
  const stepTime_s = valueOf("step_time");
  const within = (speed: number, limit: number) => (Number.isFinite(speed) ? Math.min(speed, limit) : limit);
  return {
    forward: within(valueOf("max_step_forward") / stepTime_s, most.forward),
    backward: within(valueOf("max_step_backward") / stepTime_s, most.backward),
    left: within((valueOf("max_foot_spacing") - valueOf("foot_spacing")) / (2 * stepTime_s), most.left),
    turn: within(valueOf("max_step_turn") / stepTime_s, most.turn),
  };
}

// A robot without that plug-in has the API's alone.
export async function readBounds(robot: Rosbridge, description: Description): Promise<Bounds> {
  const most = apiBounds(description);
  const parameters = await robot.call("/plugins/get_parameters", { plugin: "trajectory" }, parametersWait_ms);
  return parameters["success"] === true ? gaitBounds(parameters, most) : most;
}
