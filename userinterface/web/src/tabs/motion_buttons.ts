// A button for each motion, and beside it one that shows the motion before it is played. Pointing at a motion shows it, too.
import type { Context } from "../context.ts";
import { button, byId, element } from "../dom.ts";
import { MotionPreview } from "../motion_preview.ts";
import { loadMotions, motionText, type MotionEntry } from "../motions.ts";

const spoken = (name: string) => name.replaceAll("_", " ");

interface MotionButtons {
  group: HTMLElement;
  hide: () => void;
}

export function motionButtons(context: Context, play: (motion: string) => void, ...others: HTMLButtonElement[]): MotionButtons {
  const preview = new MotionPreview(context);
  byId("picture").append(preview.figure);
  let kept: HTMLButtonElement | undefined; // the toggle that is pressed
  let entries: Promise<Map<string, MotionEntry>> | undefined;
  const entryOf = async (name: string): Promise<MotionEntry> => {
    entries ??= loadMotions(context.token()).then((list) => new Map(list.map((entry) => [entry.name, entry])));
    try {
      return (await entries).get(name) ?? { name, refused: "it is not prepared: run `gaitway motion prepare`" };
    } catch (error) {
      entries = undefined; // the next one asks again
      return { name, refused: (error as Error).message };
    }
  };
  let wanted: string | undefined;
  const show = async (name: string) => {
    wanted = name;
    const entry = await entryOf(name);
    if (wanted === name) await preview.show(entry);
  };
  const hide = () => {
    wanted = undefined;
    preview.hide();
  };
  const keep = (toggle: HTMLButtonElement | undefined) => {
    kept?.setAttribute("aria-pressed", "false");
    kept = toggle;
    kept?.setAttribute("aria-pressed", "true");
  };
  const rest = () => (kept ? void show(kept.value) : hide());
  const pair = (name: string) => {
    const main = button(spoken(name), () => play(name));
    const toggle = button("▷", () => {
      keep(kept === toggle ? undefined : toggle);
      rest();
    }, { class: "show", value: name, "aria-pressed": "false", "aria-label": `Preview ${spoken(name)}`, title: "Preview: the robot does not move" });
    for (const part of [main, toggle]) {
      part.addEventListener("pointerenter", ({ pointerType }) => pointerType === "mouse" && void show(name));
      part.addEventListener("pointerleave", ({ pointerType }) => pointerType === "mouse" && rest());
      part.addEventListener("focus", () => part.matches(":focus-visible") && void show(name));
      part.addEventListener("blur", rest);
    }
    main.addEventListener("pointerenter", () => void entryOf(name).then((entry) => (main.title = motionText(entry))), { once: true });
    return element("span", { class: "motion" }, main, toggle);
  };
  return {
    group: element("div", { class: "buttons", role: "group", "aria-label": "Motions" }, ...context.description.motions.map(pair), ...others),
    hide: () => {
      keep(undefined);
      hide();
    },
  };
}
