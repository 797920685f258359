// The robot there, as measured, in the world of the simulated one: a translucent shell of one colour. Where both are at the same place it tints
// the simulated robot; where they differ it stands out.
import * as THREE from "three";
import type { Description } from "../description.ts";
import { PoseFollower, type Pose } from "../twin/pose_follower.ts";
import { RobotBody } from "./robot_body.ts";

const clear = 0.55, faint = 0.16;
const afterRobot = 1; // in the order of what is drawn

export class TwinRobot {
  readonly group = new THREE.Group();
  private readonly body: RobotBody;
  private readonly follower = new PoseFollower();
  // Drawn with what is opaque, the nearest first, and blended by hand: so of its parts that lie behind each other one is seen, and each pixel costs once.
  private readonly material = new THREE.MeshLambertMaterial({
    blending: THREE.CustomBlending, blendSrc: THREE.SrcAlphaFactor, blendDst: THREE.OneMinusSrcAlphaFactor, opacity: clear,
    polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2, // over the simulated robot where both are the same
  });
  private wanted = true;

  constructor(description: Description) {
    this.body = new RobotBody(description);
    this.paint();
    this.group.add(this.body.base);
    this.group.visible = false;
  }

  // In the place of the boxes that stand for them until then.
  async loadMeshes(token: string | undefined, loaded: () => void): Promise<void> {
    await this.body.loadMeshes(token, loaded);
  }
  setColour(colour: number): void {
    this.material.color.setHex(colour);
  }
  // A person wants to see it.
  setWanted(wanted: boolean): void {
    this.wanted = wanted;
  }
  // What is shown is not of now.
  setFaded(faded: boolean): void {
    this.material.opacity = faded ? faint : clear;
  }

  // undefined: nothing is known.
  show(pose: Pose | undefined, now_ms: number): void {
    if (pose) this.follower.take(pose, now_ms);
    else this.follower.forget();
  }

  // Before each picture. Gives whether it moves on by itself.
  settle(now_ms: number): boolean {
    const pose = this.wanted ? this.follower.at(now_ms) : undefined;
    this.group.visible = pose !== undefined;
    if (!pose) return false;
    this.body.base.position.fromArray(pose.base.place);
    this.body.base.quaternion.fromArray(pose.base.turn);
    this.body.pose(pose.joints);
    return !this.follower.arrived(now_ms);
  }

  private paint(): void {
    this.body.base.traverse((part) => {
      if (!(part instanceof THREE.Mesh)) return;
      part.material = this.material;
      part.renderOrder = afterRobot;
    });
  }
}
