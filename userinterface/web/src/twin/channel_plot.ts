// One channel over the last minute: as measured and as simulated, and below it the difference with its limits.
import uPlot from "uplot";
import { element, setText } from "../dom.ts";
import { spoken, unitOf, valueText } from "./agreement.ts";
import { kept_s, type TwinHistory } from "./twin_history.ts";
import type { Channel } from "./twin_state.ts";

const redraw_ms = 200;
const heights_px = { values: 150, difference: 110 };
const least_s = 10; // of the time that is shown

const minus = (value: number) => String(value).replace("-", "−");

interface Line {
  label: string;
  colour: string; // a variable of the page's looks
  dash?: number[];
}

export class ChannelPlot {
  readonly box: HTMLElement;
  private readonly title = element("h2", { id: "twin-plot-title" });
  private readonly now = element("p", { class: "plot-now" });
  private readonly panes = element("div");
  private plots: uPlot[] = [];
  private unit: string | undefined;
  private drawn_ms = -Infinity;

  constructor() {
    const [measured, simulated] = [element("b", { class: "measured" }), element("b", { class: "simulated" })];
    this.now.append(element("span", { class: "key measured" }, "robot there, measured "), measured, element("span", { class: "key simulated" }, "simulated "), simulated);
    this.values = { measured, simulated };
    this.box = element("figure", { class: "twin-plot", "aria-labelledby": "twin-plot-title" }, this.title, this.now, this.panes);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.makeAnew());
  }
  private readonly values: { measured: HTMLElement; simulated: HTMLElement };

  // Another channel: at once.
  makeAnew(): void {
    for (const plot of this.plots) plot.destroy();
    this.panes.replaceChildren();
    this.plots = [];
    this.drawn_ms = -Infinity;
  }

  draw(channel: Channel, index: number, history: TwinHistory, now_ms: number): void {
    if (now_ms - this.drawn_ms < redraw_ms || this.panes.clientWidth === 0) return;
    this.drawn_ms = now_ms;
    const { unit } = unitOf(channel.unit);
    setText(this.title, `${spoken(channel.name)}, ${unit}`);
    setText(this.values.measured, valueText(channel.measured, channel.unit));
    setText(this.values.simulated, valueText(channel.simulated, channel.unit));
    if (this.plots.length === 0 || unit !== this.unit) this.make(unit);
    const { times_s, measured, simulated, difference } = history.of(index, now_ms / 1000);
    const limit = channel.limit > 0 ? channel.limit * unitOf(channel.unit).times : null;
    const level = (value: number | null) => times_s.map(() => value);
    const width = this.panes.clientWidth;
    for (const plot of this.plots) if (plot.width !== width) plot.setSize({ width, height: plot.height });
    this.plots[0]?.setData([times_s, simulated, measured]);
    this.plots[1]?.setData([times_s, difference, level(limit), level(limit === null ? null : -limit)]);
  }

  private make(unit: string): void {
    this.makeAnew();
    this.unit = unit;
    const limit: Line = { label: "limit", colour: "--bad", dash: [4, 4] };
    this.plots = [
      this.pane(heights_px.values, [{ label: "simulated", colour: "--accent" }, { label: "measured", colour: "--twin" }]),
      this.pane(heights_px.difference, [{ label: "difference", colour: "--text" }, limit, limit]),
    ];
    this.panes.children[1]?.before(element("p", { class: "note" }, "Measured less simulated; dashed: the limit"));
  }

  private pane(height: number, lines: readonly Line[]): uPlot {
    const style = getComputedStyle(this.box);
    const colour = (name: string) => style.getPropertyValue(name);
    const axis = { stroke: style.color, grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line"), width: 1 } };
    return new uPlot({
      width: Math.max(this.panes.clientWidth, 200),
      height,
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, range: (_plot, first) => [Math.min(Math.max(first ?? 0, -kept_s), -least_s), 0] } },
      axes: [{ ...axis, size: 30, values: (_plot, ticks) => ticks.map((tick) => `${minus(tick)} s`) }, { ...axis, size: 44, values: (_plot, ticks) => ticks.map(minus) }],
      series: [{}, ...lines.map((line) => ({ stroke: colour(line.colour), width: line.dash ? 1 : 1.75, ...(line.dash ? { dash: line.dash } : {}), points: { show: false } }))],
    }, [[], ...lines.map(() => [])] as uPlot.AlignedData, this.panes);
  }
}
