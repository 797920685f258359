// A ghost of the robot: tinted, so that nobody takes it for the robot, and translucent where it stands in the robot's own picture.
import * as THREE from "three";
import type { Description } from "../description.ts";
import { RobotBody } from "./robot_body.ts";

export const ghostColour = 0x7fb2ea;

export function tint(body: RobotBody, opacity = 1): void {
  body.base.traverse((part) => {
    if (!(part instanceof THREE.Mesh)) return;
    const material = part.material as THREE.MeshLambertMaterial;
    material.color.set(ghostColour);
    material.transparent = opacity < 1;
    material.opacity = opacity;
    material.depthWrite = opacity === 1;
  });
}

// The robot in its home posture, both soles on the ground.
export class GoalGhost {
  readonly group = new THREE.Group();
  readonly body: RobotBody;

  constructor(description: Description) {
    this.body = new RobotBody(description);
    tint(this.body, 0.42);
    // The group's origin is the middle between the feet.
    this.body.base.updateMatrixWorld(true);
    const soles = ([0, 1] as const).map((side) => new THREE.Vector3().setFromMatrixPosition(this.body.solePose(side)));
    const middle = soles[0]!.add(soles[1]!).multiplyScalar(0.5);
    this.body.base.position.sub(middle);
    this.group.add(this.body.base);
    this.group.visible = false;
  }

  show(x: number, y: number, height_m: number, yaw: number): void {
    this.group.position.set(x, y, height_m);
    this.group.rotation.z = yaw;
    this.group.visible = true;
  }
  hide(): void {
    this.group.visible = false;
  }
}
