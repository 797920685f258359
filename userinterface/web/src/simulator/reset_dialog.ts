// Asks whether the simulator is to be put back to its beginning.
import { button, element } from "../dom.ts";
import { timeText } from "./time_line.ts";

export function askToReset(recorded_s: number): Promise<boolean> {
  return new Promise((resolve) => {
    const dialog = element("dialog", { id: "reset-dialog", "aria-labelledby": "reset-title" },
      element("h2", { id: "reset-title" }, "Back to 0 s?"),
      element("p", {}, `The robot and the world begin anew, and the ${timeText(recorded_s)} that are recorded are forgotten.`),
      element("div", { class: "answers" }, button("Keep it", () => dialog.close(), { class: "plain", id: "reset-keep" }), button("Reset", () => dialog.close("reset"), { id: "reset-go" })));
    dialog.addEventListener("close", () => {
      dialog.remove();
      resolve(dialog.returnValue === "reset");
    });
    document.body.append(dialog);
    dialog.showModal();
  });
}
