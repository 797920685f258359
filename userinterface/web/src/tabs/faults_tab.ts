// Faults of a simulated robot: each with its few fields, and one button that makes it happen now.
import type { Context, Tab } from "../context.ts";
import { element, setText } from "../dom.ts";
import { faultEvent, faultForms, type ChoiceField, type FaultField, type FaultForm } from "../simulator/fault_events.ts";
import type { SimulationOrders } from "../simulator/simulation_orders.ts";

type Names = Record<"joints" | "nodes" | "plugins" | "sensors", readonly string[]>;

function options(field: ChoiceField, names: Names): HTMLOptionElement[] {
  const choices = typeof field.of === "string" ? names[field.of].map((name) => ({ value: name, text: name.replaceAll("_", " ") })) : field.of;
  return choices.map(({ value, text }) => element("option", { value }, text));
}

function fieldOf(form: FaultForm, field: FaultField, names: Names): { label: HTMLElement; input: HTMLInputElement | HTMLSelectElement } {
  const id = `fault-${form.fault}-${field.key}`;
  if (field.kind === "choice") {
    const input = element("select", { id }, ...options(field, names));
    return { label: element("label", { for: id }, field.name, input), input };
  }
  const input = element("input", { id, type: "number", step: "any", min: field.least, max: field.most, value: field.value });
  return { label: element("label", { for: id }, field.name, input, field.unit), input };
}

export function faultsTab({ attempt, description, robot }: Context, orders: SimulationOrders): Tab {
  const joints = description.joints.map(({ name }) => name);
  const names: Names = { joints, nodes: ["message_controller", ...joints], plugins: [], sensors: ["imu", "left_foot", "right_foot", ...joints] };
  let plugins: HTMLSelectElement | undefined;
  const cards = faultForms.map((form) => {
    const fields = form.fields.map((field) => ({ field, ...fieldOf(form, field, names) }));
    for (const { field, input } of fields) if (field.kind === "choice" && field.of === "plugins") plugins = input as HTMLSelectElement;
    const card = element("form", { class: "card fault", id: `fault-${form.fault}`, novalidate: true },
      element("header", {}, element("h2", {}, form.title), element("button", { type: "submit", "aria-label": `${form.title}: now` }, "Now")),
      element("p", { class: "note" }, form.text), element("div", { class: "fields" }, ...fields.map(({ label }) => label)));
    card.addEventListener("submit", (event) => {
      event.preventDefault();
      void attempt(form.title, () => orders.apply(faultEvent(form, new Map(fields.map(({ field, input }) => [field.key, input.value])))), "applied");
    });
    return card;
  });
  const none = element("p", { class: "note", role: "status" });
  const listPlugins = async () => {
    const { plugins: list } = (await robot.order("/plugins/list")) as unknown as { plugins: { name: string }[] };
    const chosen = plugins?.value;
    // The one that keeps the link to this page is not part of what is simulated.
    plugins?.replaceChildren(...list.filter(({ name }) => name !== "api").map(({ name }) => element("option", { value: name, selected: name === chosen }, name)));
  };
  return {
    title: "Faults",
    content: element("div", { class: "faults" }, element("p", { class: "hint" }, "What goes wrong with the simulated robot, from now on. The time line keeps a mark of it: drag back to before, and it never was."), ...cards, none),
    show: () => void listPlugins().then(() => setText(none, ""), (error: Error) => setText(none, `The plug-ins are not known: ${error.message}`)),
  };
}
