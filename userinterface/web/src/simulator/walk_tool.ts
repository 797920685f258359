// Chooses where the robot is to walk: a click or a touch on the floor, and a drag for where it is to look there.
import type { SimulatorPicture } from "../scene/simulator_picture.ts";
import { button, element, setText } from "../dom.ts";
import type { PictureTool, PictureTools } from "../picture_tools.ts";
import { goalOfDrag, goalText, type Goal } from "./footstep_plan.ts";
import { isGround } from "./solids.ts";

interface Drag {
  pointer: number;
  from: readonly [number, number];
  height_m: number;
  begun: PointerEvent;
  goal: Goal;
}

export class WalkTool implements PictureTool {
  readonly toggle: HTMLButtonElement;
  private readonly label = element("p", { class: "push-label", hidden: true });
  private drag: Drag | undefined;
  private passes = false; // what comes now is for the camera
  onToggle: (on: boolean) => void = () => {};

  // `aim`: while the heading is dragged, again and again. `choose`: it is let go. `broken`: the drag is broken off.
  constructor(
    private readonly picture: SimulatorPicture,
    private readonly canvas: HTMLCanvasElement,
    private readonly tools: PictureTools,
    private readonly turnBySecond: (on: boolean) => void,
    private readonly user: { aim: (goal: Goal) => void; choose: (goal: Goal) => void; broken: () => void },
  ) {
    this.toggle = button("Walk to", () => this.setOn(!this.on), {
      "aria-pressed": "false", id: "walk-to", class: "walk-to", title: "Choose where the robot walks: click a place on the floor, drag for where it looks there" });
    canvas.after(this.label);
    const listen = (kind: "pointerdown" | "pointermove" | "pointerup" | "pointercancel", take: (event: PointerEvent) => void) =>
      canvas.addEventListener(kind, take, { capture: true }); // before the camera takes them
    listen("pointerdown", (event) => this.begin(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.end(event));
    listen("pointercancel", () => this.cancel());
    canvas.addEventListener("pointerleave", () => (this.label.hidden = !this.drag));
  }

  get on(): boolean {
    return this.toggle.getAttribute("aria-pressed") === "true";
  }
  setOn(on: boolean): void {
    if (on === this.on) return;
    if (on) this.tools.choose(this);
    this.toggle.setAttribute("aria-pressed", String(on));
    this.canvas.classList.toggle("walks", on);
    this.turnBySecond(on);
    if (!on) {
      this.cancel();
      this.label.hidden = true;
    }
    this.onToggle(on);
  }
  // Gives whether there was a drag.
  cancel(): boolean {
    if (!this.drag) return false;
    this.drag = undefined;
    this.label.hidden = true;
    this.user.broken();
    return true;
  }

  // A place that one may stand on, as it is seen there.
  private floorAt(event: PointerEvent): { place: readonly [number, number]; height_m: number } | { blocked: string } | undefined {
    const hit = this.picture.hitAt(event.clientX, event.clientY);
    if (!hit) return undefined;
    if (hit.solid && !isGround(hit.solid)) return { blocked: hit.solid.name };
    return { place: [hit.place[0], hit.place[1]], height_m: hit.place[2] };
  }

  private begin(event: PointerEvent): void {
    if (this.passes) return;
    if (this.drag) {
      this.giveToCamera(this.drag.begun); // a second finger: somebody turns or zooms
      return;
    }
    const floor = this.on && event.button === 0 ? this.floorAt(event) : undefined;
    if (!floor || "blocked" in floor) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    const goal = goalOfDrag(floor.place, floor.place, this.picture.robotPlace());
    this.drag = { pointer: event.pointerId, from: floor.place, height_m: floor.height_m, begun: event, goal };
    this.aim(event, goal);
  }

  // The camera has not seen the first finger: it gets it now, just before the second one.
  private giveToCamera(first: PointerEvent): void {
    this.cancel();
    this.passes = true;
    this.canvas.dispatchEvent(new PointerEvent(first.type, first));
    this.passes = false;
  }

  private move(event: PointerEvent): void {
    if (!this.drag) this.tellPlace(event);
    if (event.pointerId !== this.drag?.pointer) return;
    event.stopImmediatePropagation();
    const to = this.picture.levelAt(event.clientX, event.clientY, this.drag.height_m);
    if (to) this.drag.goal = goalOfDrag(this.drag.from, [to[0], to[1]], this.picture.robotPlace());
    this.aim(event, this.drag.goal);
  }

  private end(event: PointerEvent): void {
    if (event.pointerId !== this.drag?.pointer) return;
    event.stopImmediatePropagation();
    const { goal } = this.drag;
    this.drag = undefined;
    this.label.hidden = true;
    this.user.choose(goal);
  }

  private aim(event: PointerEvent, goal: Goal): void {
    this.user.aim(goal);
    this.tell(event, goalText(goal));
  }

  // For a mouse that has not pressed yet.
  private tellPlace(event: PointerEvent): void {
    const floor = this.on && event.buttons === 0 && event.pointerType === "mouse" ? this.floorAt(event) : undefined;
    this.label.hidden = !floor;
    if (!floor) return;
    if ("blocked" in floor) this.tell(event, `${floor.blocked} stands here`);
    else this.tell(event, "Walk here");
  }

  private tell(event: PointerEvent, text: string): void {
    setText(this.label, text);
    const frame = this.canvas.getBoundingClientRect();
    this.label.style.setProperty("--x", `${event.clientX - frame.left}px`);
    this.label.style.setProperty("--y", `${event.clientY - frame.top}px`);
    this.label.hidden = false;
  }
}
