// The robot's events as they come, with a filter.
import type { Context, Tab } from "../context.ts";
import { button, element, setText } from "../dom.ts";
import type { Message } from "../rosbridge.ts";

const kept = 500;
const levels = [
  { least: 0, name: "all" },
  { least: 30, name: "warnings and errors" },
  { least: 40, name: "errors" },
] as const;

interface Event {
  time_s: number;
  level: number;
  source: string;
  text: string;
}

export function eventOf(message: Message): Event {
  const stamp = message["stamp"] as { sec: number; nanosec: number };
  return { time_s: stamp.sec + stamp.nanosec * 1e-9, level: Number(message["level"]), source: String(message["name"]), text: String(message["msg"]) };
}

export function passes(event: Event, least: number, words: string): boolean {
  const text = `${event.source} ${event.text}`.toLowerCase();
  return event.level >= least && words.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

function line({ time_s, level, source, text }: Event): HTMLElement {
  const kind = level >= 40 ? "error" : level >= 30 ? "warning" : "info";
  return element("li", { class: kind }, element("span", { class: "number" }, time_s.toFixed(2)), " ",
    element("b", {}, kind === "info" ? source : `${kind}: ${source}`), ` ${text}`);
}

export function eventsTab({ robot }: Context): Tab {
  let events: Event[] = [];
  const list = element("ol", { class: "events", tabindex: 0, "aria-label": "Events, the newest first" });
  const level = element("select", { id: "event-level", "aria-label": "Which events" }, ...levels.map(({ least, name }) => element("option", { value: least }, name)));
  const words = element("input", { type: "search", placeholder: "filter by words", "aria-label": "Filter by words" });
  const passing = (event: Event) => passes(event, Number(level.value), words.value);
  const none = element("p", { class: "hint", role: "status" });
  const tell = () => setText(none, list.childElementCount > 0 ? "" : events.length > 0 ? `None of ${events.length} events passes the filter.` : "No event yet.");
  const fill = () => {
    list.replaceChildren(...events.filter(passing).map(line));
    tell();
  };
  level.addEventListener("change", fill);
  words.addEventListener("input", fill);
  // From the page's start on, so that nothing is missed while another tab is open.
  robot.subscribe("/events", "rcl_interfaces/msg/Log", 0, (message) => {
    const event = eventOf(message);
    events = [event, ...events.slice(0, kept - 1)];
    if (passing(event)) list.prepend(line(event));
    while (list.childElementCount > kept) list.lastElementChild?.remove();
    tell();
  });
  tell();
  const clear = button("Clear", () => {
    events = [];
    fill();
  });
  return { title: "Events", content: element("div", { class: "events-tab" }, element("div", { class: "tools" }, level, words, clear), none, list) };
}
