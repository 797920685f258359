// What happened to what people asked for: said in words, the newest last.
import { element } from "./dom.ts";

export type Weight = "good" | "plain" | "bad";
const shown_ms: Record<Weight, number> = { good: 4000, plain: 6000, bad: 12_000 };
const atMost = 4;

export class News {
  constructor(private readonly list: HTMLElement) {}

  // What is said again, or of the same thing as before, takes the place of what was said.
  say(text: string, weight: Weight = "plain", about = text): void {
    for (const said of [...this.list.children]) {
      if (said instanceof HTMLElement && said.dataset["about"] === about) said.remove();
    }
    const item = element("p", { class: weight, "data-about": about }, text);
    this.list.append(item);
    while (this.list.childElementCount > atMost) this.list.firstElementChild?.remove();
    setTimeout(() => item.remove(), shown_ms[weight]);
  }
}
