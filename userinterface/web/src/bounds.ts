// How fast the robot goes: what its gait allows now, and at most what the robot API lets through.
import type { Bounds } from "./drive.ts";
import type { Description } from "./description.ts";
import type { Message, Rosbridge } from "./rosbridge.ts";

export function apiBounds({ bounds }: Description): Bounds {
  return { forward: bounds.forward, backward: bounds.forward, left: bounds.forward, turn: bounds.turn };
}

// Of an answer of /walk/limits. While the gait's are not known it tells the API's own.
export function gaitBounds(answer: Message, most: Bounds): Bounds {
  const within = (name: keyof Bounds) => {
    const told = Number(answer[name]);
    return Number.isFinite(told) ? Math.min(told, most[name]) : most[name];
  };
  return { forward: within("forward"), backward: within("backward"), left: within("left"), turn: within("turn") };
}

export async function readBounds(robot: Rosbridge, description: Description): Promise<Bounds> {
  return gaitBounds(await robot.call("/walk/limits"), apiBounds(description));
}
