// The plug-ins: what they cost, what went wrong; reload, and the parameters that can be changed while they work.
import type { Context, Tab } from "../context.ts";
import { button, element, setText } from "../dom.ts";
import { Facts } from "../facts.ts";
import type { Message } from "../rosbridge.ts";

const parametersWait_ms = 10_000; // the robot asks the plug-in for one after the other

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
interface Card {
  box: HTMLElement;
  state: HTMLElement;
  facts: Facts;
  steps: number; // when it was first seen
  seen_s: number; // then, by the robot's clock
}

const listEvery_ms = 1000;

function parameterForm(context: Context, plugin: string, parameters: Message, list: () => void): HTMLElement {
  const of = (key: string) => parameters[key] as string[];
  const live = parameters["live"] as boolean[];
  const lines = of("names").map((name, index) => {
    const id = `parameter-${plugin}-${name}`;
    const value = element("input", { id, value: of("values")[index] ?? "", disabled: !live[index], spellcheck: false, autocomplete: "off" });
    const change = element("form", { class: "parameter" }, element("label", { for: id }, name), value,
      element("button", { type: "submit", disabled: !live[index] }, "Set"), element("small", {}, of("docs")[index] ?? ""));
    change.addEventListener("submit", (event) => {
      event.preventDefault();
      void context.attempt(`${plugin}: ${name} = ${value.value}`, async () => {
        if (!context.command.mine) await context.command.take();
        await context.robot.order("/plugins/set_parameter", { plugin, parameter: name, value: value.value });
      }).then(list);
    });
    return { change, live: live[index] ?? false };
  });
  const fixed = lines.filter((line) => !line.live).map((line) => line.change);
  const open = lines.filter((line) => line.live).map((line) => line.change);
  return element("div", {}, ...open, element("details", {}, element("summary", {}, `${fixed.length} that hold until a restart`), ...fixed));
}

function showCard(card: Card, plugin: Plugin, now_s: number): void {
  const steps = plugin.steps - card.steps;
  const period_ms = steps > 0 ? ((now_s - card.seen_s) * 1000) / steps : NaN;
  setText(card.state, plugin.state);
  card.box.classList.toggle("bad-card", plugin.state !== "works");
  card.facts.set("period", Number.isNaN(period_ms) ? "–" : `${period_ms.toFixed(1)} ms`);
  card.facts.set("p50", `${plugin.p50_step_us.toFixed(0)} µs`);
  card.facts.set("p99", `${plugin.p99_step_us.toFixed(0)} µs`);
  card.facts.set("worst", `${plugin.worst_step_us.toFixed(0)} µs`);
  card.facts.set("faults", String(plugin.faults), plugin.faults > 0);
  card.facts.set("over budget", String(plugin.overruns), plugin.overruns > 0);
}

export function pluginsTab(context: Context): Tab {
  const { robot, attempt, command, news, freshness } = context;
  const list = element("div");
  const parameters = element("section", { "aria-label": "Parameters", hidden: true });
  const cards = new Map<string, Card>();
  let listed_ms = -Infinity;

  const showParameters = async (plugin: string) => {
    const answer = await robot.order("/plugins/get_parameters", { plugin }, parametersWait_ms);
    parameters.hidden = false;
    parameters.replaceChildren(element("h2", { tabindex: -1 }, `Parameters of ${plugin}`), parameterForm(context, plugin, answer, () => open(plugin)));
  };
  const open = (plugin: string) => void showParameters(plugin).catch((error: Error) => news.say(error.message, "bad"));
  const openAndGo = (plugin: string) => void showParameters(plugin).then(() => parameters.querySelector("h2")?.focus(),
    (error: Error) => news.say(error.message, "bad"));
  const reload = (name: string) => void attempt(`Reload ${name}`, async () => {
    if (!command.mine) await command.take();
    await robot.order("/plugins/reload", { name, library: "" }, 10_000);
  });
  const addCard = ({ name, steps }: Plugin, now_s: number): Card => {
    const state = element("span", { class: "plugin-state" });
    const facts = new Facts();
    const box = element("article", { class: "card", "aria-label": name },
      element("header", {}, element("h2", {}, name), state, button("Parameters", () => openAndGo(name), { "aria-label": `Parameters of ${name}` }),
        button("Reload", () => reload(name), { "aria-label": `Reload ${name}` })),
      facts.list);
    list.append(box);
    const card = { box, state, facts, steps, seen_s: now_s };
    cards.set(name, card);
    return card;
  };
  const look = async () => {
    const { plugins } = (await robot.order("/plugins/list")) as unknown as { plugins: Plugin[] };
    const now_s = freshness.newest?.robot_time[0] ?? 0;
    for (const plugin of plugins) {
      const card = cards.get(plugin.name) ?? addCard(plugin, now_s);
      if (plugin.steps < card.steps) Object.assign(card, { steps: plugin.steps, seen_s: now_s }); // it was started anew
      showCard(card, plugin, now_s);
    }
  };
  return {
    title: "Plug-ins",
    content: element("div", { class: "plugins" }, list, parameters),
    look: (now_ms) => {
      if (!robot.isOpen || now_ms - listed_ms < listEvery_ms) return;
      listed_ms = now_ms;
      look().catch((error: Error) => news.say(error.message, "bad"));
    },
  };
}
