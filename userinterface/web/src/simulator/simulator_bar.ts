// The bar of the simulator: play and pause, single steps, speed, reset, the time line, and what it is doing.
import type { Context } from "../context.ts";
import { button, element, isTyping, setText } from "../dom.ts";
import { askToReset } from "./reset_dialog.ts";
import { Seeker } from "./seeker.ts";
import type { SimulationOrders } from "./simulation_orders.ts";
import type { SimulationState } from "./simulation_state.ts";
import { forgottenText, timeText } from "./time_line.ts";
import { TimeLineBar } from "./time_line_bar.ts";

const speeds = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 40];
const steps_ms = [1, 10, 80]; // the servo's, a time slot, a cycle

// What the simulator has to say while nothing else is to be said.
const sentence = (text: string) => (text === "" ? "" : `${text[0]!.toUpperCase()}${text.slice(1)}.`);

export class SimulatorBar {
  readonly box: HTMLElement;
  private readonly playButton: HTMLButtonElement;
  private readonly stepButtons: HTMLButtonElement[];
  private readonly speed: HTMLSelectElement;
  private readonly pace = element("span", { class: "pace", title: "How fast it is, measured" });
  private readonly clock = element("output", { class: "clock", id: "simulator-time", title: "Simulated time" });
  private readonly recorded = element("span", { class: "recorded", title: "What has been simulated" });
  private readonly note = element("p", { class: "simulator-note", id: "simulator-note", role: "status" });
  private readonly timeLine: TimeLineBar;
  private readonly seeker: Seeker;
  private step_ms = 10; // of the key
  private state: SimulationState | undefined;
  private silent = false;

  // `menus`: buttons of what else there is to do.
  constructor(
    private readonly context: Context,
    private readonly orders: SimulationOrders,
    menus: readonly HTMLButtonElement[],
  ) {
    this.seeker = new Seeker((time_s) => this.leaveNow(() => orders.seek(time_s)), (error) => context.news.say(`Going to an instant: ${error.message}`, "bad", "seek"));
    this.timeLine = new TimeLineBar((time_s) => void this.seeker.to(time_s), () => this.seeker.target_s);
    this.playButton = button("", () => this.playOrPause(), { id: "play", class: "play", "aria-keyshortcuts": "Space" });
    this.stepButtons = steps_ms.map((step_ms) => button(String(step_ms), () => this.step(step_ms), { id: `step-${step_ms}`, "aria-label": `One step of ${step_ms} ms` }));
    this.speed = element("select", { id: "speed", "aria-label": "Speed, in times real time", title: "Speed, in times real time" }, ...speeds.map((times) => this.speedOption(times)));
    this.speed.addEventListener("change", () => {
      this.setSpeed(Number(this.speed.value));
      this.speed.blur(); // keys are for the page again
    });
    const reset = button("Reset", () => void this.reset(), { id: "reset", title: "Back to 0 s; what is recorded is forgotten" });
    this.box = element("section", { id: "simulator", class: "simulator", "aria-label": "Simulator" },
      element("div", { class: "simulator-row" }, this.playButton,
        element("span", { class: "steps", role: "group", "aria-label": "Single steps" }, element("small", {}, "Step"), ...this.stepButtons, element("small", {}, "ms")),
        element("span", { class: "speed" }, this.speed, this.pace),
        element("span", { class: "clocks" }, this.clock, this.recorded),
        element("span", { class: "menus" }, ...menus, reset)),
      this.timeLine.box, this.note);
    this.nameSteps();
    document.addEventListener("keydown", (event) => this.key(event));
  }

  show(state: SimulationState): void {
    this.state = state;
    this.seeker.told(state.time_s);
    const plays = state.state === "playing";
    const words = plays ? "Pause (Space)" : "Play (Space)";
    this.playButton.classList.toggle("plays", plays);
    this.playButton.title = words;
    this.playButton.setAttribute("aria-label", words);
    this.showSpeed(state);
    const time_s = this.timeLine.time_s ?? state.time_s;
    setText(this.clock, timeText(time_s));
    setText(this.recorded, `of ${timeText(state.recorded_s)}`);
    this.timeLine.show(state);
    this.tell(state, time_s);
  }

  // Nothing comes from it any more.
  setSilent(silent: boolean): void {
    if (silent === this.silent) return;
    this.silent = silent;
    this.box.classList.toggle("silent", silent);
    if (this.state) this.tell(this.state, this.state.time_s);
  }

  private tell(state: SimulationState, time_s: number): void {
    const forgotten = state.state === "playing" ? "" : forgottenText(time_s, state.recorded_s);
    const words = this.silent ? "The simulator does not answer." : state.state === "failed" ? `The simulator has failed: ${state.text || "it does not say why"}` :
      state.state === "busy" ? `Busy: ${state.text || "…"}` : this.seeker.isGoing && this.seeker.target_s !== undefined ? `Going to ${timeText(this.seeker.target_s)}…` :
      state.fallen ? `The robot has fallen. ${forgotten || "Drag the time line back to before, or reset."}` : forgotten || sentence(state.text);
    setText(this.note, words);
    this.note.className = `simulator-note${this.silent || state.state === "failed" ? " bad" : state.state === "busy" ? " busy" : state.fallen ? " caution" : ""}`;
  }

  private playOrPause(): void {
    const plays = this.state?.state === "playing";
    void this.quietly(plays ? "Pause" : "Play", () => (plays ? this.orders.pause() : this.orders.play()));
  }

  private step(step_ms: number): void {
    this.step_ms = step_ms;
    this.nameSteps();
    void this.quietly(`Step of ${step_ms} ms`, async () => {
      if (this.state?.state === "playing") await this.orders.pause();
      await this.orders.step(step_ms);
    });
  }
  private nameSteps(): void {
    for (const [index, step_ms] of steps_ms.entries()) {
      const key = step_ms === this.step_ms ? " (.)" : "";
      this.stepButtons[index]!.title = `One step of ${step_ms} ms${key}`;
    }
  }

  private setSpeed(times: number): void {
    void this.quietly(`Speed ${times}`, () => this.orders.setSpeed(times));
  }
  private showSpeed({ state, speed, pace }: SimulationState): void {
    if (document.activeElement !== this.speed && Number(this.speed.value) !== speed) {
      if (![...this.speed.options].some((option) => Number(option.value) === speed)) this.speed.append(this.speedOption(speed)); // another client's
      this.speed.value = String(speed);
    }
    const measured = state === "playing" && Number.isFinite(pace);
    setText(this.pace, measured ? `is ${pace.toFixed(pace < 9.95 ? 2 : 1)}` : "");
    this.pace.classList.toggle("bad", measured && pace < 0.8 * speed);
  }
  private speedOption(times: number): HTMLOptionElement {
    return element("option", { value: times }, `${times} ×`);
  }

  private async reset(): Promise<void> {
    if (await askToReset(this.state?.recorded_s ?? 0)) await this.context.attempt("Reset", () => this.leaveNow(() => this.orders.reset()));
  }
  // The robot of another instant is commanded by nobody: whoever goes there gives the command back before it is lost.
  private async leaveNow(go: () => Promise<void>): Promise<void> {
    const { command } = this.context;
    if (command.mine) await command.giveBack().catch(() => {}); // then it ends with the instant
    await go();
  }

  // What is done is seen: only what was refused is said.
  private async quietly(what: string, order: () => Promise<void>): Promise<void> {
    try {
      await order();
    } catch (error) {
      this.context.news.say(`${what}: ${(error as Error).message}`, "bad", what);
    }
  }

  private key(event: KeyboardEvent): void {
    if (this.silent || !this.state || isTyping(event.target) || event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]")) return;
    if (event.code === "Space" && !event.repeat) this.playOrPause();
    else if (event.key === ".") this.step(this.step_ms);
    else if (event.code !== "Space") return;
    event.preventDefault();
  }
}
