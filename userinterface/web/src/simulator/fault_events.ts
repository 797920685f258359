// The faults that the simulator can be given: what each does, its fields, and the scenario event that it makes. Passive.
import type { ScenarioEvent } from "./simulation_orders.ts";

export interface NumberField {
  kind: "number";
  key: string;
  name: string;
  unit: string;
  value: number;
  least: number;
  most: number;
}
export interface ChoiceField {
  kind: "choice";
  key: string;
  name: string;
  of: "joints" | "nodes" | "plugins" | "sensors" | readonly { value: string; text: string }[];
}
export type FaultField = NumberField | ChoiceField;
export interface FaultForm {
  fault: string; // its kind in a scenario
  title: string;
  text: string; // what comes of it
  fields: readonly FaultField[];
}

const duration = (value: number, most = 600, least = 0.001): NumberField => ({ kind: "number", key: "duration_s", name: "for", unit: "s", value, least, most });
const share = (key: string, name: string, value: number): NumberField => ({ kind: "number", key, name, unit: "%", value, least: 0, most: 100 });

export const faultForms: readonly FaultForm[] = [
  { fault: "lose_frames", title: "Frames are lost", text: "Each frame on the bus is lost with this probability.", fields: [share("probability", "lost", 2), duration(2)] },
  { fault: "disturb_bus", title: "The bus is disturbed", text: "Attempts to send a frame meet errors; the bus repeats them.",
    fields: [share("corruption", "corrupted", 1), share("omission", "left out", 0.1), share("duplicate", "doubled", 0.1), duration(10)] },
  { fault: "jam", title: "The bus is jammed", text: "Nobody can send for so long.",
    fields: [duration(0.002, 10, 0.00001), { kind: "choice", key: "stuck", name: "by", of: [{ value: "", text: "noise" }, { value: "true", text: "a line that is stuck" }] }] },
  { fault: "bus_off", title: "A station is bus-off", text: "Its frames are destroyed until it leaves the bus; it comes back as the standard has it.", fields: [{ kind: "choice", key: "node", name: "station", of: "nodes" }] },
  { fault: "joint_restarts", title: "A joint restarts", text: "Its controller is without power for a while, its motor without torque.", fields: [{ kind: "choice", key: "joint", name: "joint", of: "joints" }, duration(0.02, 60)] },
  { fault: "main_controller_silent", title: "Main controller silent", text: "It makes no tick for so long: the message controller plays the safe tail.", fields: [duration(1)] },
  { fault: "plugin_fails", title: "A plug-in fails", text: "Its steps fail for so long; the manager falls back on what it has. One that fails too often is out of service until it is reloaded (view Plug-ins).",
    fields: [{ kind: "choice", key: "plugin", name: "plug-in", of: "plugins" },
      { kind: "choice", key: "how", name: "it", of: [{ value: "throws", text: "throws" }, { value: "not_a_number", text: "gives no numbers" }, { value: "jumps", text: "gives nonsense" }, { value: "overruns", text: "takes too long" }] },
      duration(1)] },
  { fault: "sensor_fails", title: "A sensor fails", text: "It tells something else than what is; of a joint, its encoder.",
    fields: [{ kind: "choice", key: "sensor", name: "sensor", of: "sensors" },
      { kind: "choice", key: "how", name: "it", of: [{ value: "freezes", text: "freezes" }, { value: "reads_zero", text: "reads zero" }, { value: "noisy", text: "is noisy" }] },
      duration(0.5)] },
];

// `values`: of the fields, by their keys, as a person wrote them. Throws with the field and its bounds where one is no such number.
export function faultEvent(form: FaultForm, values: ReadonlyMap<string, string>): ScenarioEvent {
  const fault: Record<string, string | number | boolean> = { kind: form.fault };
  for (const field of form.fields) {
    const text = (values.get(field.key) ?? "").trim();
    if (field.kind === "choice") {
      if (text === "" && typeof field.of === "string") throw new Error(`${form.title}: no ${field.name} is chosen`);
      if (text !== "") fault[field.key] = text === "true" ? true : text;
      continue;
    }
    const value = Number(text);
    if (text === "" || !(value >= field.least && value <= field.most)) throw new Error(`${form.title}: “${field.name}” is '${text}', and must be ${field.least} … ${field.most} ${field.unit}`);
    fault[field.key] = field.unit === "%" ? Number((value / 100).toPrecision(12)) : value;
  }
  return { fault };
}
