// The picture: robot, ground and camera, drawn when there is something new, and no more often than it pays.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Description } from "../description.ts";
import type { Flat } from "../push.ts";
import type { ViewFrame } from "../view_decoder.ts";
import { Ground, type GroundColours } from "./ground.ts";
import { FramePace } from "./frame_pace.ts";
import { PushArrow, type Grip } from "./push_arrow.ts";
import type { WayColours } from "./footstep_marks.ts";
import { RobotBody } from "./robot_body.ts";

interface Palette extends GroundColours {
  sky: number;
  push: number;
  twin: number; // of the robot there
  way: WayColours;
}
const palettes: Record<"light" | "dark", Palette> = {
  light: { sky: 0xe8edf2, ground: 0xdde3e9, grid: 0xc3ccd6, made: 0x8a97a6, planned: 0x1766c2, support: 0x1b8a4b, zmp: 0xd12c2c, plannedZmp: 0x1766c2, com: 0xb06a00, push: 0x7a2bd6, twin: 0xd4237f, way: { left: 0x0d8f8f, right: 0xd4691a, goal: 0x1766c2 } },
  dark: { sky: 0x12171d, ground: 0x171d24, grid: 0x2a333d, made: 0x5d6b7a, planned: 0x63b0ff, support: 0x35c27a, zmp: 0xff6b5e, plannedZmp: 0x63b0ff, com: 0xffb74d, push: 0xc39bff, twin: 0xff6fb5, way: { left: 0x2fc6c0, right: 0xff9a4d, goal: 0x63b0ff } },
};

// Then every pixel costs the processor's time.
function drawsInSoftware(): boolean {
  return document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true }) === null;
}

// Opaque: the browser then lays it onto the page as it is, which costs a third less than blending it.
function openContext(canvas: HTMLCanvasElement, antialias: boolean): WebGL2RenderingContext {
  const context = canvas.getContext("webgl2", { alpha: false, antialias, stencil: false, powerPreference: "low-power" });
  if (!context) throw new Error("this browser draws no WebGL 2");
  return context;
}

export type Look = "behind" | "front" | "side" | "top";

export class Scene {
  readonly body: RobotBody;
  readonly pace = new FramePace();
  private readonly software: boolean;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly fog = new THREE.Fog(0);
  private readonly camera = new THREE.PerspectiveCamera(38, 1, 0.02, 200);
  private readonly controls: OrbitControls;
  private readonly ground: Ground;
  private readonly arrow: PushArrow;
  readonly size_m: number; // of the robot
  private followed = new THREE.Vector3();
  private pending = true;
  private old = false;
  private asked = false;
  private dark = false;
  // How far behind what is looked at the haze is closed, in sizes of the robot.
  hazeAfter = 6.5;
  follows = true;
  onDrawn: () => void = () => {};
  // Before each picture: what moves by itself is put where it belongs.
  onBeforeDraw: (now_ms: number, camera: THREE.PerspectiveCamera, far_m: number) => void = () => {};
  onPaint: (palette: Palette, dark: boolean) => void = () => {};

  constructor(
    private readonly canvas: HTMLCanvasElement,
    description: Description,
  ) {
    this.size_m = description.hip_height * 2;
    this.software = drawsInSoftware();
    this.renderer = new THREE.WebGLRenderer({ canvas, context: openContext(canvas, !this.software) });
    this.body = new RobotBody(description);
    const [sole] = description.soles;
    this.ground = new Ground({ length: sole.size[0], width: sole.size[1], ahead: sole.centre[0] }, this.size_m, palettes.light);
    this.arrow = new PushArrow(this.size_m, description.bounds.push?.most ?? 1);
    this.scene.fog = this.fog;
    this.scene.add(this.body.base, this.ground.group, this.arrow.group, new THREE.HemisphereLight(0xffffff, 0x8899aa, 2));
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(1.5, 2, 4);
    this.scene.add(sun);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = Math.PI * 0.53;
    this.controls.minDistance = this.size_m * 0.6;
    this.controls.maxDistance = this.size_m * 20;
    this.controls.addEventListener("change", () => this.ask());
    this.body.base.position.z = description.hip_height;
    this.followed.set(0, 0, this.size_m * 0.56);
    this.lookFrom("behind");
    new ResizeObserver(() => this.resize()).observe(canvas);
    const dark = matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", () => this.paint(dark.matches));
    this.paint(dark.matches);
  }

  show(frame: ViewFrame): void {
    const [x = NaN, y = NaN] = frame.base_place;
    const z = frame.base_height[0] ?? NaN;
    if (!Number.isNaN(x + y + z)) {
      this.body.base.position.set(x, y, z);
      const [a = 0, b = 0, c = 0, d = 1] = frame.base_turn;
      this.body.base.quaternion.set(a, b, c, d).normalize();
    }
    this.body.pose(frame.joint);
    this.ground.show(frame, this.body);
    this.arrow.follow();
    if (this.follows) this.follow();
    this.pace.wish();
    this.ask();
  }

  setOld(old: boolean): void {
    if (old === this.old) return;
    this.old = old;
    this.body.setOld(old);
    this.ask();
  }

  lookFrom(look: Look): void {
    const away = this.size_m * 2.5;
    const from: Record<Look, [number, number, number]> = {
      behind: [-0.78 * away, -0.52 * away, 0.42 * away],
      front: [away, 0.15 * away, 0.25 * away],
      side: [0, -away, 0.2 * away],
      top: [-0.02 * away, 0, 1.2 * away],
    };
    this.controls.target.copy(this.followed);
    this.camera.position.copy(this.followed).add(new THREE.Vector3(...from[look]));
    this.controls.update();
    this.ask();
  }

  zoom(share: number): void {
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.setLength(THREE.MathUtils.clamp(arm.length() * share, this.controls.minDistance, this.controls.maxDistance));
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.ask();
  }

  // What of the robot is seen at this place of the window.
  gripAt(x_px: number, y_px: number): Grip | undefined {
    return this.body.gripAt(this.rayAt(x_px, y_px));
  }
  // From the eye through this place of the window.
  rayAt(x_px: number, y_px: number): THREE.Raycaster {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2((2 * (x_px - left)) / width - 1, 1 - (2 * (y_px - top)) / height), this.camera);
    return ray;
  }
  // Puts something into the picture for good.
  add(part: THREE.Object3D): void {
    this.scene.add(part);
    this.ask();
  }
  // There is a floor with a grid of its own, and more to be seen of it.
  showWorld(): void {
    this.ground.hideGrid();
    this.ask();
  }
  // Of the footsteps that were made.
  forgetSteps(): void {
    this.ground.forgetSteps();
    this.ask();
  }
  // While a tool takes what a single finger, or the left button, does on the floor: the right button and two fingers turn the camera.
  turnBySecond(on: boolean): void {
    this.controls.mouseButtons.RIGHT = on ? THREE.MOUSE.ROTATE : THREE.MOUSE.PAN;
    this.controls.touches.TWO = on ? THREE.TOUCH.DOLLY_ROTATE : THREE.TOUCH.DOLLY_PAN;
  }
  repaint(): void {
    this.paint(this.dark);
  }
  gripOn(link: number): Grip | undefined {
    return this.body.gripOn(link);
  }
  // Where the camera looks, level and of length 1; where it looks straight down, what is up in the picture.
  away(): Flat {
    const look = this.camera.getWorldDirection(new THREE.Vector3());
    if (Math.hypot(look.x, look.y) < 0.2) look.set(0, 1, 0).applyQuaternion(this.camera.quaternion);
    const length = Math.hypot(look.x, look.y);
    return [look.x / length, look.y / length];
  }
  showPush(grip: Grip, force_N: Flat): void {
    this.arrow.show(grip, force_N);
    this.ask();
  }
  hidePush(): void {
    this.arrow.hide();
    this.ask();
  }

  // A picture is wanted; several wishes are one.
  ask(): void {
    this.pending = true;
    if (this.asked || document.hidden) return;
    this.asked = true;
    requestAnimationFrame((now_ms) => this.draw(now_ms));
  }

  private draw(now_ms: number): void {
    this.asked = false;
    if (!this.pending) return;
    if (!this.pace.isDue(now_ms)) {
      this.ask();
      return;
    }
    this.pending = false;
    this.haze();
    this.onBeforeDraw(now_ms, this.camera, this.fog.far);
    this.renderer.render(this.scene, this.camera);
    if (this.pace.drew(now_ms)) this.resize();
    this.onDrawn();
  }

  // The ground fades out behind what is looked at, from however far.
  private haze(): void {
    const away_m = this.camera.position.distanceTo(this.controls.target);
    this.fog.near = away_m + this.size_m;
    this.fog.far = away_m + Math.max(this.hazeAfter * this.size_m, away_m);
  }

  private follow(): void {
    const { x, y } = this.body.base.position;
    const step = new THREE.Vector3(x - this.followed.x, y - this.followed.y, 0);
    this.followed.add(step);
    this.controls.target.add(step);
    this.camera.position.add(step);
    this.camera.updateMatrixWorld();
  }

  private paint(dark: boolean): void {
    this.dark = dark;
    const palette = palettes[dark ? "dark" : "light"];
    this.scene.background = new THREE.Color(palette.sky);
    this.fog.color.set(palette.sky);
    this.ground.setColours(palette);
    this.arrow.colour = palette.push;
    this.onPaint(palette, dark);
    this.ask();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, this.software ? 1 : 2) * this.pace.fineness);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.ask();
  }
}
