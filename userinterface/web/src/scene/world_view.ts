// The simulator's world in the picture: its floor, what stands on it, the things that are moved about.
import * as THREE from "three";
import type { Placed, Triple } from "../description.ts";
import type { Odometry } from "../simulator/simulation_state.ts";
import type { Solid } from "../simulator/solids.ts";
import { inverseOf } from "../simulator/world_frame.ts";
import { FixedSolids } from "./fixed_solids.ts";
import { Things } from "./things.ts";

const floorHalf_m = 40;
const grid = { half_m: 8, every_m: 0.5, piece_m: 2 }; // as much as is seen before the haze
const dimmed = 0.72; // in the dark

export class WorldView {
  // In the world's frame: put whatever has its place in the world into it.
  readonly group = new THREE.Group();
  readonly things = new Things();
  private readonly fixed = new FixedSolids();
  private readonly floorMaterial = new THREE.MeshBasicMaterial({ depthWrite: false });
  private readonly lineMaterial = new THREE.LineBasicMaterial({ depthWrite: false });
  private readonly ground = new THREE.Group();
  private floorColour = new THREE.Color(0.75, 0.75, 0.75);
  private dark = false;
  private all: readonly Solid[] = [];

  constructor() {
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(2 * floorHalf_m, 2 * floorHalf_m), this.floorMaterial);
    const lines = this.makeGrid();
    floor.renderOrder = -2; // under all: nothing of the robot is hidden by it, however odometry drifts in height
    lines.renderOrder = -1;
    this.ground.add(floor, lines);
    this.group.add(this.ground, this.fixed.group, this.things.group);
    this.group.visible = false;
  }

  get solids(): readonly Solid[] {
    return this.all;
  }
  // Where it is drawn.
  poseOf(solid: Solid): Placed {
    return this.things.poseOf(solid.name) ?? solid;
  }

  setSolids(solids: readonly Solid[], floorColour: Triple): void {
    this.all = solids;
    this.fixed.show(solids.filter(({ movable }) => !movable));
    this.things.show(solids.filter(({ movable }) => movable));
    this.floorColour.setRGB(...floorColour, THREE.SRGBColorSpace);
    this.group.visible = true;
    this.setDark(this.dark);
  }

  setDark(dark: boolean): void {
    this.dark = dark;
    const told = this.floorColour.getHSL({ h: 0, s: 0, l: 0 }, THREE.SRGBColorSpace);
    const { h, s, l } = told.s < 0.05 ? { h: 0.58, s: dark ? 0.16 : 0.1, l: told.l } : told; // grey becomes the page's own
    // The floor keeps its hue, and as much of its brightness as the page's own looks bear.
    const lightness = dark ? 0.09 + 0.1 * l : 0.72 + 0.16 * l;
    this.floorMaterial.color.setHSL(h, Math.min(s, 0.35), lightness, THREE.SRGBColorSpace);
    this.lineMaterial.color.setHSL(h, Math.min(s, 0.35), lightness + (dark ? 0.09 : -0.07), THREE.SRGBColorSpace);
    this.fixed.brightness = dark ? dimmed : 1;
    this.things.setBrightness(dark ? dimmed : 1);
  }

  // The world is put under the robot.
  put(odometry: Odometry, passed_s: number): void {
    const { x, y, z, yaw } = inverseOf(odometry);
    this.group.position.set(x, y, z);
    this.group.rotation.z = yaw;
    this.group.updateMatrixWorld();
    this.things.after(passed_s);
  }
  // The floor's lines are drawn around this place of the world.
  centreOn(x: number, y: number): void {
    this.ground.position.set(Math.round(x), Math.round(y), 0);
  }
  // `far_m`: behind that all is haze.
  see(camera: THREE.Camera, far_m: number): void {
    this.fixed.see(this.group.worldToLocal(camera.position.clone()), far_m);
  }

  // In pieces: software rendering leaves out lines that reach behind the eye.
  private makeGrid(): THREE.LineSegments {
    const { half_m, every_m, piece_m } = grid;
    const points: number[] = [];
    for (let at = -half_m; at <= half_m; at += every_m) {
      for (let from = -half_m; from < half_m; from += piece_m) points.push(from, at, 0, from + piece_m, at, 0, at, from, 0, at, from + piece_m, 0);
    }
    return new THREE.LineSegments(new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(points, 3)), this.lineMaterial);
  }
}
