// Asks whether the simulator is to be put back to its beginning.
import { button, element } from "../dom.ts";
import { openAbove } from "../above_page.ts";
import { timeText } from "./time_line.ts";

// False: it is not, or is being asked already.
export function askToReset(recorded_s: number): Promise<boolean> {
  const asked = document.getElementById("reset-keep");
  if (asked) {
    asked.focus();
    return Promise.resolve(false);
  }
  return new Promise((resolve) => {
    const dialog = element("dialog", { id: "reset-dialog", "aria-labelledby": "reset-title" },
      element("h2", { id: "reset-title" }, "Back to 0 s?"),
      element("p", {}, `The robot and the world begin anew, and all that is recorded is forgotten, ${timeText(recorded_s)} by now.`),
      element("div", { class: "answers" }, button("Keep it", () => dialog.close(), { class: "plain", id: "reset-keep" }), button("Reset", () => dialog.close("reset"), { id: "reset-go" })));
    openAbove(dialog, () => resolve(dialog.returnValue === "reset"));
  });
}
