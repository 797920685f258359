// The top line: which robot, how fresh what is shown is, what it does, who commands it.
import type { Context } from "./context.ts";
import { byId, setText } from "./dom.ts";
import { ageText, oldAfter_ms } from "./freshness.ts";
import { activities, ageNames, commanderOf, modes, modeTexts, type ViewFrame } from "./view_decoder.ts";

export const nobodyCommands = "nobody commands";

export class StatusBar {
  private readonly lamp = byId("link");
  private readonly lampText = byId("link-text");
  private readonly activity = byId("activity");
  private readonly commander = byId("commander");
  private readonly old = byId("old");
  private readonly take = byId<HTMLButtonElement>("take");
  private readonly give = byId<HTMLButtonElement>("give");
  private readonly canvas = byId("scene");

  constructor(private readonly context: Context) {
    const { attempt, command } = context;
    setText(byId("robot-name"), context.description.name);
    document.title = `${context.description.name} – Gaitway`;
    this.take.addEventListener("click", () => void attempt("Take the command", () => command.take()));
    this.give.addEventListener("click", () => void attempt("Give the command back", () => command.giveBack()));
  }

  look(now_ms: number): void {
    const { freshness } = this.context;
    const state = freshness.state(now_ms);
    this.lamp.className = `lamp ${state}`;
    setText(this.lampText, this.linkText(now_ms));
    this.old.hidden = state === "live";
    if (state !== "live") setText(this.old, this.oldText(now_ms));
    const frame = state === "lost" ? undefined : freshness.newest; // what was is not what is
    if (frame) this.showFrame(frame);
    else this.showNothing();
    this.showCommand(frame);
  }

  private linkText(now_ms: number): string {
    const { freshness } = this.context;
    const age = ageText(freshness.pictureAge_ms(now_ms));
    if (freshness.state(now_ms) === "live") return freshness.rests ? "paused" : `live, ${age}`;
    return freshness.state(now_ms) === "old" ? `old, ${age}` : "no connection";
  }

  private oldText(now_ms: number): string {
    const { freshness } = this.context;
    if (!freshness.newest) return "Nothing has come from the robot yet.";
    if (freshness.state(now_ms) === "lost") return `Connection lost: the picture is ${ageText(freshness.sinceCame_ms(now_ms))} old. Trying again…`;
    const late = ageNames.filter((_name, part) => part !== 3 && freshness.age_ms(part, now_ms) > oldAfter_ms);
    return `Old, ${ageText(freshness.pictureAge_ms(now_ms))}: ${late.join(", ")}.`;
  }

  private showNothing(): void {
    setText(this.activity, "");
    this.activity.classList.remove("alarm", "caution");
    this.canvas.setAttribute("aria-label", "The robot, as it was last seen");
  }

  private showFrame(frame: ViewFrame): void {
    const mode = frame.mode[0] ?? NaN;
    const activity = activities[frame.activity[0] ?? 0] ?? "";
    const text = mode === modes.batches ? activity : `${modeTexts[mode] ?? "state not known"}, ${activity}`;
    setText(this.activity, text);
    this.activity.classList.toggle("alarm", mode === modes.emergencyStop || (frame.activity[0] ?? 0) >= 4);
    this.activity.classList.toggle("caution", mode === modes.safeTail);
    const speed = Math.hypot(frame.velocity[0] ?? 0, frame.velocity[1] ?? 0);
    this.canvas.setAttribute("aria-label", `The robot ${text}${speed > 0.03 ? `, ${speed.toFixed(1)} m/s` : ""}`);
  }

  private showCommand(frame: ViewFrame | undefined): void {
    const { command, robot } = this.context;
    const name = frame ? commanderOf(frame) : "";
    const byOther = !command.mine && name !== "";
    setText(this.commander, command.mine ? "you command" : byOther ? `${name} commands` : frame ? nobodyCommands : "");
    this.commander.classList.toggle("mine", command.mine);
    this.take.hidden = command.mine;
    this.take.disabled = byOther || !robot.isOpen;
    this.give.hidden = !command.mine;
  }
}
