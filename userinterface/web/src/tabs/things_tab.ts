// Things of the simulated world: a new one is put where one clicks, one that is there is moved by dragging it, or taken away.
import type { Context, Tab } from "../context.ts";
import type { Triple } from "../description.ts";
import { button, element, setText } from "../dom.ts";
import type { PictureTools } from "../picture_tools.ts";
import type { SimulatorPicture } from "../scene/simulator_picture.ts";
import type { SimulationOrders } from "../simulator/simulation_orders.ts";
import { isGround, type Solid, type SolidShape } from "../simulator/solids.ts";
import { checkThing, freeName, mayBeTaken, moveEvent, removeEvent, sizeOf, spawnEvent, type NewThing } from "../simulator/thing_events.ts";
import { ThingTool } from "../simulator/thing_tool.ts";

interface ThingsTab extends Tab {
  tool: ThingTool;
  worldChanged: () => void;
}
const shapes: readonly { shape: SolidShape; text: string; size: Triple; measures: readonly [string, string, string] }[] = [
  { shape: "box", text: "Box", size: [0.2, 0.2, 0.1], measures: ["length", "width", "height"] },
  { shape: "cylinder", text: "Cylinder", size: [0.15, 0.15, 0.2], measures: ["diameter", "", "height"] },
  { shape: "sphere", text: "Ball", size: [0.15, 0.15, 0.15], measures: ["diameter", "", ""] },
];

// What a new thing is to be like.
class ThingForm {
  readonly box: HTMLElement;
  shape: SolidShape = "box";
  private readonly measures = [0, 1, 2].map((axis) => element("input", { type: "number", id: `thing-size-${axis}`, min: 1, max: 500, step: "any" }));
  private readonly labels = this.measures.map((input) => {
    const name = element("span");
    return { name, label: element("label", {}, name, input, "cm") };
  });
  private readonly fast = element("input", { type: "checkbox", id: "thing-fast" });
  private readonly mass = element("input", { type: "number", id: "thing-mass", min: 0.001, step: "any", value: 0.5 });
  private readonly colour = element("input", { type: "color", id: "thing-colour", value: "#e08a2b" });
  private readonly buttons: HTMLButtonElement[];

  constructor() {
    this.buttons = shapes.map(({ shape, text }) => button(text, () => this.choose(shape), { "aria-pressed": "false", id: `thing-${shape}` }));
    this.fast.addEventListener("change", () => (this.mass.disabled = this.fast.checked));
    this.box = element("div", { class: "thing-form" }, element("div", { class: "buttons", role: "group", "aria-label": "Shape" }, ...this.buttons),
      element("div", { class: "fields" }, ...this.labels.map(({ label }) => label), element("label", {}, "mass", this.mass, "kg"),
        element("label", { class: "check" }, this.fast, "stands fast"), element("label", {}, "colour", this.colour)));
    this.choose("box");
  }

  // Throws with what is wrong.
  get thing(): NewThing {
    const size = this.measures.map((input) => Number(input.value) / 100) as Triple;
    const thing: NewThing = { shape: this.shape, size: sizeOf(this.shape, size), mass_kg: this.fast.checked ? undefined : Number(this.mass.value), colour: this.colour.value };
    checkThing(thing);
    return thing;
  }

  private choose(shape: SolidShape): void {
    this.shape = shape;
    for (const [index, entry] of shapes.entries()) {
      this.buttons[index]!.setAttribute("aria-pressed", String(entry.shape === shape));
      if (entry.shape !== shape) continue;
      for (const [axis, { name, label }] of this.labels.entries()) {
        setText(name, entry.measures[axis]!);
        label.hidden = entry.measures[axis] === "";
        this.measures[axis]!.value = String(Math.round(entry.size[axis]! * 1000) / 10);
      }
    }
  }
}

export function thingsTab({ attempt, news }: Context, orders: SimulationOrders, picture: SimulatorPicture, canvas: HTMLCanvasElement, tools: PictureTools): ThingsTab {
  const form = new ThingForm();
  const list = element("ul", { class: "things", "aria-label": "Things that can be moved" });
  const hint = element("p", { class: "hint", role: "status" });
  let chosen: string | undefined;
  let shown = false;

  const place = (at: Triple) => {
    try {
      const { thing } = form;
      const name = freeName(thing.shape, new Set(picture.world.solids.map((solid) => solid.name)));
      void attempt(`New ${name}`, () => orders.apply(spawnEvent(thing, name, at)));
    } catch (error) {
      news.say(`It was not put there: ${(error as Error).message}`, "bad", "thing");
    }
  };
  const remove = (name: string) => void attempt(`Take ${name} away`, () => orders.apply(removeEvent(name)));
  const move = (solid: Solid, at: Triple, yaw_rad: number) => attempt(`Move ${solid.name}`, () => orders.apply(moveEvent(solid.name, at, yaw_rad)));
  const choose = (solid: Solid | undefined) => {
    chosen = solid?.name;
    fill();
    list.querySelector("[aria-current]")?.scrollIntoView({ block: "nearest" });
  };
  const tool = new ThingTool(picture, canvas, tools, { place, choose, move });
  const put = button("Put it where I click", () => {
    const on = !(tool.on && tool.places);
    tool.setOn(true);
    tool.places = on;
    tell();
  }, { id: "thing-put", class: "primary", "aria-pressed": "false" });
  const tell = () => {
    const places = tool.on && tool.places;
    put.setAttribute("aria-pressed", String(places));
    setText(put, places ? "Click a place in the picture" : "Put it where I click");
    setText(hint, list.childElementCount === 0 ? "Nothing here can be moved yet." : "Drag a thing in the picture to move it.");
  };
  const fill = () => {
    const things = picture.world.solids.filter((solid) => !isGround(solid) && mayBeTaken(solid) && (solid.movable || solid.kind === "thing" || solid.name === chosen));
    list.replaceChildren(...things.map((solid) => element("li", solid.name === chosen ? { "aria-current": "true" } : {}, element("span", {}, solid.name),
      button("Take away", () => remove(solid.name), { "aria-label": `Take ${solid.name} away` }))));
    tell();
  };
  tool.onToggle = tell;
  return {
    title: "Things", tool,
    content: element("div", { class: "things-tab" }, element("h2", {}, "A new thing"), form.box, put, element("h2", {}, "What can be moved"), hint, list),
    show: () => {
      shown = true;
      tool.setOn(true);
      fill();
    },
    hide: () => {
      shown = false;
      tools.done(tool);
    },
    worldChanged: () => shown && fill(),
  };
}
