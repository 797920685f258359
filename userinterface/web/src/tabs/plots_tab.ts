// Plots over time of what the view brings; they can be held and zoomed.
import uPlot from "uplot";
import type { Context, Tab } from "../context.ts";
import { button, element } from "../dom.ts";
import type { ViewFrame } from "../view_decoder.ts";
import { History, type Curve } from "./history.ts";

interface Plot {
  title: string;
  curves: Curve[];
}

const redraw_ms = 200;
const spans_s = [10, 30, 120];
const colours = ["#2f7fd6", "#d9822b", "#2ba06a", "#b04fc4"];

function plotsOf({ description }: Context): Plot[] {
  const one = (row: keyof ViewFrame, index: number, name: string): Curve => ({ name, value: (frame) => frame[row][index] });
  const degrees = (joint: number): Curve => ({ name: "°", value: (frame) => ((frame.joint[joint] ?? NaN) * 180) / Math.PI });
  return [
    { title: "Speed, m/s and rad/s", curves: [one("velocity", 0, "forward"), one("velocity", 1, "left"), one("velocity", 2, "turn")] },
    { title: "Load on the feet, N", curves: [one("foot_force", 0, "left"), one("foot_force", 1, "right")] },
    { title: "ZMP along x, m from the base", curves: [one("zmp", 0, "measured"), one("planned_zmp", 0, "planned"), one("com", 0, "CoM")] },
    { title: "ZMP along y, m from the base", curves: [one("zmp", 1, "measured"), one("planned_zmp", 1, "planned"), one("com", 1, "CoM")] },
    { title: "Height, m", curves: [one("base_height", 0, "base"), one("com", 2, "CoM")] },
    { title: "Age at the robot and way there and back, s", curves: [one("age", 0, "joints"), one("age", 1, "pose"), one("round_trip", 0, "way")] },
    ...description.joints.map(({ name }, joint) => ({ title: `${name.replaceAll("_", " ")}, °`, curves: [degrees(joint)] })),
  ];
}

class PlotPane {
  readonly box = element("figure");
  private plot: uPlot | undefined;
  private chosen = 0;

  constructor(
    private readonly plots: readonly Plot[],
    private readonly histories: readonly History[],
    first: number,
    private readonly held: () => boolean,
  ) {
    const choice = element("select", { "aria-label": "What this plot shows" }, ...plots.map(({ title }, index) => element("option", { value: index }, title)));
    choice.value = String(first);
    choice.addEventListener("change", () => this.choose(Number(choice.value)));
    this.box.append(choice);
    this.chosen = first;
  }

  choose(index: number): void {
    this.chosen = index;
    this.makeAnew();
  }

  makeAnew(): void {
    this.plot?.destroy();
    this.plot = undefined;
  }

  draw(span_s: number): void {
    const { curves } = this.plots[this.chosen] as Plot;
    const data = this.histories[this.chosen]?.data(curves.map((_, index) => index), span_s) as uPlot.AlignedData;
    this.plot ??= this.make(curves);
    const width = this.box.clientWidth;
    if (width > 0 && width !== this.plot.width) this.plot.setSize({ width, height: this.plot.height });
    this.plot.setData(data, !this.held());
  }

  zoom(share: number): void {
    const { min = 0, max = 0 } = this.plot?.scales["x"] ?? {};
    const middle = ((min ?? 0) + (max ?? 0)) / 2;
    const half = (((max ?? 0) - (min ?? 0)) / 2) * share;
    this.plot?.setScale("x", { min: middle - half, max: middle + half });
  }

  private make(curves: readonly Curve[]): uPlot {
    const style = getComputedStyle(this.box);
    const axis = { stroke: style.color, grid: { stroke: style.getPropertyValue("--line"), width: 1 }, ticks: { stroke: style.getPropertyValue("--line"), width: 1 } };
    return new uPlot({
      width: Math.max(this.box.clientWidth, 200),
      height: 170,
      cursor: { drag: { x: true, y: false } },
      scales: { x: { time: false } },
      axes: [{ ...axis, values: (_plot, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: 52 }],
      series: [{ label: "s" }, ...curves.map(({ name }, index) => ({ label: name, stroke: colours[index] ?? "#888", width: 1.5 }))],
    }, [[], ...curves.map(() => [])] as uPlot.AlignedData, this.box);
  }
}

export function plotsTab(context: Context): Tab {
  const plots = plotsOf(context);
  const histories = plots.map(({ curves }) => new History(curves));
  let held = false;
  let shown = false;
  let drawn_ms = -Infinity;
  const panes = [0, 1, 2].map((first) => new PlotPane(plots, histories, first, () => held));
  const span = element("select", { "aria-label": "How much time is shown" }, ...spans_s.map((seconds) => element("option", { value: seconds }, `${seconds} s`)));
  const hold = button("Hold", () => {
    held = !held;
    hold.setAttribute("aria-pressed", String(held));
    hold.textContent = held ? "Go on" : "Hold";
  }, { "aria-pressed": "false" });
  const holdAnd = (action: () => void) => () => {
    if (!held) hold.click();
    action();
  };
  const tools = element("div", { class: "tools" }, span, hold,
    button("Zoom in", holdAnd(() => panes.forEach((pane) => pane.zoom(0.5)))),
    button("Zoom out", holdAnd(() => panes.forEach((pane) => pane.zoom(2)))));
  const note = element("p", { class: "hint" }, "Drag over a plot to zoom into it while it is held; a double click shows all again.");
  // Dark and light have other axes.
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => panes.forEach((pane) => pane.makeAnew()));
  context.frameTakers.push((frame) => histories.forEach((history) => history.add(frame)));
  return {
    title: "Plots",
    content: element("div", { class: "plots" }, tools, ...panes.map(({ box }) => box), note),
    show: () => (shown = true),
    hide: () => (shown = false),
    look: (now_ms) => {
      if (!shown || held || now_ms - drawn_ms < redraw_ms) return;
      drawn_ms = now_ms;
      panes.forEach((pane) => pane.draw(Number(span.value)));
    },
  };
}
