// Tabs as assistive technology knows them: one is in the tab order, arrows go between them.
import type { Tab } from "./context.ts";
import { element } from "./dom.ts";

export class TabBar {
  private current: Tab | undefined;
  private readonly buttons = new Map<Tab, HTMLButtonElement>();

  constructor(
    private readonly bar: HTMLElement,
    private readonly panels: HTMLElement,
    tabs: readonly Tab[],
  ) {
    this.add(...tabs);
    bar.addEventListener("keydown", (event) => this.step(event, [...this.buttons.keys()]));
    if (tabs[0]) this.open(tabs[0]);
  }

  add(...tabs: readonly Tab[]): void {
    for (const tab of tabs) {
      const id = `tab-${this.buttons.size}`;
      const button = element("button", { type: "button", role: "tab", id, "aria-controls": `${id}-panel`, "aria-selected": "false", tabindex: -1 }, tab.title);
      tab.content.id = `${id}-panel`;
      tab.content.setAttribute("role", "tabpanel");
      tab.content.setAttribute("aria-labelledby", id);
      tab.content.hidden = true;
      button.addEventListener("click", () => this.open(tab));
      this.buttons.set(tab, button);
      this.bar.append(button);
      this.panels.append(tab.content);
    }
  }

  look(now_ms: number): void {
    this.current?.look?.(now_ms);
  }

  open(tab: Tab): void {
    if (tab === this.current) return;
    this.current?.hide?.();
    this.current = tab;
    for (const [other, button] of this.buttons) {
      const chosen = other === tab;
      button.setAttribute("aria-selected", String(chosen));
      button.tabIndex = chosen ? 0 : -1;
      other.content.hidden = !chosen;
    }
    this.buttons.get(tab)?.scrollIntoView({ inline: "nearest", block: "nearest" });
    this.panels.scrollTop = 0;
    tab.show?.();
    tab.look?.(performance.now());
  }

  private step(event: KeyboardEvent, tabs: readonly Tab[]): void {
    const steps: Record<string, number> = { ArrowRight: 1, ArrowLeft: -1 };
    const step = steps[event.key];
    if (step === undefined || !this.current) return;
    event.preventDefault();
    event.stopPropagation(); // the arrows drive elsewhere
    const next = tabs[(tabs.indexOf(this.current) + step + tabs.length) % tabs.length];
    if (!next) return;
    this.open(next);
    this.buttons.get(next)?.focus();
  }
}
