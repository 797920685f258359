// Pushes the simulated robot: by a click or a drag on a link in the picture, or by a list and buttons for who has no pointer.
import type { Context } from "./context.ts";
import { button, element, setText } from "./dom.ts";
import { forceOfDrag, heading_rad, inHeading, push_s, pushRequest, sizeOf, type Flat, type PushBounds } from "./push.ts";
import type { PictureTools } from "./picture_tools.ts";
import type { Grip } from "./scene/push_arrow.ts";
import type { Scene } from "./scene/scene.ts";

const shown_ms = 900;
const directions: readonly { text: string; name: string; force: Flat }[] = [
  { text: "↑", name: "ahead", force: [1, 0] },
  { text: "↓", name: "back", force: [-1, 0] },
  { text: "←", name: "to its left", force: [0, 1] },
  { text: "→", name: "to its right", force: [0, -1] },
];

interface Drag {
  pointer: number;
  x: number;
  y: number;
  grip: Grip;
  force: Flat; // in the picture's world
}

export class PushTool {
  // To be put among the camera's buttons.
  readonly toggle: HTMLButtonElement;
  readonly form: HTMLElement;
  private readonly link: HTMLSelectElement;
  private readonly newtons: HTMLInputElement;
  private readonly label = element("p", { class: "push-label", role: "status", hidden: true });
  private drag: Drag | undefined;
  private shown = 0;

  constructor(
    private readonly context: Context,
    private readonly scene: Scene,
    private readonly canvas: HTMLCanvasElement,
    private readonly bounds: PushBounds,
    private readonly tools: PictureTools,
  ) {
    const { links } = context.description;
    this.link = element("select", { "aria-label": "Link that is pushed" }, ...links.map(({ name }) => element("option", {}, name)));
    this.newtons = element("input", {
      type: "number", "aria-label": "Force of a push in newtons", min: Math.ceil(bounds.least), max: bounds.most, step: 1, value: bounds.usual,
    });
    this.toggle = button("Push", () => (this.on ? this.tools.done(this) : this.setOn(true)), { "aria-pressed": "false", id: "push", title: "Push the robot: click or drag on a part of it" });
    this.form = element("div", { class: "push-form", role: "group", "aria-label": "Push the robot", hidden: true }, this.link, this.newtons, "N",
      ...directions.map(({ text, name, force }) => button(text, () => this.pushBy(force), { "aria-label": `Push ${name}`, title: `Push ${name}` })));
    canvas.after(this.label);
    // Before the camera takes them.
    const listen = (kind: "pointerdown" | "pointermove" | "pointerup" | "pointercancel", take: (event: PointerEvent) => void) =>
      canvas.addEventListener(kind, take, { capture: true });
    listen("pointerdown", (event) => this.begin(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.end(event));
    listen("pointercancel", () => this.cancel());
    canvas.addEventListener("pointerleave", () => (this.label.hidden = !this.drag));
    window.addEventListener("keydown", (event) => event.key === "Escape" && this.cancel(), { capture: true }); // a stop goes no further
  }

  get on(): boolean {
    return this.toggle.getAttribute("aria-pressed") === "true";
  }

  setOn(on: boolean): void {
    if (on === this.on) return;
    if (on) this.tools.choose(this);
    this.toggle.setAttribute("aria-pressed", String(on));
    this.form.hidden = !on;
    this.canvas.classList.toggle("pushes", on);
    if (on) return;
    this.cancel();
    this.label.hidden = true;
  }

  private begin(event: PointerEvent): void {
    if (this.drag) {
      this.cancel(); // a second finger: somebody turns or zooms
      return;
    }
    const grip = this.on && event.button === 0 ? this.scene.gripAt(event.clientX, event.clientY) : undefined;
    if (!grip) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.link.selectedIndex = grip.link;
    this.drag = { pointer: event.pointerId, x: event.clientX, y: event.clientY, grip, force: [0, 0] };
    this.move(event);
  }

  private move(event: PointerEvent): void {
    if (!this.drag) this.tellLink(event);
    if (event.pointerId !== this.drag?.pointer) return;
    event.stopImmediatePropagation();
    const { x, y, grip } = this.drag;
    this.drag.force = forceOfDrag(event.clientX - x, y - event.clientY, this.scene.away(), this.chosen_N, this.bounds);
    this.showArrow(grip, this.drag.force);
    this.tell(event, `${this.linkName(grip.link)}: ${sizeOf(this.drag.force).toFixed(0)} N`);
  }

  // Which one would be pushed: for a mouse that has not pressed yet.
  private tellLink(event: PointerEvent): void {
    const grip = this.on && event.buttons === 0 ? this.scene.gripAt(event.clientX, event.clientY) : undefined;
    this.label.hidden = !grip;
    if (grip) this.tell(event, this.linkName(grip.link));
  }

  private tell(event: PointerEvent, text: string): void {
    setText(this.label, text);
    const frame = this.canvas.getBoundingClientRect();
    this.label.style.setProperty("--x", `${event.clientX - frame.left}px`);
    this.label.style.setProperty("--y", `${event.clientY - frame.top}px`);
    this.label.hidden = false;
  }

  private end(event: PointerEvent): void {
    if (event.pointerId !== this.drag?.pointer) return;
    event.stopImmediatePropagation();
    const { grip, force } = this.drag;
    this.drag = undefined;
    this.label.hidden = true;
    this.push(grip, inHeading(force, this.heading()));
  }

  private cancel(): void {
    if (!this.drag) return;
    this.drag = undefined;
    this.label.hidden = true;
    this.scene.hidePush();
  }

  private pushBy([ahead, left]: Flat): void {
    const size_N = this.chosen_N;
    this.push(this.scene.gripOn(this.link.selectedIndex), [ahead * size_N, left * size_N]);
  }

  // `force`: in the robot's heading.
  private push(grip: Grip | undefined, force: Flat): void {
    if (!grip) return;
    this.showArrow(grip, inHeading(force, -this.heading()));
    const shown = this.shown;
    setTimeout(() => shown === this.shown && this.scene.hidePush(), shown_ms);
    const name = this.linkName(grip.link);
    void this.context.attempt(`Push of ${name}, ${sizeOf(force).toFixed(0)} N for ${push_s} s`, () =>
      this.context.robot.order("/simulation/push", pushRequest(name, force)));
  }

  private showArrow(grip: Grip, force: Flat): void {
    this.shown += 1;
    this.scene.showPush(grip, force);
  }

  // What is not a number, or too much, counts as what it would be at most or least.
  private get chosen_N(): number {
    const { least, most, usual } = this.bounds;
    return Math.min(Math.max(Number(this.newtons.value) || usual, least), most);
  }
  private heading(): number {
    const { x, y, z, w } = this.scene.body.base.quaternion;
    return heading_rad([x, y, z, w]);
  }
  private linkName(link: number): string {
    return this.context.description.links[link]?.name ?? "";
  }
}
