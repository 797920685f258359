// What is compared, the worst first: each channel's difference as a bar against its limit. A channel that is pressed is plotted.
import { button, element, setText } from "../dom.ts";
import { isAbove, shareOf, spoken, valueText, worstFirst } from "./agreement.ts";
import type { Channel } from "./twin_state.ts";

const shownFirst = 8; // more of them are folded away
const sortEvery_ms = 1000;
const handStays_ms = 1500; // nothing goes away under a pointer that aims
const barEnds = 2; // limits: the mark is in the middle

interface Row {
  row: HTMLTableRowElement;
  name: HTMLButtonElement;
  bar: HTMLElement;
  difference: HTMLElement;
  limit: HTMLElement;
}

export class DifferenceTable {
  readonly box: HTMLElement;
  private readonly body = element("tbody");
  private readonly more: HTMLButtonElement;
  private readonly rows = new Map<string, Row>();
  private order: string[] = [];
  private sorted_ms = -Infinity;
  private pointed_ms = -Infinity;
  private all = false;
  private chosen: string | undefined;

  constructor(private readonly choose: (name: string) => void) {
    const head = element("thead", {}, element("tr", {}, ...["channel", "difference, RMS of 2 s", "", "limit"].map((heading) => element("th", { scope: "col" }, heading))));
    const table = element("table", { class: "differences" }, element("caption", { class: "hidden" }, "Differences, the worst first"), head, this.body);
    this.more = button("", () => {
      this.all = !this.all;
      this.fold();
    }, { id: "twin-all", class: "plain-more", "aria-expanded": "false" });
    this.box = element("div", {}, table, this.more);
    table.addEventListener("pointermove", () => (this.pointed_ms = performance.now()));
  }

  show(channels: readonly Channel[], now_ms: number): void {
    if (channels.length !== this.rows.size || channels.some(({ name }) => !this.rows.has(name))) this.begin(channels);
    for (const channel of channels) this.fill(channel);
    if (now_ms - this.sorted_ms < sortEvery_ms || now_ms - this.pointed_ms < handStays_ms) return;
    this.sorted_ms = now_ms;
    this.sort(worstFirst(channels).map(({ name }) => name));
  }

  setChosen(name: string): void {
    if (name === this.chosen) return;
    this.chosen = name;
    for (const [other, { name: press }] of this.rows) press.setAttribute("aria-pressed", String(other === name));
    this.fold();
  }

  private begin(channels: readonly Channel[]): void {
    this.rows.clear();
    this.order = [];
    for (const { name } of channels) {
      const press = button(spoken(name), () => this.choose(name), { class: "channel", "aria-pressed": String(name === this.chosen), title: "Plot it" });
      const bar = element("span", { class: "bar" });
      const [difference, limit] = [element("td", { class: "number" }), element("td", { class: "number limit" })];
      const row = element("tr", { "data-channel": name }, element("th", { scope: "row" }, press), element("td", { class: "bar-cell" }, bar), difference, limit);
      row.addEventListener("click", ({ target }) => target !== press && this.choose(name));
      this.rows.set(name, { row, name: press, bar, difference, limit });
    }
    this.sorted_ms = this.pointed_ms = -Infinity;
  }

  private fill(channel: Channel): void {
    const row = this.rows.get(channel.name);
    if (!row) return;
    const share = shareOf(channel);
    const above = isAbove(channel);
    row.row.classList.toggle("above", above);
    row.row.classList.toggle("chosen", channel.name === this.chosen);
    row.row.classList.toggle("unknown", !Number.isFinite(channel.difference));
    row.bar.style.setProperty("--share", String(Math.min(Math.max(share || 0, 0), barEnds) / barEnds));
    row.bar.classList.toggle("near", share > 0.7 && !above);
    row.bar.hidden = channel.limit === 0;
    setText(row.difference, valueText(channel.difference, channel.unit));
    setText(row.limit, channel.limit > 0 ? valueText(channel.limit, channel.unit) : "never");
  }

  // Only what lies elsewhere is moved, and whoever has the focus keeps it.
  private sort(names: readonly string[]): void {
    if (names.join() !== this.order.join()) {
      const focused = document.activeElement;
      this.order = [...names];
      for (const [index, name] of names.entries()) {
        const row = this.rows.get(name)?.row;
        if (row && this.body.children[index] !== row) this.body.insertBefore(row, this.body.children[index] ?? null);
      }
      while (this.body.childElementCount > names.length) this.body.lastElementChild?.remove();
      if (focused instanceof HTMLElement && focused !== document.activeElement && this.body.contains(focused)) focused.focus({ preventScroll: true });
    }
    this.fold();
  }

  private fold(): void {
    for (const [index, name] of this.order.entries()) {
      const row = this.rows.get(name)?.row;
      if (row) row.hidden = !this.all && index >= shownFirst && name !== this.chosen && !row.classList.contains("above");
    }
    this.more.hidden = this.order.length <= shownFirst;
    this.more.setAttribute("aria-expanded", String(this.all));
    setText(this.more, this.all ? "Only the worst" : `All ${this.order.length}`);
  }
}
