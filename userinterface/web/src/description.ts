// The robot's description, as the robot gives it.
import type { PushBounds } from "./push.ts";

export type Triple = [number, number, number];
export type Turn = [number, number, number, number]; // x, y, z, w
export interface Placed {
  place: Triple;
  turn: Turn;
}
export interface Shape extends Placed {
  kind: "box" | "cylinder" | "sphere" | "mesh";
  size: Triple;
  rgba: [number, number, number, number];
  mesh?: string;
  scale?: Triple;
  centre?: Triple;
}
export interface Joint extends Placed {
  name: string;
  parent: number;
  child: number;
  axis: Triple;
  lower: number;
  upper: number;
  home: number;
  torque: number;
}
export interface Sole extends Placed {
  link: number;
  size: [number, number];
  centre: [number, number];
}
export interface Description {
  name: string;
  view_version: number;
  hip_height: number;
  links: { name: string; shapes: Shape[] }[];
  joints: Joint[];
  soles: [Sole, Sole];
  motions: string[];
  bounds: { forward: number; turn: number; velocity_holds: number; lease: number; push?: PushBounds }; // push: of a simulated robot
}

export class TokenWanted extends Error {}

export function withToken(token: string | undefined): RequestInit {
  return token === undefined ? {} : { headers: { Authorization: `Bearer ${token}` } };
}

// Throws TokenWanted where `token` does not do.
export async function loadDescription(token: string | undefined): Promise<Description> {
  const answer = await fetch("robot.json", withToken(token));
  if (answer.status === 401) throw new TokenWanted(await answer.text());
  if (!answer.ok) throw new Error(await answer.text());
  return (await answer.json()) as Description;
}
