// The time line: what has been simulated, with marks of what happened; a click, a drag or the arrow keys go to any instant of it.
import { element, setText } from "../dom.ts";
import type { SimulationState } from "./simulation_state.ts";
import { forgottenText, instantAt, lineEnd_s, markText, placeMarks, shareOf, tickEvery_s, timeText } from "./time_line.ts";

const keySteps_s: Record<string, number> = { ArrowLeft: -0.1, ArrowRight: 0.1, PageDown: -1, PageUp: 1 };
const markEvery_px = 5;

export class TimeLineBar {
  readonly box: HTMLElement;
  private readonly line: HTMLElement;
  private readonly ticks = element("div", { class: "ticks" });
  private readonly marks = element("div", { class: "marks" });
  private readonly bubble = element("span", { class: "bubble", hidden: true });
  private state: SimulationState | undefined;
  private pointer: number | undefined;
  private dragged_s: number | undefined;
  private drawnMarks = "";
  private drawnTicks = "";

  // `seek`: goes to the instant; `target`: where it is on its way to.
  constructor(
    private readonly seek: (time_s: number) => void,
    private readonly target: () => number | undefined,
  ) {
    this.line = element("div", { class: "time-line", id: "time-line", role: "slider", tabindex: 0, "aria-label": "Time line", "aria-valuemin": 0, title: "Click or drag: go to this instant. Arrows: 0.1 s, with Shift 1 s" },
      element("div", { class: "future" }), element("div", { class: "past" }), this.ticks, this.marks, element("div", { class: "head" }), this.bubble);
    this.box = element("div", { class: "time-line-box" }, this.line);
    this.line.addEventListener("pointerdown", (event) => this.begin(event));
    this.line.addEventListener("pointermove", (event) => this.move(event));
    this.line.addEventListener("pointerup", (event) => this.end(event));
    this.line.addEventListener("pointercancel", () => this.end());
    this.line.addEventListener("pointerleave", () => (this.bubble.hidden = this.pointer === undefined));
    this.line.addEventListener("keydown", (event) => this.key(event));
  }

  show(state: SimulationState): void {
    this.state = state;
    const end_s = lineEnd_s(state);
    const time_s = this.dragged_s ?? this.target() ?? state.time_s;
    this.line.style.setProperty("--now", String(shareOf(time_s, end_s)));
    this.line.style.setProperty("--recorded", String(shareOf(state.recorded_s, end_s)));
    this.line.classList.toggle("forgets", state.state !== "playing" && forgottenText(time_s, state.recorded_s) !== "");
    this.line.setAttribute("aria-valuemax", state.recorded_s.toFixed(3));
    this.line.setAttribute("aria-valuenow", time_s.toFixed(3));
    this.line.setAttribute("aria-valuetext", `${timeText(time_s)} of ${timeText(state.recorded_s)}`);
    this.showMarks(state, end_s);
    this.showTicks(end_s);
  }

  // Where a person's hand, or the simulator, is going.
  get time_s(): number | undefined {
    return this.dragged_s ?? this.target();
  }

  private showMarks(state: SimulationState, end_s: number): void {
    const width_px = Math.max(this.line.clientWidth, 100);
    const placed = placeMarks(state.marks, end_s, markEvery_px / width_px);
    const drawn = placed.map(({ share, kind, count }) => `${kind}${Math.round(share * width_px)}x${count}`).join();
    if (drawn === this.drawnMarks) return;
    this.drawnMarks = drawn;
    this.marks.replaceChildren(...placed.map((mark) => {
      const event = state.events.find(({ at_s }) => Math.abs(at_s - mark.at_s) < 0.0015);
      const made = element("i", { class: mark.kind, title: markText(mark) + (event && mark.count === 1 ? `: ${event.text}` : "") });
      made.style.setProperty("--at", String(mark.share));
      return made;
    }));
  }

  private showTicks(end_s: number): void {
    const every_s = tickEvery_s(end_s);
    const count = Math.floor(end_s / every_s + 1e-9);
    const drawn = `${every_s}x${count}/${Math.round(this.line.clientWidth)}`;
    for (const tick of this.ticks.children) (tick as HTMLElement).style.setProperty("--at", String((Number((tick as HTMLElement).dataset["s"]) / end_s)));
    if (drawn === this.drawnTicks) return;
    this.drawnTicks = drawn;
    this.ticks.replaceChildren(...Array.from({ length: count + 1 }, (_none, index) => {
      const at_s = index * every_s;
      const made = element("b", { "data-s": at_s }, every_s < 1 ? at_s.toFixed(1) : at_s.toFixed(0));
      made.style.setProperty("--at", String(at_s / end_s));
      return made;
    }));
  }

  private instant(event: PointerEvent): number {
    const { left, width } = this.line.getBoundingClientRect();
    return this.state ? instantAt((event.clientX - left) / width, this.state) : 0;
  }

  private begin(event: PointerEvent): void {
    if (event.button !== 0 || !this.state) return;
    this.pointer = event.pointerId;
    this.line.setPointerCapture(event.pointerId);
    this.go(event);
  }
  private move(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.go(event);
    else if (event.buttons === 0) this.tell(event);
  }
  private end(event?: PointerEvent): void {
    if (event && event.pointerId !== this.pointer) return;
    this.pointer = undefined;
    this.dragged_s = undefined;
    if (event?.pointerType !== "mouse") this.bubble.hidden = true;
  }

  private go(event: PointerEvent): void {
    this.tell(event);
    const time_s = this.instant(event);
    if (time_s === this.dragged_s) return;
    this.dragged_s = time_s;
    this.seek(time_s);
    if (this.state) this.show(this.state);
  }

  private tell(event: PointerEvent): void {
    if (!this.state) return;
    const time_s = this.instant(event);
    setText(this.bubble, timeText(time_s));
    this.bubble.style.setProperty("--at", String(shareOf(time_s, lineEnd_s(this.state))));
    this.bubble.hidden = false;
  }

  private key(event: KeyboardEvent): void {
    const step_s = keySteps_s[event.key];
    const ends: Record<string, number> = { Home: 0, End: this.state?.recorded_s ?? 0 };
    if (!this.state || (step_s === undefined && ends[event.key] === undefined)) return;
    event.preventDefault();
    event.stopPropagation(); // the arrows drive elsewhere
    const from_s = this.time_s ?? this.state.time_s;
    const to_s = step_s === undefined ? (ends[event.key] ?? 0) : from_s + step_s * (event.shiftKey ? 10 : 1);
    this.seek(instantAt(to_s / lineEnd_s(this.state), this.state));
    this.show(this.state);
  }
}
