// What the picture shows of a simulator beside the robot: the world, a planned way, and a ghost at its goal. All of it has its place in the
// simulator's world, which is put under the robot's odometry before each picture.
import type { Description, Triple } from "../description.ts";
import { groundHeight, firstHit, type Hit, type Ray, type Solid } from "../simulator/solids.ts";
import type { FootstepPlan, Goal } from "../simulator/footstep_plan.ts";
import type { Odometry, SimulationState } from "../simulator/simulation_state.ts";
import { outOf, WorldFrame } from "../simulator/world_frame.ts";
import { FootstepMarks } from "./footstep_marks.ts";
import { GoalGhost } from "./ghost.ts";
import type { Scene } from "./scene.ts";
import type { TwinRobot } from "./twin_robot.ts";
import { WorldView } from "./world_view.ts";

const manySolids = 300; // more than that: less of them is seen at once, so that a computer that draws in software keeps up
const longestPicture_s = 0.5;

export class SimulatorPicture {
  readonly world = new WorldView();
  private readonly frame = new WorldFrame();
  private readonly marks: FootstepMarks;
  private readonly ghost: GoalGhost;
  private odometry: Odometry = { x: 0, y: 0, z: 0, yaw: 0 }; // as it is drawn
  private run: number | undefined;
  private twin: TwinRobot | undefined;
  private drawn_ms = 0;

  constructor(
    private readonly scene: Scene,
    description: Description,
    token: string | undefined,
  ) {
    const [sole] = description.soles;
    this.marks = new FootstepMarks({ length: sole.size[0], width: sole.size[1], ahead: sole.centre[0] }, scene.size_m, { left: 0, right: 0, goal: 0 });
    this.ghost = new GoalGhost(description);
    this.world.group.add(this.marks.group, this.ghost.group);
    scene.onBeforeDraw = (now_ms, camera, far_m) => {
      this.settle(now_ms);
      this.world.see(camera, far_m);
    };
    scene.onPaint = ({ way, twin }, dark) => {
      this.marks.setColours(way);
      this.twin?.setColour(twin);
      this.world.setDark(dark);
    };
    scene.add(this.world.group);
    scene.showWorld();
    scene.repaint();
    void this.ghost.body.loadMeshes(token, () => scene.ask()).catch(() => undefined); // boxes will do
  }

  // A picture is wanted.
  ask(): void {
    this.scene.ask();
  }
  // The robot there, which has its place in the world.
  addTwin(twin: TwinRobot): void {
    this.twin = twin;
    this.world.group.add(twin.group);
    this.scene.repaint();
  }
  setSolids(solids: readonly Solid[], floorColour: Triple): void {
    this.world.setSolids(solids, floorColour);
    this.scene.hazeAfter = solids.length > manySolids ? 9 : 11;
    this.scene.ask();
  }

  // `origin`: of the picture's frame in the world; undefined: it is where it was, or at first where the robot's own odometry begins.
  show(state: SimulationState, origin: Odometry | undefined): void {
    const jumped = this.frame.take(origin ?? (this.frame.isKnown ? undefined : state.odometry), state.run);
    if (jumped) this.scene.forgetSteps(); // they were made in another frame
    this.world.things.move(state.things, state.run !== this.run);
    this.run = state.run;
    this.scene.ask();
  }

  // What is seen at this place of the window, in the world's frame; undefined: nothing of it, or the robot.
  hitAt(x_px: number, y_px: number): Hit | undefined {
    if (this.scene.gripAt(x_px, y_px)) return undefined;
    return firstHit(this.rayAt(x_px, y_px), this.world.solids, (solid) => this.world.poseOf(solid));
  }
  // Where a level plane of this height is seen there.
  levelAt(x_px: number, y_px: number, height_m: number): Triple | undefined {
    const { origin, direction } = this.rayAt(x_px, y_px);
    const distance_m = (height_m - origin[2]) / direction[2];
    if (!(distance_m > 0 && distance_m < 100)) return undefined;
    return [origin[0] + distance_m * direction[0], origin[1] + distance_m * direction[1], height_m];
  }

  // The middle between the feet, about: where the base is, in the world.
  robotPlace(): Goal {
    const { position, quaternion: { x, y, z, w } } = this.scene.body.base;
    const place = outOf(this.odometry, position);
    return { x: place.x, y: place.y, yaw: this.odometry.yaw + Math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z)) };
  }

  showGoal(goal: Goal): void {
    this.marks.showGoal(goal, this.height);
    this.ghost.show(goal.x, goal.y, this.height(goal.x, goal.y), goal.yaw);
    this.scene.ask();
  }
  showPlan(plan: FootstepPlan | undefined): void {
    if (plan) this.marks.showPlan(plan, this.height);
    else this.marks.clearSteps();
    this.scene.ask();
  }
  fadeSteps(passed: number): void {
    this.marks.fade(passed);
    this.scene.ask();
  }
  clearWay(): void {
    this.marks.clear();
    this.ghost.hide();
    this.scene.ask();
  }

  private readonly height = (x: number, y: number) => groundHeight(this.world.solids, x, y);

  private rayAt(x_px: number, y_px: number): Ray {
    const { ray } = this.scene.rayAt(x_px, y_px);
    ray.applyMatrix4(this.world.group.matrixWorld.clone().invert());
    return { origin: ray.origin.toArray(), direction: ray.direction.toArray() };
  }

  private settle(now_ms: number): void {
    const passed_s = Math.min((now_ms - this.drawn_ms) / 1000, longestPicture_s);
    this.drawn_ms = now_ms;
    this.odometry = this.frame.after(passed_s) ?? this.odometry;
    this.world.put(this.odometry, passed_s);
    const { x, y } = outOf(this.odometry, this.scene.body.base.position);
    this.world.centreOn(x, y);
    if (this.twin?.settle(now_ms)) this.scene.ask();
  }
}
