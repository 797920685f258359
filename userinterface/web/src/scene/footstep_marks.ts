// A planned way on the ground: a sole for each step, left and right in two colours, those that are behind faded; and the goal, as a ring
// with an arrow for where the robot will look.
import * as THREE from "three";
import type { FootstepPlan, Goal, Side } from "../simulator/footstep_plan.ts";

const above_m = 0.006;
const rounded = 0.28; // of a sole's width: its corners

export interface WayColours {
  left: number;
  right: number;
  goal: number;
}

function soleShape(length_m: number, width_m: number, ahead_m: number): THREE.ShapeGeometry {
  const [x, y, r] = [length_m / 2, width_m / 2, rounded * width_m];
  const shape = new THREE.Shape().moveTo(-x + r, -y).lineTo(x - r, -y).quadraticCurveTo(x, -y, x, -y + r).lineTo(x, y - r).quadraticCurveTo(x, y, x - r, y)
    .lineTo(-x + r, y).quadraticCurveTo(-x, y, -x, y - r).lineTo(-x, -y + r).quadraticCurveTo(-x, -y, -x + r, -y);
  return new THREE.ShapeGeometry(shape, 4).translate(ahead_m, 0, 0) as THREE.ShapeGeometry;
}

// Drawn over the floor and over what they stand on, under the robot and whatever hides them.
function material(colour: number, opacity: number): THREE.MeshBasicMaterial {
  return new THREE.MeshBasicMaterial({ color: colour, transparent: true, opacity, depthWrite: false, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4 });
}

export class FootstepMarks {
  readonly group = new THREE.Group();
  private readonly sole: THREE.ShapeGeometry;
  private readonly coming: [THREE.MeshBasicMaterial, THREE.MeshBasicMaterial];
  private readonly passed: [THREE.MeshBasicMaterial, THREE.MeshBasicMaterial];
  private readonly goalMaterial: THREE.MeshBasicMaterial;
  private readonly goal = new THREE.Group();
  private readonly soles: THREE.Mesh[] = [];
  private sides: Side[] = [];

  constructor(sole: { length: number; width: number; ahead: number }, size_m: number, colours: WayColours) {
    this.sole = soleShape(sole.length, sole.width, sole.ahead);
    this.coming = [material(colours.left, 0.85), material(colours.right, 0.85)];
    this.passed = [material(colours.left, 0.16), material(colours.right, 0.16)];
    this.goalMaterial = material(colours.goal, 0.9);
    const radius_m = size_m * 0.24;
    const ring = new THREE.Mesh(new THREE.RingGeometry(radius_m * 0.86, radius_m, 48), this.goalMaterial);
    const arrow = new THREE.Shape().moveTo(radius_m * 1.75, 0).lineTo(radius_m * 1.12, radius_m * 0.42).lineTo(radius_m * 1.12, -radius_m * 0.42);
    this.goal.add(ring, new THREE.Mesh(new THREE.ShapeGeometry(arrow), this.goalMaterial));
    this.goal.visible = false;
    this.group.add(this.goal);
  }

  setColours({ left, right, goal }: WayColours): void {
    for (const materials of [this.coming, this.passed]) {
      materials[0].color.setHex(left);
      materials[1].color.setHex(right);
    }
    this.goalMaterial.color.setHex(goal);
  }

  // `height`: of the ground at a place.
  showGoal({ x, y, yaw }: Goal, height: (x: number, y: number) => number): void {
    this.goal.position.set(x, y, height(x, y) + above_m);
    this.goal.rotation.z = yaw;
    this.goal.visible = true;
  }

  showPlan(plan: FootstepPlan, height: (x: number, y: number) => number): void {
    this.clearSteps();
    this.sides = plan.steps.map(({ side }) => side);
    for (const { x, y, yaw, side } of plan.steps) {
      const mesh = new THREE.Mesh(this.sole, this.coming[side]);
      mesh.position.set(x, y, height(x, y) + above_m);
      mesh.rotation.z = yaw;
      this.soles.push(mesh);
      this.group.add(mesh);
    }
  }

  // So many of the steps have been made.
  fade(passed: number): void {
    for (const [index, mesh] of this.soles.entries()) mesh.material = (index < passed ? this.passed : this.coming)[this.sides[index] ?? 0];
  }

  clearSteps(): void {
    for (const mesh of this.soles.splice(0)) this.group.remove(mesh);
  }
  clear(): void {
    this.clearSteps();
    this.goal.visible = false;
  }
}
