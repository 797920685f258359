// The things of a world that are moved about, by the robot or by hand: each is drawn where it is told to be, smoothly.
import * as THREE from "three";
import type { Placed, Turn, Triple } from "../description.ts";
import type { Solid } from "../simulator/solids.ts";
import { shapeOf } from "./solid_shapes.ts";

const follows_s = 0.08; // so quickly it is drawn where it is told to be, ten times a second
const arrived_m = 1e-4, arrived_turn = 1e-7;

interface Thing {
  mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshLambertMaterial>;
  solid: Solid;
  wanted: Placed | undefined; // undefined: it is there
}

export class Things {
  readonly group = new THREE.Group();
  private readonly things = new Map<string, Thing>();
  private held: Thing | undefined;
  private brightness = 1;

  show(solids: readonly Solid[]): void {
    const before = new Map([...this.things].map(([name]) => [name, this.poseOf(name)]));
    for (const { mesh } of this.things.values()) mesh.material.dispose();
    this.things.clear();
    this.group.clear();
    for (const solid of solids) this.add(solid, before.get(solid.name) ?? solid);
    if (this.held) this.group.add(this.held.mesh);
  }

  setBrightness(share: number): void {
    this.brightness = share;
    for (const { mesh, solid } of this.things.values()) this.paint(mesh, solid);
  }

  // Where it is drawn; undefined: it is none of them.
  poseOf(name: string): Placed | undefined {
    const thing = this.held?.solid.name === name ? this.held : this.things.get(name);
    return thing && { place: thing.mesh.position.toArray(), turn: thing.mesh.quaternion.toArray() as Turn };
  }

  move(poses: ReadonlyMap<string, Placed>, at_once: boolean): void {
    for (const [name, pose] of poses) {
      const thing = this.things.get(name);
      if (!thing || thing === this.held) continue;
      thing.wanted = pose;
      if (at_once) this.follow(thing, pose, 1);
    }
  }
  after(passed_s: number): void {
    const share = 1 - Math.exp(-passed_s / follows_s);
    for (const thing of this.things.values()) if (thing.wanted && thing !== this.held) this.follow(thing, thing.wanted, share);
  }

  // A hand has it there: until it lets go nothing else moves it. One that stands fast is lifted as a copy.
  hold(solid: Solid, { place, turn }: Placed): void {
    this.held ??= this.things.get(solid.name) ?? this.make(solid, solid);
    this.held.mesh.position.set(...place);
    this.held.mesh.quaternion.set(...turn);
    if (!this.held.mesh.parent) this.group.add(this.held.mesh);
  }
  letGo(): void {
    const { held } = this;
    this.held = undefined;
    if (held && this.things.get(held.solid.name) !== held) this.group.remove(held.mesh);
  }

  private add(solid: Solid, pose: Placed): void {
    const thing = this.make(solid, pose);
    this.things.set(solid.name, thing);
    this.group.add(thing.mesh);
  }

  private make(solid: Solid, { place, turn }: Placed): Thing {
    const mesh = new THREE.Mesh(shapeOf(solid.shape, true), new THREE.MeshLambertMaterial());
    this.paint(mesh, solid);
    mesh.scale.set(...solid.size);
    mesh.position.set(...place);
    mesh.quaternion.set(...turn);
    return { mesh, solid, wanted: undefined };
  }
  private paint(mesh: Thing["mesh"], { colour }: Solid): void {
    mesh.material.color.setRGB(...(colour as Triple), THREE.SRGBColorSpace).multiplyScalar(this.brightness);
  }

  private follow(thing: Thing, { place, turn }: Placed, share: number): void {
    const { position, quaternion } = thing.mesh;
    const [at, attitude] = [new THREE.Vector3(...place), new THREE.Quaternion(...turn)];
    position.lerp(at, share);
    quaternion.slerp(attitude, share);
    if (position.distanceTo(at) > arrived_m || Math.abs(quaternion.dot(attitude)) < 1 - arrived_turn) return;
    position.copy(at);
    quaternion.copy(attitude);
    thing.wanted = undefined;
  }
}
