// A list of names and values, whose values are written anew as they change.
import { element, setText } from "./dom.ts";

export class Facts {
  readonly list = element("dl", { class: "facts" });
  private readonly values = new Map<string, HTMLElement>();

  set(name: string, text: string, bad = false): void {
    let value = this.values.get(name);
    if (!value) {
      value = element("dd");
      this.values.set(name, value);
      this.list.append(element("div", {}, element("dt", {}, name), value));
    }
    setText(value, text);
    value.classList.toggle("bad", bad);
  }
}
