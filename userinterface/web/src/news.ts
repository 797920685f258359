// What happened to what people asked for: said in words, the newest last.
import { element } from "./dom.ts";

export type Weight = "good" | "plain" | "bad";
const shown_ms: Record<Weight, number> = { good: 4000, plain: 6000, bad: 12_000 };
const atMost = 4;

export class News {
  constructor(private readonly list: HTMLElement) {}

  say(text: string, weight: Weight = "plain"): void {
    const last = this.list.lastElementChild;
    if (last instanceof HTMLElement && last.dataset["text"] === text) last.remove();
    const item = element("p", { class: weight, "data-text": text }, text);
    this.list.append(item);
    while (this.list.childElementCount > atMost) this.list.firstElementChild?.remove();
    setTimeout(() => item.remove(), shown_ms[weight]);
  }
}
