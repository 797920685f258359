// The robot's calibration in the State view: folded up, fetched when it is first opened.
import { gainText, loadCalibration, offsetText, rollPitchYaw, summaryText, zeroText, type Calibration } from "../calibration.ts";
import type { Context } from "../context.ts";
import { element, table } from "../dom.ts";

const cells = ["front left", "front right", "rear left", "rear right"];
const heading = (text: string) => element("th", { scope: "row" }, text);
const number = (text: string) => element("td", { class: "number" }, text);

function jointZeros({ joints }: Calibration): HTMLElement {
  const { table: made, body } = table("Joint zeros: what an encoder says where its joint is at 0", "joint", "zero, °", "trim channel");
  made.classList.add("zeros");
  for (const { name, zero, trim_channel } of joints) {
    body.append(element("tr", {}, heading(name.replaceAll("_", " ")), number(zeroText(zero)), number(trim_channel === null ? "–" : String(trim_channel))));
  }
  return made;
}

function cellGains({ feet }: Calibration): HTMLElement {
  if (feet.every(({ sensor }) => sensor !== "cells")) return element("p", { class: "hint" }, "Its feet have no force cells.");
  const { table: made, body } = table("Force cells: reading over force; each is taken to read 0 N without load", "cell", "left", "right");
  made.classList.add("gains");
  for (const [index, cell] of cells.entries()) {
    body.append(element("tr", {}, heading(cell), ...feet.map(({ gain, sensor }) => number(sensor === "cells" ? gainText(gain, index) : "–"))));
  }
  return made;
}

function trunkAndImu({ trunk_com_offset, imu }: Calibration): HTMLElement {
  const { table: made, body } = table(`Trunk and IMU (in ${imu.link})`, "axis", "centre of mass off by, mm", "IMU turned by, °");
  made.classList.add("trunk");
  const turns = rollPitchYaw(imu.turn);
  for (const [axis, name] of ["x, roll", "y, pitch", "z, yaw"].entries()) {
    body.append(element("tr", {}, heading(name), number(offsetText(trunk_com_offset, axis)), number((turns[axis] ?? NaN).toFixed(2))));
  }
  return made;
}

export function calibrationTable({ token, news }: Context): HTMLElement {
  const content = element("div");
  const box = element("details", { class: "calibration" }, element("summary", {}, "Calibration"), content);
  let asked = false;
  box.addEventListener("toggle", () => {
    if (!box.open || asked) return;
    asked = true;
    loadCalibration(token()).then(
      (calibration) => content.replaceChildren(element("p", {}, summaryText(calibration)), jointZeros(calibration), cellGains(calibration), trunkAndImu(calibration)),
      (error: Error) => {
        asked = false; // the next time it is opened
        box.open = false;
        news.say(`The calibration does not come: ${error.message}`, "bad");
      });
  });
  return box;
}
