// A small picture of its own in which a ghost of the robot plays a motion, again and again. The robot does not move by it, and
// nothing is asked of it: the postures are files of the page's server.
import * as THREE from "three";
import type { Context } from "./context.ts";
import { element, setText } from "./dom.ts";
import { loadPostures, motionText, postureAt, rising, timeInMotion, type MotionEntry, type MotionPostures, type Posture } from "./motions.ts";
import { tint } from "./scene/ghost.ts";
import { RobotBody } from "./scene/robot_body.ts";

const between_ms = 50; // two pictures
const lying: Record<string, [number, number]> = { // roll, pitch of the trunk
  "lies on its front": [0, Math.PI / 2], "lies on its back": [0, -Math.PI / 2], "lies on its left": [-Math.PI / 2, 0], "lies on its right": [Math.PI / 2, 0],
};

// The ghost and what it is drawn with: made when the first motion is looked at.
class GhostPicture {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(32, 1, 0.05, 50);
  private readonly body: RobotBody;
  private readonly box = new THREE.Box3();

  constructor(private readonly canvas: HTMLCanvasElement, context: Context) {
    const { description } = context;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: "low-power" });
    this.body = new RobotBody(description);
    tint(this.body);
    const size_m = description.hip_height * 2;
    const floor = new THREE.GridHelper(size_m * 1.2, 8, 0x8a97a6, 0x8a97a6);
    floor.rotation.x = Math.PI / 2;
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(1.5, 2, 4);
    this.scene.add(this.body.base, floor, new THREE.HemisphereLight(0xffffff, 0x8899aa, 2.4), sun);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(2 * size_m, 1.35 * size_m, 0.9 * size_m);
    this.camera.lookAt(0, 0, size_m * 0.52);
    void this.body.loadMeshes(context.token(), () => {}).catch(() => undefined); // boxes will do
  }

  draw(posture: Posture, start: string, risen: number): void {
    this.body.pose(posture.joints);
    if (posture.support === 3) this.layDown(start, risen);
    else this.stand(posture);
    const { clientWidth, clientHeight } = this.canvas;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / Math.max(clientHeight, 1);
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
  }

  // The sole that stands is where the plan has it.
  private stand({ feet, support }: Posture): void {
    const side = support === 1 ? 1 : 0;
    const [x, y, z, yaw] = feet[side];
    const wanted = new THREE.Matrix4().makeRotationZ(yaw).setPosition(x, y, z);
    const { base } = this.body;
    base.position.set(0, 0, 0);
    base.quaternion.identity();
    base.updateMatrixWorld(true);
    wanted.multiply(this.body.solePose(side).invert()).decompose(base.position, base.quaternion, base.scale);
  }

  // On the ground no plan says how the trunk lies: between its side at the start and upright, its lowest part on the ground.
  private layDown(start: string, risen: number): void {
    const { base } = this.body;
    const [roll, pitch] = lying[start] ?? [0, Math.PI / 2];
    base.quaternion.setFromEuler(new THREE.Euler(roll, pitch, 0)).slerp(new THREE.Quaternion(), risen * risen);
    base.position.set(0, 0, 0);
    this.box.setFromObject(base);
    base.position.set(-(this.box.min.x + this.box.max.x) / 2, 0, -this.box.min.z);
  }
}

export class MotionPreview {
  private readonly canvas = element("canvas", { role: "img", "aria-label": "Ghost of the robot that plays a motion" });
  private readonly title = element("strong");
  private readonly text = element("span");
  readonly figure = element("figure", { class: "preview", hidden: true }, this.canvas,
    element("figcaption", { role: "status" }, this.title, " ", this.text, element("small", {}, "A preview: the robot does not move.")));
  private readonly known = new Map<string, Promise<MotionPostures>>();
  private picture: GhostPicture | undefined;
  private shown: MotionEntry | undefined;

  constructor(private readonly context: Context) {}

  get name(): string | undefined {
    return this.shown?.name;
  }

  async show(entry: MotionEntry): Promise<void> {
    if (this.shown === entry) return;
    this.shown = entry;
    this.figure.hidden = false;
    this.canvas.hidden = entry.postures === undefined;
    setText(this.title, entry.name.replaceAll("_", " "));
    setText(this.text, motionText(entry));
    if (entry.postures === undefined) return;
    try {
      const motion = await this.posturesOf(entry.postures);
      if (this.shown === entry) this.play(entry, motion);
    } catch (error) {
      this.known.delete(entry.postures);
      if (this.shown === entry) setText(this.text, `No preview: ${(error as Error).message}`);
    }
  }

  hide(): void {
    this.shown = undefined;
    this.figure.hidden = true;
  }

  private posturesOf(path: string): Promise<MotionPostures> {
    const known = this.known.get(path) ?? loadPostures(path, this.context.token());
    this.known.set(path, known);
    return known;
  }

  private play(entry: MotionEntry, motion: MotionPostures): void {
    this.picture ??= new GhostPicture(this.canvas, this.context);
    const began_ms = performance.now();
    let drawn_ms = -Infinity;
    const draw = (now_ms: number) => {
      if (this.shown !== entry) return;
      requestAnimationFrame(draw);
      if (now_ms - drawn_ms < between_ms || this.canvas.clientWidth === 0) return;
      drawn_ms = now_ms;
      const time_s = timeInMotion(Math.max(now_ms - began_ms, 0) / 1000, motion);
      this.picture?.draw(postureAt(motion, time_s), entry.start ?? "", rising(motion, time_s));
      this.figure.dataset["time"] = time_s.toFixed(2);
    };
    requestAnimationFrame(draw);
  }
}
