// Stop and emergency stop: in the same place on every view, and on Escape and Space wherever the focus is.
import type { Context } from "./context.ts";
import { byId, isTyping, setText } from "./dom.ts";
import { modes, type ViewFrame } from "./view_decoder.ts";

// As soon as the button is touched: a second finger, while the first one holds a stick, brings no click. Keys and assistive
// technology bring a click alone; to stop twice, where both come, does no harm.
function whenTouched(button: HTMLButtonElement, press: () => void): void {
  button.addEventListener("pointerdown", (event) => event.button === 0 && press());
  button.addEventListener("click", press);
}

// A robot that the stops of this one are for, too, while it is wanted.
export interface OtherRobot {
  readonly isToStop: () => boolean;
  readonly stop: () => void;
}

export class StopBar {
  other: OtherRobot | undefined;
  private readonly stopButton = byId<HTMLButtonElement>("stop");
  private readonly emergencyButton = byId<HTMLButtonElement>("emergency");
  private readonly releaseButton = byId<HTMLButtonElement>("release");
  private readonly keys = this.stopButton.querySelector("small");
  private spaceStops = true;

  // `ended`: whatever was being driven is ended before the stop is sent.
  constructor(
    private readonly context: Context,
    private readonly ended: () => void,
  ) {
    whenTouched(this.stopButton, () => this.stop());
    whenTouched(this.emergencyButton, () => this.emergencyStop());
    this.releaseButton.addEventListener("click", () => this.release());
    document.addEventListener("keydown", (event) => this.key(event), { capture: true });
    // A button is pressed when Space is let go.
    document.addEventListener("keyup", (event) => event.code === "Space" && !isTyping(event.target) && event.preventDefault(), { capture: true });
  }

  stop(): void {
    this.stopOther();
    this.ended();
    this.tellIfPaused();
    void this.context.attempt("Stop", () => this.context.robot.stop("/stop"));
  }

  // A simulator's page has another use for Space.
  setSpaceStops(stops: boolean): void {
    if (stops === this.spaceStops) return;
    this.spaceStops = stops;
    this.stopButton.setAttribute("aria-keyshortcuts", stops ? "Escape Space" : "Escape");
    if (this.keys) setText(this.keys, stops ? "Esc, Space" : "Esc");
  }

  show(frame: ViewFrame): void {
    const stopped = frame.mode[0] === modes.emergencyStop;
    this.releaseButton.hidden = !stopped;
    this.emergencyButton.setAttribute("aria-pressed", String(stopped));
  }

  // Whether a stop now is for another robot, too.
  get stopsOther(): boolean {
    return this.other?.isToStop() ?? false;
  }
  private stopOther(): void {
    if (this.stopsOther) this.other?.stop();
  }

  // A simulated robot whose time rests obeys when it goes on.
  private tellIfPaused(): void {
    if (this.context.freshness.pace === 0) this.context.news.say("The simulation is paused: the robot stops as soon as it plays on.", "plain", "stop while paused");
  }

  private emergencyStop(): void {
    this.stopOther();
    this.ended();
    this.tellIfPaused();
    void this.context.attempt("Emergency stop", () => this.context.robot.stop("/emergency_stop", { data: false }));
  }

  private release(): void {
    const { attempt, command, robot } = this.context;
    void attempt("Release", async () => {
      if (!command.mine) await command.take();
      await robot.order("/release");
    });
  }

  private key(event: KeyboardEvent): void {
    const stops = event.code === "Escape" || (this.spaceStops && event.code === "Space" && !isTyping(event.target));
    if (!stops || event.repeat) {
      if (stops) event.preventDefault();
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    this.stop();
  }
}
