// The plug-ins: what they cost, what went wrong; reload, and the parameters that can be changed while they work.
import type { Context, Tab } from "../context.ts";
import { button, element, setText, table } from "../dom.ts";
import type { Message } from "../rosbridge.ts";

interface Plugin {
  name: string;
  state: string;
  steps: number;
  faults: number;
  overruns: number;
  p50_step_us: number;
  p99_step_us: number;
  worst_step_us: number;
}
interface Row {
  element: HTMLTableRowElement;
  cells: HTMLTableCellElement[];
  steps: number;
  looked_ms: number;
}

const listEvery_ms = 1000;

function parameterForm(context: Context, plugin: string, parameters: Message, list: () => void): HTMLElement {
  const of = (key: string) => parameters[key] as string[];
  const live = parameters["live"] as boolean[];
  const lines = of("names").map((name, index) => {
    const id = `parameter-${plugin}-${name}`;
    const value = element("input", { id, value: of("values")[index] ?? "", disabled: !live[index], spellcheck: false, autocomplete: "off" });
    const set = () => void context.attempt(`${plugin}: ${name} = ${value.value}`, async () => {
      if (!context.command.mine) await context.command.take();
      await context.robot.order("/plugins/set_parameter", { plugin, parameter: name, value: value.value });
    }).then(list);
    const change = element("form", { class: "parameter" }, element("label", { for: id, title: of("docs")[index] ?? "" }, name), value,
      element("button", { type: "submit", disabled: !live[index] }, "Set"), element("small", {}, of("docs")[index] ?? ""));
    change.addEventListener("submit", (event) => {
      event.preventDefault();
      set();
    });
    return { change, live: live[index] ?? false };
  });
  const fixed = lines.filter((line) => !line.live).map((line) => line.change);
  const open = lines.filter((line) => line.live).map((line) => line.change);
  return element("div", {}, ...open, element("details", {}, element("summary", {}, `${fixed.length} that need a restart`), ...fixed));
}

function statistics(row: Row, plugin: Plugin, now_ms: number): string[] {
  const steps = plugin.steps - row.steps;
  const period_ms = steps > 0 && row.looked_ms > 0 ? (now_ms - row.looked_ms) / steps : NaN;
  row.steps = plugin.steps;
  row.looked_ms = now_ms;
  return [plugin.state, Number.isNaN(period_ms) ? "–" : period_ms.toFixed(period_ms < 20 ? 1 : 0), plugin.p50_step_us.toFixed(0), plugin.p99_step_us.toFixed(0),
    plugin.worst_step_us.toFixed(0), String(plugin.faults)];
}

export function pluginsTab(context: Context): Tab {
  const { robot, attempt, command, news } = context;
  const { table: listing, body } = table("Plug-ins", "name", "state", "period, ms", "p50, µs", "p99, µs", "worst, µs", "faults", "");
  const parameters = element("section", { "aria-label": "Parameters", hidden: true });
  const rows = new Map<string, Row>();
  let listed_ms = -Infinity;

  const showParameters = (plugin: string) => async () => {
    const answer = await robot.order("/plugins/get_parameters", { plugin });
    parameters.hidden = false;
    parameters.replaceChildren(element("h2", {}, `Parameters of ${plugin}`), parameterForm(context, plugin, answer, open(plugin)));
  };
  const open = (plugin: string) => () => void showParameters(plugin)().catch((error: Error) => news.say(error.message, "bad"));
  const reload = (name: string) => () => void attempt(`Reload ${name}`, async () => {
    if (!command.mine) await command.take();
    await robot.order("/plugins/reload", { name, library: "" }, 10_000);
  });
  const addRow = ({ name, steps }: Plugin): Row => {
    const cells = Array.from({ length: 6 }, (_, index) => element("td", index > 0 ? { class: "number" } : {}));
    const buttons = element("td", { class: "buttons" }, button("Parameters", open(name), { "aria-label": `Parameters of ${name}` }),
      button("Reload", reload(name), { "aria-label": `Reload ${name}` }));
    const made = { element: element("tr", {}, element("th", { scope: "row" }, name), ...cells, buttons), cells, steps, looked_ms: 0 };
    rows.set(name, made);
    body.append(made.element);
    return made;
  };
  const list = async (now_ms: number) => {
    const { plugins } = (await robot.order("/plugins/list")) as unknown as { plugins: Plugin[] };
    for (const plugin of plugins) {
      const row = rows.get(plugin.name) ?? addRow(plugin);
      for (const [index, text] of statistics(row, plugin, now_ms).entries()) setText(row.cells[index] as Element, text);
      row.element.classList.toggle("bad", plugin.state !== "works");
    }
  };
  return {
    title: "Plug-ins",
    content: element("div", { class: "plugins" }, element("div", { class: "scrolls" }, listing), parameters),
    look: (now_ms) => {
      if (!robot.isOpen || now_ms - listed_ms < listEvery_ms) return;
      listed_ms = now_ms;
      list(now_ms).catch((error: Error) => news.say(error.message, "bad"));
    },
  };
}
