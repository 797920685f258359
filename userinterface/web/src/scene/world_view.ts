// The simulator's world in the picture: its floor, what stands on it, the things that are moved about. Solids of one shape are drawn at
// once, however many there are.
import * as THREE from "three";
import type { Placed } from "../description.ts";
import type { Odometry } from "../simulator/simulation_state.ts";
import type { Solid, SolidShape } from "../simulator/solids.ts";
import { inverseOf } from "../simulator/world_frame.ts";

const shapes: Record<SolidShape, () => THREE.BufferGeometry> = { // of the size 1
  box: () => new THREE.BoxGeometry(1, 1, 1),
  cylinder: () => new THREE.CylinderGeometry(0.5, 0.5, 1, 20).rotateX(Math.PI / 2),
  sphere: () => new THREE.SphereGeometry(0.5, 20, 14),
};
const follows_s = 0.08; // so quickly a thing is drawn where it is told to be, ten times a second
const floorHalf_m = 40;

interface Drawn {
  mesh: THREE.InstancedMesh;
  index: number;
  solid: Solid;
  now: Placed; // where it is drawn
  wanted: Placed;
}

export class WorldView {
  // In the world's frame: put whatever has its place in the world into it.
  readonly group = new THREE.Group();
  private readonly floorMaterial = new THREE.MeshBasicMaterial({ depthWrite: false });
  private readonly floor = new THREE.Mesh(new THREE.PlaneGeometry(2 * floorHalf_m, 2 * floorHalf_m), this.floorMaterial);
  private readonly solidMaterial = new THREE.MeshLambertMaterial();
  private grid: THREE.LineSegments | undefined;
  private meshes: THREE.InstancedMesh[] = [];
  private readonly drawn = new Map<string, Drawn>();
  private readonly moving = new Set<Drawn>();
  private readonly held = new Set<string>(); // what a hand has: nothing else moves it
  private floorColour = new THREE.Color(0.75, 0.75, 0.75);
  private dark = false;
  private readonly matrix = new THREE.Matrix4();
  private readonly turn = new THREE.Quaternion();

  constructor() {
    this.floor.renderOrder = -2; // under all: nothing of the robot is hidden by it, however odometry drifts in height
    this.group.add(this.floor);
    this.group.visible = false;
  }

  get solids(): Solid[] {
    return [...this.drawn.values()].map(({ solid }) => solid);
  }
  // Where it is drawn.
  poseOf(name: string): Placed | undefined {
    return this.drawn.get(name)?.now;
  }

  setSolids(solids: readonly Solid[], floorColour: readonly [number, number, number]): void {
    const before = new Map([...this.drawn].map(([name, { now, solid }]) => [name, solid.movable ? now : undefined]));
    for (const mesh of this.meshes) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      mesh.dispose();
    }
    this.meshes = [];
    this.drawn.clear();
    this.moving.clear();
    for (const shape of Object.keys(shapes) as SolidShape[]) this.addShape(shape, solids.filter((solid) => solid.shape === shape), before);
    this.floorColour.setRGB(...floorColour, THREE.SRGBColorSpace);
    this.group.visible = true;
    this.setDark(this.dark);
  }

  setDark(dark: boolean): void {
    this.dark = dark;
    const grey = this.floorColour.getHSL({ h: 0, s: 0, l: 0 }, THREE.SRGBColorSpace);
    // The floor keeps its hue, and as much of its brightness as the page's own looks bear.
    const lightness = dark ? 0.09 + 0.1 * grey.l : Math.max(0.72 + 0.16 * grey.l, 0);
    this.floorMaterial.color.setHSL(grey.h, Math.min(grey.s, 0.35), lightness, THREE.SRGBColorSpace);
    const lines = this.floorMaterial.color.clone().offsetHSL(0, 0, dark ? 0.07 : -0.11);
    this.solidMaterial.color.setScalar(dark ? 0.72 : 1);
    this.makeGrid(lines);
  }

  // Where the movable ones are.
  moveThings(things: ReadonlyMap<string, Placed>, at_once: boolean): void {
    for (const [name, pose] of things) {
      const thing = this.drawn.get(name);
      if (!thing || this.held.has(name)) continue;
      thing.wanted = pose;
      if (at_once) this.place(thing, pose);
      else this.moving.add(thing);
    }
  }

  // A hand takes it there; `held`: until it is let go nothing else moves it.
  hold(name: string, pose: Placed | undefined): void {
    const thing = this.drawn.get(name);
    if (!thing) return;
    if (pose) {
      this.held.add(name);
      this.place(thing, pose);
    } else {
      this.held.delete(name);
    }
  }

  // The world is put under the robot; `near`: the grid's middle, in the world.
  put(odometry: Odometry, passed_s: number): void {
    const { x, y, z, yaw } = inverseOf(odometry);
    this.group.position.set(x, y, z);
    this.group.rotation.z = yaw;
    this.group.updateMatrixWorld();
    const share = 1 - Math.exp(-passed_s / follows_s);
    for (const thing of this.moving) this.follow(thing, share);
  }
  centreOn(x: number, y: number): void {
    this.floor.position.set(Math.round(x), Math.round(y), 0);
    this.grid?.position.set(Math.round(x), Math.round(y), 0);
  }

  private follow(thing: Drawn, share: number): void {
    const { now, wanted } = thing;
    const place = now.place.map((value, axis) => value + share * (wanted.place[axis]! - value)) as [number, number, number];
    const turn = this.turn.fromArray(now.turn).slerp(new THREE.Quaternion().fromArray(wanted.turn), share).toArray() as [number, number, number, number];
    const arrived = place.every((value, axis) => Math.abs(value - wanted.place[axis]!) < 1e-4) && Math.abs(turn.reduce((sum, value, at) => sum + value * wanted.turn[at]!, 0)) > 1 - 1e-7;
    this.place(thing, arrived ? wanted : { place, turn });
    if (arrived) this.moving.delete(thing);
  }

  private addShape(shape: SolidShape, solids: readonly Solid[], before: ReadonlyMap<string, Placed | undefined>): void {
    if (solids.length === 0) return;
    const mesh = new THREE.InstancedMesh(shapes[shape](), this.solidMaterial, solids.length);
    mesh.frustumCulled = false; // its ball would be made anew with each thing that moves
    const colour = new THREE.Color();
    for (const [index, solid] of solids.entries()) {
      const now = before.get(solid.name) ?? solid;
      const drawn: Drawn = { mesh, index, solid, now, wanted: solid };
      mesh.setColorAt(index, colour.setRGB(...solid.colour, THREE.SRGBColorSpace));
      this.drawn.set(solid.name, drawn);
      this.place(drawn, now);
    }
    this.meshes.push(mesh);
    this.group.add(mesh);
  }

  private place(thing: Drawn, pose: Placed): void {
    thing.now = pose;
    this.matrix.compose(new THREE.Vector3(...pose.place), this.turn.fromArray(pose.turn), new THREE.Vector3(...thing.solid.size));
    thing.mesh.setMatrixAt(thing.index, this.matrix);
    thing.mesh.instanceMatrix.needsUpdate = true;
  }

  // A line each half metre, over as much as is seen before the haze. In pieces: software rendering leaves out lines that reach behind the eye.
  private makeGrid(colour: THREE.Color): void {
    const half_m = 10, every_m = 0.5, piece_m = 1;
    const points: number[] = [];
    for (let at = -half_m; at <= half_m; at += every_m) {
      for (let from = -half_m; from < half_m; from += piece_m) points.push(from, at, 0, from + piece_m, at, 0, at, from, 0, at, from + piece_m, 0);
    }
    const geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    const grid = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour, depthWrite: false }));
    grid.renderOrder = -1;
    if (this.grid) {
      grid.position.copy(this.grid.position);
      this.group.remove(this.grid);
      this.grid.geometry.dispose();
    }
    this.grid = grid;
    this.group.add(grid);
  }
}
