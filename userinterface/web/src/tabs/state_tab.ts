// Batches, ages, what the page lost, the bus and a time slot of it, and each joint.
import { BusPicture } from "../bus_picture.ts";
import { loadBus, type BusSlot } from "../bus_slot.ts";
import type { Context, Tab } from "../context.ts";
import { element, setText, table } from "../dom.ts";
import { Facts } from "../facts.ts";
import { ageText, oldAfter_ms } from "../freshness.ts";
import type { Message } from "../rosbridge.ts";
import type { Scene } from "../scene/scene.ts";
import { ageNames, hasTrouble } from "../view_decoder.ts";
import { calibrationTable } from "./calibration_table.ts";

interface JointCells {
  row: HTMLTableRowElement;
  position: HTMLTableCellElement;
  torque: HTMLTableCellElement;
  faults: HTMLTableCellElement;
}

function jointTable(context: Context): { table: HTMLTableElement; joints: JointCells[] } {
  const { table: made, body } = table("Joints", "joint", "position, °", "torque, N·m", "faults");
  made.classList.add("joints");
  const joints = context.description.joints.map(({ name }) => {
    const [position, torque] = [element("td", { class: "number" }), element("td", { class: "number" })];
    const faults = element("td");
    const row = element("tr", {}, element("th", { scope: "row" }, name.replaceAll("_", " ")), position, torque, faults);
    body.append(row);
    return { row, position, torque, faults };
  });
  return { table: made, joints };
}

type Status = { name: string; message: string; level: number; values: { key: string; value: string }[] };

function showFrame({ freshness }: Context, scene: Scene, now_ms: number, batches: Facts, ages: Facts): void {
  const frame = freshness.newest;
  if (!frame) return;
  batches.set("late", String(frame.batches_late[0]), (frame.batches_late[0] ?? 0) > 0);
  batches.set("refused", String(frame.batches_refused[0]), (frame.batches_refused[0] ?? 0) > 0);
  batches.set("cycles from a safe tail", String(frame.tails_played[0]));
  batches.set("robot's clock", `${(frame.robot_time[0] ?? 0).toFixed(1)} s`);
  for (const [part, name] of ageNames.entries()) {
    const age_ms = freshness.age_ms(part, now_ms);
    ages.set(name, ageText(age_ms), part !== 3 && age_ms > oldAfter_ms);
  }
  ages.set("way there and back", Number.isNaN(frame.round_trip[0]) ? "–" : ageText((frame.round_trip[0] ?? 0) * 1000));
  const { frames, outages, longest_ms } = freshness.loss;
  ages.set("lost by this page", `${frames} frames, ${outages} outages${outages > 0 ? `, the longest ${ageText(longest_ms)}` : ""}`, outages > 0);
  ages.set("pictures", `${scene.pace.perSecond} /s, ${scene.pace.total} in all`);
}

// The bus's picture: what it is to be held against is fetched when it is first looked at.
function busSlot(context: Context): { content: HTMLElement; show: () => () => void; look: (now_ms: number) => void } {
  const { robot, freshness, description } = context;
  const content = element("div", {}, element("p", { class: "note" }, "The robot is asked what its bus is meant to carry."));
  let picture: BusPicture | undefined;
  let loading: Promise<void> | undefined;
  const load = async () => {
    try {
      picture = new BusPicture(await loadBus(context.token()), description.joints.map(({ name }) => name.replaceAll("_", " ")));
      content.replaceChildren(picture.content);
    } catch (error) {
      content.replaceChildren(element("p", { class: "note bad" }, `What the bus is meant to carry does not come: ${(error as Error).message}`));
      loading = undefined; // once more when it is shown again
    }
  };
  return {
    content,
    show: () => {
      let [shown, end] = [true, () => {}];
      loading ??= load();
      void loading.then(() => {
        if (picture && shown) end = robot.subscribe("/bus_slot", "gaitway_msgs/msg/BusSlot", 0, (message) => picture?.take(message as unknown as BusSlot));
      });
      return () => {
        shown = false;
        end();
      };
    },
    look: (now_ms) => picture?.look((freshness.newest?.robot_time[0] ?? NaN) * 1000 + freshness.age_ms(4, now_ms), freshness.state(now_ms) === "live"),
  };
}

export function stateTab(context: Context, scene: Scene): Tab {
  const { robot, freshness, description } = context;
  const [batches, ages, bus] = [new Facts(), new Facts(), new Facts()];
  const slot = busSlot(context);
  const { table: jointsTable, joints } = jointTable(context);
  const content = element("div", { class: "state" },
    element("h2", {}, "Batches"), batches.list, element("h2", {}, "Age of what is shown"), ages.list, element("h2", {}, "Bus"), bus.list,
    element("h2", {}, "A time slot on the bus"), slot.content, jointsTable, calibrationTable(context));
  let faults = new Map<string, string>();
  let endings: (() => void)[] = [];

  const takeJoints = (message: Message) => {
    for (const [index, torque] of (message["effort"] as number[]).entries()) {
      const share = Math.abs(torque) / (description.joints[index]?.torque ?? Infinity);
      const cell = joints[index]?.torque;
      if (!cell) continue;
      setText(cell, torque.toFixed(2));
      cell.classList.toggle("bad", share > 0.95);
    }
  };
  const takeDiagnostics = (message: Message) => {
    const statuses = message["status"] as Status[];
    faults = new Map(statuses.find(({ name }) => name === "nodes")?.values.map(({ key, value }) => [key, value]));
    const { message: text = "", level = 0, values = [] } = statuses.find(({ name }) => name === "bus") ?? {};
    bus.set("state", text, level > 0);
    for (const { key, value } of values) if (value !== "0" || key.endsWith("_errors")) bus.set(key.replaceAll("_", " "), value);
  };
  return {
    title: "State",
    content,
    show: () => {
      endings = [robot.subscribe("/joint_states", "sensor_msgs/msg/JointState", 250, takeJoints),
        robot.subscribe("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", 0, takeDiagnostics), slot.show()];
    },
    hide: () => endings.forEach((end) => end()),
    look: (now_ms) => {
      showFrame(context, scene, now_ms, batches, ages);
      slot.look(now_ms);
      for (const [index, joint] of joints.entries()) {
        const angle_rad = freshness.newest?.joint[index];
        setText(joint.position, angle_rad === undefined ? "–" : ((angle_rad * 180) / Math.PI).toFixed(1));
        const trouble = freshness.newest !== undefined && hasTrouble(freshness.newest, index);
        setText(joint.faults, trouble ? (faults.get(description.joints[index]?.name ?? "") ?? "fault") : "");
        joint.row.classList.toggle("bad", trouble);
      }
    },
  };
}
