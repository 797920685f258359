// A force on a link, as an arrow that begins where the link is held and goes with it.
import * as THREE from "three";
import type { Flat } from "../push.ts";

// A place on a link, in the link's own frame.
export interface Grip {
  link: number;
  group: THREE.Object3D;
  place: THREE.Vector3;
}

export class PushArrow {
  readonly group = new THREE.Group();
  private readonly shaft: THREE.Mesh;
  private readonly head: THREE.Mesh;
  private readonly material = new THREE.MeshBasicMaterial({ depthTest: false, depthWrite: false, transparent: true, opacity: 0.9 });
  private grip: Grip | undefined;

  // `size_m`: of the robot. `most_N`: an arrow of this force is as long as the robot is high.
  constructor(
    private readonly size_m: number,
    private readonly most_N: number,
  ) {
    const radius_m = size_m * 0.012;
    this.shaft = new THREE.Mesh(new THREE.CylinderGeometry(radius_m, radius_m, 1, 12).translate(0, 0.5, 0).rotateX(Math.PI / 2), this.material);
    this.head = new THREE.Mesh(new THREE.ConeGeometry(radius_m * 3, radius_m * 8, 16).rotateX(Math.PI / 2), this.material);
    this.shaft.renderOrder = this.head.renderOrder = 3;
    this.group.add(this.shaft, this.head);
    this.group.visible = false;
  }

  set colour(colour: number) {
    this.material.color.setHex(colour);
  }

  show(grip: Grip, [x, y]: Flat): void {
    const size_N = Math.hypot(x, y);
    const length_m = this.size_m * (0.12 + (0.88 * size_N) / this.most_N);
    this.shaft.scale.z = length_m;
    this.head.position.z = length_m;
    this.group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(x, y, 0).normalize());
    this.group.visible = true;
    this.grip = grip;
    this.follow();
  }

  hide(): void {
    this.group.visible = false;
    this.grip = undefined;
  }

  // To be called when the robot has another pose.
  follow(): void {
    if (!this.grip) return;
    this.grip.group.updateWorldMatrix(true, false);
    this.group.position.copy(this.grip.place).applyMatrix4(this.grip.group.matrixWorld);
  }
}
