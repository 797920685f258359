// Puts things into the simulated world by a click on the ground, and moves one by dragging it over the ground.
import type { Placed, Triple } from "../description.ts";
import { element, setText } from "../dom.ts";
import type { PictureTool, PictureTools } from "../picture_tools.ts";
import { heading_rad } from "../push.ts";
import type { SimulatorPicture } from "../scene/simulator_picture.ts";
import { mayBeTaken } from "./thing_events.ts";
import type { Solid } from "./solids.ts";

interface Drag {
  pointer: number;
  solid: Solid;
  pose: Placed; // where it was taken
  grip: Triple; // where on it, in the world
  at: Triple; // its middle now
  moved: boolean;
}
const told_ms = 300; // after which the simulator has told where it is
const startsAfter_m = 0.01; // who only clicks chooses

export class ThingTool implements PictureTool {
  on = false;
  places = false; // a click on the ground puts a new one there
  private readonly label = element("p", { class: "push-label", hidden: true });
  private drag: Drag | undefined;
  onToggle: (on: boolean) => void = () => {};

  constructor(
    private readonly picture: SimulatorPicture,
    private readonly canvas: HTMLCanvasElement,
    private readonly tools: PictureTools,
    private readonly user: { place: (at: Triple) => void; choose: (solid: Solid | undefined) => void; move: (solid: Solid, at: Triple, yaw_rad: number) => Promise<boolean> },
  ) {
    canvas.after(this.label);
    const listen = (kind: "pointerdown" | "pointermove" | "pointerup" | "pointercancel", take: (event: PointerEvent) => void) =>
      canvas.addEventListener(kind, take, { capture: true }); // before the camera takes them
    listen("pointerdown", (event) => this.begin(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => void this.end(event));
    listen("pointercancel", () => this.cancel());
    canvas.addEventListener("pointerleave", () => (this.label.hidden = !this.drag));
    window.addEventListener("keydown", (event) => event.key === "Escape" && this.cancel(), { capture: true }); // a stop goes no further
  }

  setOn(on: boolean): void {
    if (on === this.on) return;
    this.on = on;
    if (on) this.tools.choose(this);
    else {
      this.cancel();
      this.label.hidden = true;
      this.places = false;
    }
    this.canvas.classList.toggle("places", on);
    this.onToggle(on);
  }

  private cancel(): void {
    const { drag } = this;
    this.drag = undefined;
    if (!drag) return;
    this.putBack(drag);
    this.label.hidden = true;
  }

  private begin(event: PointerEvent): void {
    if (this.drag) {
      this.cancel(); // a second finger: somebody turns or zooms
      return;
    }
    const hit = this.on && event.button === 0 ? this.picture.hitAt(event.clientX, event.clientY) : undefined;
    if (!hit) return;
    const taken = hit.solid && mayBeTaken(hit.solid) ? hit.solid : undefined;
    if (!taken) {
      if (!this.places) return;
      event.stopImmediatePropagation();
      this.user.place(hit.place); // on whatever is seen there
      return;
    }
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.letGo(); // of the one before
    const pose = this.picture.world.poseOf(taken);
    this.drag = { pointer: event.pointerId, solid: taken, pose, grip: hit.place, at: pose.place, moved: false };
    this.user.choose(taken);
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) this.tellThing(event);
    if (!drag || event.pointerId !== drag.pointer) return;
    event.stopImmediatePropagation();
    const at = this.picture.levelAt(event.clientX, event.clientY, drag.grip[2]);
    if (!at) return;
    const [dx, dy] = [at[0] - drag.grip[0], at[1] - drag.grip[1]];
    drag.moved ||= Math.hypot(dx, dy) > startsAfter_m;
    if (!drag.moved) return;
    drag.at = [drag.pose.place[0] + dx, drag.pose.place[1] + dy, drag.pose.place[2]];
    this.picture.world.things.hold(drag.solid, { place: drag.at, turn: drag.pose.turn });
    this.picture.ask();
    this.tell(event, `${drag.solid.name}: x ${drag.at[0].toFixed(2)} m, y ${drag.at[1].toFixed(2)} m`);
  }

  private async end(event: PointerEvent): Promise<void> {
    const { drag } = this;
    if (!drag || event.pointerId !== drag.pointer) return;
    event.stopImmediatePropagation();
    this.drag = undefined;
    this.label.hidden = true;
    if (!drag.moved) return;
    const done = await this.user.move(drag.solid, drag.at, heading_rad(drag.pose.turn));
    if (done) setTimeout(() => !this.drag && this.letGo(), told_ms);
    else this.putBack(drag);
  }

  private putBack({ solid, moved, pose }: Drag): void {
    if (!moved) return;
    this.picture.world.things.hold(solid, pose);
    this.letGo();
  }
  private letGo(): void {
    this.picture.world.things.letGo();
    this.picture.ask();
  }

  // For a mouse that has not pressed yet.
  private tellThing(event: PointerEvent): void {
    const hit = this.on && event.buttons === 0 && event.pointerType === "mouse" ? this.picture.hitAt(event.clientX, event.clientY) : undefined;
    const taken = hit?.solid && mayBeTaken(hit.solid) ? hit.solid : undefined;
    this.label.hidden = !taken && !(hit && this.places);
    if (taken) this.tell(event, `${taken.name}: drag to move`);
    else if (hit && this.places) this.tell(event, "Put it here");
  }

  private tell(event: PointerEvent, text: string): void {
    setText(this.label, text);
    const frame = this.canvas.getBoundingClientRect();
    this.label.style.setProperty("--x", `${event.clientX - frame.left}px`);
    this.label.style.setProperty("--y", `${event.clientY - frame.top}px`);
    this.label.hidden = false;
  }
}
