// Sticks, speeds and motions.
import type { Context, Tab } from "../context.ts";
import { button, element, setText } from "../dom.ts";
import type { DriveState } from "../drive.ts";
import type { Driver } from "../driver.ts";
import { lies, modes, type ViewFrame } from "../view_decoder.ts";
import { motionButtons } from "./motion_buttons.ts";

const signed = (value: number) => (Number.isNaN(value) ? "–" : `${value < -0.005 ? "−" : ""}${Math.abs(value).toFixed(2)}`);

function speedTable(): { table: HTMLTableElement; cells: HTMLTableCellElement[][] } {
  const cells: HTMLTableCellElement[][] = [];
  const rows = ["forward, m/s", "left, m/s", "turn, rad/s"].map((name) => {
    const values = [0, 1, 2].map(() => element("td", { class: "number" }));
    cells.push(values);
    return element("tr", {}, element("th", { scope: "row" }, name), ...values);
  });
  const head = element("tr", {}, element("td"), ...["asked", "is", "at most"].map((name) => element("th", { scope: "col" }, name)));
  const table = element("table", { class: "speeds" }, element("caption", { class: "hidden" }, "Speeds"), element("thead", {}, head), element("tbody", {}, ...rows));
  return { table, cells };
}

const states = {
  rests: "Hold the stick, or W A S D: the robot walks while you hold it.",
  waits: "Asking for the command…",
  drives: "Driving. Let go, and it stands.",
  blocked: "Ended. Let go of the stick first.",
} as const;

// Of what the robot does, where it goes before whatever is held.
function hintOf(state: DriveState, frame: ViewFrame | undefined, motions: readonly string[], rests: boolean): string {
  if (rests) return "The simulator is paused: the robot moves once it plays.";
  if (frame?.mode[0] === modes.emergencyStop) return "The emergency stop holds the robot: it walks once that is released.";
  if (frame?.activity[0] !== lies) return states[state];
  const rise = motions.filter((motion) => motion.startsWith("get_up")).map((motion) => `“${motion.replaceAll("_", " ")}”`);
  return `The robot lies, and walks nowhere. ${rise.length > 0 ? `Below are ${rise.join(" and ")}: the side that it lies on decides.` : "Lift it up."}`;
}

export function driveTab(context: Context, driver: Driver): Tab {
  const { attempt, command, robot, freshness, drive } = context;
  const { table, cells } = speedTable();
  const hint = element("p", { class: "hint", role: "status" });
  const commanded = (what: string, order: () => Promise<unknown>, done?: string) => () =>
    void attempt(what, async () => {
      if (!command.mine) await command.take();
      await order();
    }, done);
  const stand = button("Stand", commanded("Stand", () => robot.order("/stand", {}, 15_000)));
  const leave = button("Leave the motion", commanded("Leave the motion", () => robot.order("/play_motion", { motion: "" })));
  const motions = motionButtons(context, (motion) => commanded(`Motion ${motion}`, () => robot.order("/play_motion", { motion }, 15_000), "begun")(), leave);
  const progress = element("p", { class: "hint", role: "status" });
  const content = element("div", { class: "drive" },
    element("div", { class: "sticks" }, driver.walk.field, element("div", { class: "beside" }, driver.side.field, hint, stand)),
    table,
    element("h2", {}, "Motions"),
    motions.group,
    progress);
  robot.subscribe("/motion_state", "gaitway_msgs/msg/MotionState", 200, (message) => {
    const plays = message["state"] !== "none";
    leave.disabled = !plays;
    const part = plays ? `${message["motion"]}: ${message["state"]}, ${Number(message["time"]).toFixed(1)} of ${Number(message["duration"]).toFixed(1)} s` : "";
    setText(progress, part || (message["result"] === "none" ? "" : `${message["motion"]}: ${message["result"]}`));
  });
  return {
    title: "Drive",
    content,
    hide: motions.hide,
    look: () => {
      setText(hint, hintOf(drive.state, freshness.newest, context.description.motions, freshness.rests));
      const { forward, left, turn } = driver.sent;
      const is = freshness.newest?.velocity ?? [];
      const { bounds } = driver;
      const most = [`${signed(-bounds.backward)} … ${signed(bounds.forward)}`, `± ${signed(bounds.left)}`, `± ${signed(bounds.turn)}`];
      for (const [index, asked] of [forward, left, turn].entries()) {
        const values = [signed(asked), signed(is[index] ?? NaN), most[index] ?? ""];
        for (const [at, cell] of (cells[index] ?? []).entries()) setText(cell, values[at] ?? "");
      }
    },
  };
}
