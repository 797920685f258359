// What stands in the simulator's world: how its answer reads, what a ray through the picture meets first, how high one stands. Passive.
import type { Placed, Triple, Turn } from "../description.ts";
import type { Message } from "../rosbridge.ts";
import { poseOf } from "./simulation_state.ts";

export type SolidShape = "box" | "cylinder" | "sphere";
export interface Solid extends Placed {
  name: string;
  kind: string; // box step slope tile wall thing
  shape: SolidShape;
  size: Triple; // whole, m; a cylinder's axis is z
  colour: Triple; // red, green, blue, each 0..1
  movable: boolean;
}
export interface GeometryPart {
  geometry: number;
  world: string;
  total: number;
  floorColour: Triple;
  solids: Solid[];
}
export interface Ray {
  origin: Triple;
  direction: Triple; // of length 1
}
export interface Hit {
  distance_m: number;
  place: Triple;
  solid: Solid | undefined; // undefined: the floor
}

const triple = (values: readonly unknown[]): Triple => [Number(values[0]), Number(values[1]), Number(values[2])];

export function readGeometry(answer: Message): GeometryPart {
  const solids = (answer["solids"] as Message[]).map((solid): Solid => {
    const size = solid["size"] as { x: number; y: number; z: number };
    const shape = String(solid["shape"]);
    if (shape !== "box" && shape !== "cylinder" && shape !== "sphere") throw new Error(`solid '${String(solid["name"])}' has the shape '${shape}': box, cylinder or sphere is known`);
    return {
      ...poseOf(solid["pose"]), name: String(solid["name"]), kind: String(solid["kind"]), shape, size: [size.x, size.y, size.z],
      colour: triple(solid["colour"] as unknown[]), movable: solid["movable"] === true,
    };
  });
  return { geometry: Number(answer["geometry"]), world: String(answer["world"]), total: Number(answer["total"]), floorColour: triple(answer["floor_colour"] as unknown[]), solids };
}

// What soles are meant to stand on.
export function isGround({ kind }: Pick<Solid, "kind">): boolean {
  return kind === "step" || kind === "slope" || kind === "tile";
}

// The vector in the frame that is turned so.
function turnedBack([x, y, z, w]: Readonly<Turn>, [a, b, c]: Triple): Triple {
  const [tx, ty, tz] = [2 * (z * b - y * c), 2 * (x * c - z * a), 2 * (y * a - x * b)]; // of the inverse turn
  return [a + w * tx - (y * tz - z * ty), b + w * ty - (z * tx - x * tz), c + w * tz - (x * ty - y * tx)];
}

function enterBox([x, y, z]: Triple, direction: Triple, size: Triple): number | undefined {
  let [enter, leave] = [-Infinity, Infinity];
  for (const [axis, from] of [x, y, z].entries()) {
    const half = size[axis]! / 2;
    const along = direction[axis]!;
    if (Math.abs(along) < 1e-12) {
      if (Math.abs(from) > half) return undefined;
      continue;
    }
    const [a, b] = [(-half - from) / along, (half - from) / along];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter <= leave && leave >= 0 ? Math.max(enter, 0) : undefined;
}

// Both ends of what a line takes of a ball, or of an endless round pillar.
function roundSpan(from: readonly number[], along: readonly number[], radius: number): [number, number] | undefined {
  const a = along.reduce((sum, value) => sum + value * value, 0);
  const b = along.reduce((sum, value, axis) => sum + value * from[axis]!, 0);
  const c = from.reduce((sum, value) => sum + value * value, -radius * radius);
  if (a < 1e-12) return c <= 0 ? [-Infinity, Infinity] : undefined;
  const root = b * b - a * c;
  return root < 0 ? undefined : [(-b - Math.sqrt(root)) / a, (-b + Math.sqrt(root)) / a];
}

// From where on the ray is in the solid; undefined: it passes by.
export function distanceTo(solid: Solid, { origin, direction }: Ray, pose: Placed = solid): number | undefined {
  const { place } = pose;
  const from = turnedBack(pose.turn, [origin[0] - place[0], origin[1] - place[1], origin[2] - place[2]]);
  const along = turnedBack(pose.turn, direction);
  if (solid.shape === "box") return enterBox(from, along, solid.size);
  const span = solid.shape === "sphere" ? roundSpan(from, along, solid.size[0] / 2) : roundSpan(from.slice(0, 2), along.slice(0, 2), solid.size[0] / 2);
  if (!span) return undefined;
  let [enter, leave] = span;
  if (solid.shape === "cylinder") {
    const slab = enterBox([0, 0, from[2]], [0, 0, along[2]], [1, 1, solid.size[2]]);
    if (slab === undefined) return undefined;
    if (Math.abs(along[2]) > 1e-12) {
      const half = solid.size[2] / 2;
      const ends = [(-half - from[2]) / along[2], (half - from[2]) / along[2]];
      enter = Math.max(enter, Math.min(...ends));
      leave = Math.min(leave, Math.max(...ends));
    }
  }
  return enter <= leave && leave >= 0 ? Math.max(enter, 0) : undefined;
}

const placeOn = ({ origin, direction }: Ray, distance_m: number): Triple => [
  origin[0] + distance_m * direction[0], origin[1] + distance_m * direction[1], origin[2] + distance_m * direction[2]];

// What is seen along the ray: of the solids, each where `poseOfSolid` has it, and of the floor, z = 0.
export function firstHit(ray: Ray, solids: Iterable<Solid>, poseOfSolid: (solid: Solid) => Placed = (solid) => solid): Hit | undefined {
  let nearest: Hit | undefined;
  const consider = (distance_m: number | undefined, solid: Solid | undefined) => {
    if (distance_m === undefined || distance_m >= (nearest?.distance_m ?? Infinity)) return;
    nearest = { distance_m, place: placeOn(ray, distance_m), solid };
  };
  if (ray.direction[2] < -1e-6 && ray.origin[2] > 0) consider(-ray.origin[2] / ray.direction[2], undefined);
  for (const solid of solids) consider(distanceTo(solid, ray, poseOfSolid(solid)), solid);
  return nearest;
}

const above_m = 50;
// Of what soles are meant to stand on at this place: the floor has 0.
export function groundHeight(solids: Iterable<Solid>, x: number, y: number): number {
  let height_m = 0;
  for (const solid of solids) {
    if (!isGround(solid)) continue;
    const down_m = distanceTo(solid, { origin: [x, y, above_m], direction: [0, 0, -1] });
    if (down_m !== undefined) height_m = Math.max(height_m, above_m - down_m);
  }
  return height_m;
}
