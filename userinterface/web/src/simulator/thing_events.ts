// Things that are put into the simulated world, moved about in it and taken out of it: the scenario events for that. Passive.
import type { Triple } from "../description.ts";
import type { ScenarioEvent } from "./simulation_orders.ts";
import type { Solid, SolidShape } from "./solids.ts";

export interface NewThing {
  shape: SolidShape;
  size: Triple; // m, whole
  mass_kg: number | undefined; // undefined: it stands fast
  colour: string; // #rrggbb
}

const millimetres = (value: number) => Math.round(value * 1000) / 1000 + 0; // no −0

// Which measures a shape has; a cylinder's width is its diameter.
export function sizeOf(shape: SolidShape, [x, y, z]: Triple): Triple {
  if (shape === "sphere") return [x, x, x];
  return shape === "cylinder" ? [x, x, z] : [x, y, z];
}

export function rgbOf(colour: string): Triple {
  const value = /^#[0-9a-f]{6}$/i.test(colour) ? parseInt(colour.slice(1), 16) : 0x808080;
  return [value >> 16, (value >> 8) & 255, value & 255].map((part) => Math.round((part / 255) * 1000) / 1000) as Triple;
}

// One that the world does not have yet: box, box_2, box_3.
export function freeName(shape: SolidShape, taken: ReadonlySet<string>): string {
  for (let number = 1; ; ++number) {
    const name = number === 1 ? shape : `${shape}_${number}`;
    if (!taken.has(name)) return name;
  }
}

// It stands on the ground of this height. `position_m` is of its middle.
export function spawnEvent(thing: NewThing, name: string, place: Triple, yaw_deg = 0): ScenarioEvent {
  const size = sizeOf(thing.shape, thing.size);
  const mass = thing.mass_kg === undefined ? {} : { mass_kg: thing.mass_kg };
  return { spawn: { name, shape: thing.shape, size_m: size, position_m: [millimetres(place[0]), millimetres(place[1]), millimetres(place[2] + size[2] / 2)], yaw_deg, ...mass, colour: rgbOf(thing.colour) } };
}

export function moveEvent(name: string, place: Triple, yaw_rad: number): ScenarioEvent {
  return { move: { name, position_m: place.map(millimetres), yaw_deg: Math.round((yaw_rad * 1800) / Math.PI) / 10 + 0 } };
}

export function removeEvent(name: string): ScenarioEvent {
  return { remove: { name } };
}

// What a hand may take: the simulator decides, this page only offers.
export function mayBeTaken({ kind, movable }: Solid): boolean {
  return movable || kind === "thing" || kind === "box";
}

const least_m = 0.01, most_m = 5, lightest_kg = 0.001, heaviest_kg = 1000;
// Throws with the field and its bounds.
export function checkThing({ size, mass_kg }: NewThing): void {
  for (const [axis, value] of size.entries()) {
    if (!(value >= least_m && value <= most_m)) throw new Error(`${["length", "width", "height"][axis]} is ${value} m, and must be ${least_m} … ${most_m} m`);
  }
  if (mass_kg !== undefined && !(mass_kg >= lightest_kg && mass_kg <= heaviest_kg)) throw new Error(`mass is ${mass_kg} kg, and must be ${lightest_kg} … ${heaviest_kg} kg`);
}
