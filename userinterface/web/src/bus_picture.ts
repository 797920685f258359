// Draws a time slot of the bus: a lane for what goes to all joints, one for each joint, one for what does not belong there.
import { hasTrouble, share, slotPicture, troubles, type BusMessage, type BusSlot, type BusTable, type Entry, type SlotPicture } from "./bus_slot.ts";
import { button, element, row, setText, table as makeTable } from "./dom.ts";
import { ageText } from "./freshness.ts";

const lane_px = 14;
const axis_px = 18;
const letter_px = 5.7;
const mostLetters = 22; // of a lane's name
const right_px = 12;
const least_px = 280;
const gridEvery_us = 2000;
const oldAfter_ms = 1500; // slots are shown four times a second; over a narrow link, each third of them
const shapes: Record<string, string> = { SYNC: "sync", trim: "trim", feedback: "feedback", trajectory: "trajectory" };
const legend: [string, string][] = [
  ["sync", "SYNC"], ["trim", "trim"], ["feedback", "feedback"], ["trajectory", "trajectory"], ["other", "other"], ["due", "due"], ["latest", "proven latest"], ["late", "late"], ["missing", "missing"], ["error", "error"], ["foreign", "foreign"],
];

function svg(tag: string, attributes: Record<string, string | number>, text?: string): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, typeof value === "number" ? String(Math.round(value * 10) / 10) : value);
  if (text !== undefined) made.textContent = text;
  return made;
}

const inMs = (time_us: number | undefined): string => (time_us === undefined ? "–" : (time_us / 1000).toFixed(2));

// What one reads over a mark.
function words({ name, verdict, end_us, length_us, latest_us }: Entry): string {
  const when = end_us === undefined ? "has not come" : `at ${inMs(end_us)} ms`;
  return [`${name}: ${when}`, length_us > 0 && end_us !== undefined && `${length_us} µs long`, latest_us !== undefined && `at the latest ${inMs(latest_us)} ms`, verdict !== "seen" && verdict].filter(Boolean).join(", ");
}

export class BusPicture {
  private readonly drawing = svg("svg", { role: "img" });
  private readonly status = element("p", { class: "bus-status" });
  private readonly verdict = element("p", { class: "bus-verdict" });
  private readonly hold = button("Hold", () => this.toggle());
  private readonly rows: HTMLTableSectionElement;
  private readonly details: HTMLDetailsElement;
  private readonly lanes: string[];
  private readonly label_px: number;
  private readonly jointLane = new Map<number, number>();
  private readonly box = element("div", { class: "bus-picture" });
  private shown: SlotPicture | undefined;
  private slot: BusSlot | undefined;
  private held = false;
  readonly content: HTMLElement;

  constructor(private readonly bus: BusTable, private readonly joints: readonly string[]) {
    const onBus = [...new Set(bus.messages.map(({ joint }) => joint).filter((joint) => joint >= 0))].sort((one, other) => one - other);
    for (const [place, joint] of onBus.entries()) this.jointLane.set(joint, place + 1);
    this.lanes = ["all joints", ...onBus.map((joint) => joints[joint] ?? ""), "others, errors"]
      .map((name) => (name.length > mostLetters ? `${name.slice(0, mostLetters - 1)}…` : name));
    this.label_px = Math.max(...this.lanes.map(({ length }) => length)) * letter_px + 10;
    const { table, body } = makeTable("Frames of the slot; times in ms from its edge", "frame", "end", "µs", "at the latest", "");
    table.classList.add("bus-table");
    this.rows = body;
    this.details = element("details", {}, element("summary", {}, "The slot as a table"), table);
    this.details.addEventListener("toggle", () => this.fillTable());
    this.box.append(this.drawing);
    const marks = element("ul", { class: "bus-legend", "aria-hidden": true }, ...legend.map(([mark, text]) => element("li", { class: mark }, text)));
    this.content = element("div", {}, element("div", { class: "tools" }, this.hold, this.status), this.box, this.verdict, marks, element("p", { class: "note" }, this.note()), this.details);
    new ResizeObserver(() => this.draw()).observe(this.box);
  }

  take(slot: BusSlot): void {
    if (this.held) return;
    this.slot = slot;
    this.shown = slotPicture(slot, this.bus, this.joints);
    setText(this.verdict, troubles(this.shown));
    this.verdict.classList.toggle("bad", hasTrouble(this.shown));
    this.draw();
    this.fillTable();
  }

  // `robot_ms`: the robot's clock now; NaN: it is not known. `live`: what the rest of the page shows is of now.
  look(robot_ms: number, live: boolean): void {
    if (!this.slot || !this.shown) {
      setText(this.status, "No slot has come yet.");
      return;
    }
    const { sec, nanosec } = this.slot.header.stamp;
    const since_ms = robot_ms - sec * 1000 - nanosec / 1e6;
    // Of a run before this one, when it lies ahead.
    const age_ms = since_ms < -oldAfter_ms ? NaN : Math.max(since_ms, 0);
    const old = !live || Number.isNaN(age_ms) || age_ms > oldAfter_ms;
    this.box.classList.toggle("old", old && !this.held);
    const how = this.held ? "held, " : old ? "old: " : "";
    setText(this.status, `Slot ${this.slot.slot} of cycle ${this.slot.cycle}, ${how}${Number.isNaN(age_ms) ? "of unknown age" : `${ageText(age_ms)} ago`}. ${share(this.shown)}.`);
  }

  private note(): string {
    const { profile, load, jitter_us, jam_us } = this.bus;
    return `One slot of 25. Proven for the profile '${profile}': load ${Math.round(load * 100)} % at most; latest arrivals with senders up to ${jitter_us / 1000} ms late and the bus jammed once for ${jam_us / 1000} ms.`;
  }

  private toggle(): void {
    this.held = !this.held;
    this.hold.setAttribute("aria-pressed", String(this.held));
  }

  private laneOf({ message }: Entry): number {
    if (!message) return this.lanes.length - 1;
    return message.joint < 0 ? 0 : (this.jointLane.get(message.joint) ?? this.lanes.length - 1);
  }

  private draw(): void {
    const width_px = Math.max(this.box.clientWidth, least_px);
    if (!this.shown || this.box.clientWidth === 0) return; // it is not shown
    const height_px = this.lanes.length * lane_px + axis_px;
    const { slot_us } = this.bus;
    const x = (time_us: number) => this.label_px + (Math.min(Math.max(time_us, 0), slot_us) / slot_us) * (width_px - this.label_px - right_px);
    this.drawing.setAttribute("viewBox", `0 0 ${width_px} ${height_px}`);
    this.drawing.setAttribute("height", String(height_px));
    this.drawing.setAttribute("aria-label", `${share(this.shown)}: ${troubles(this.shown)}`);
    this.drawing.replaceChildren(...this.ground(x, width_px), ...this.dueLine(x), ...this.shown.entries.flatMap((entry) => this.marks(entry, x)));
  }

  private ground(x: (time_us: number) => number, width_px: number): SVGElement[] {
    const bottom_px = this.lanes.length * lane_px;
    const parts = this.lanes.flatMap((name, lane) => [
      svg("rect", { class: lane % 2 === 0 ? "lane even" : "lane", x: 0, y: lane * lane_px, width: width_px, height: lane_px }),
      svg("text", { x: this.label_px - 6, y: (lane + 1) * lane_px - 3.5, "text-anchor": "end" }, name),
    ]);
    for (let time_us = 0; time_us <= this.bus.slot_us; time_us += gridEvery_us) {
      parts.push(svg("line", { class: "grid", x1: x(time_us), x2: x(time_us), y1: 0, y2: bottom_px }),
        svg("text", { x: time_us === this.bus.slot_us ? width_px : x(time_us), y: bottom_px + 13, "text-anchor": time_us === this.bus.slot_us ? "end" : "middle" }, `${time_us / 1000}${time_us === this.bus.slot_us ? " ms" : ""}`));
    }
    return parts;
  }

  // All joints are to answer from the SYNC's end on.
  private dueLine(x: (time_us: number) => number): SVGElement[] {
    const due_us = this.shown?.entries.find(({ message, due_us: due }) => message?.released === "sync" && due !== undefined)?.due_us;
    return due_us === undefined ? [] : [svg("line", { class: "due", x1: x(due_us), x2: x(due_us), y1: lane_px, y2: (this.lanes.length - 1) * lane_px })];
  }

  private marks(entry: Entry, x: (time_us: number) => number): SVGElement[] {
    const { message, verdict, end_us, length_us, due_us, latest_us } = entry;
    const top_px = this.laneOf(entry) * lane_px;
    const parts: SVGElement[] = [];
    if (latest_us !== undefined && latest_us <= this.bus.slot_us) {
      parts.push(svg("line", { class: "latest", x1: x(latest_us), x2: x(latest_us), y1: top_px + 1, y2: top_px + lane_px - 1 }));
    }
    if (end_us === undefined) {
      parts.push(svg("text", { class: "missing", x: x(due_us ?? 0) + 4, y: top_px + lane_px - 3.5 }, "✕ missing"));
    } else if (verdict === "error") {
      parts.push(svg("text", { class: "error", x: x(end_us), y: top_px + lane_px - 3, "text-anchor": "middle" }, "◆"));
    } else {
      parts.push(...this.block(x(end_us - length_us), x(end_us), top_px, verdict, message));
    }
    parts.at(-1)?.append(svg("title", {}, words(entry)));
    return parts;
  }

  private block(from_px: number, to_px: number, top_px: number, verdict: Entry["verdict"], message: BusMessage | undefined): SVGElement[] {
    const shape = verdict === "foreign" ? "foreign" : (shapes[message?.kind ?? ""] ?? "other");
    const block = svg("rect", { class: `frame ${shape}${verdict === "late" ? " late" : ""}`, x: from_px, y: top_px + 2, width: Math.max(to_px - from_px, 1.5), height: lane_px - 4 });
    if (verdict !== "late") return [block];
    return [svg("text", { class: "late", x: from_px - 2, y: top_px + lane_px - 3.5, "text-anchor": "end" }, "late"), block];
  }

  private fillTable(): void {
    if (!this.details.open || !this.shown) return;
    this.rows.replaceChildren(...this.shown.entries.map((entry) => {
      const { name, end_us, length_us, latest_us, verdict } = entry;
      const made = row(name, inMs(end_us), end_us === undefined ? "–" : String(length_us), inMs(latest_us), verdict);
      for (const cell of [1, 2, 3]) made.cells[cell]?.classList.add("number");
      made.classList.toggle("bad", verdict !== "in time" && verdict !== "seen");
      return made;
    }));
  }
}
