// What becomes of what was sent: being tried, the verdict with the worst simulated robot, and whether the robot there does it. What did not
// pass may be sent with a reason.
import { element, setText } from "../dom.ts";
import { marksOf, marksText, stagesOf } from "./flight_marks.ts";
import { charactersOf, leastReason } from "./send_request.ts";
import { WorstPicture } from "./worst_picture.ts";
import type { Sending, TwinState } from "./twin_state.ts";

const robots = 20; // of a pre-flight
const headings: Record<Sending, string> = {
  idle: "", trying: "Being tried on simulated robots", sending: "The robot there does it", done: "Done", "not passed": "Not sent", failed: "Failed", stopped: "Stopped",
};

export class SendingCard {
  readonly box: HTMLElement;
  readonly worst = new WorstPicture();
  private readonly heading = element("h2", { id: "twin-sending", role: "status" });
  private readonly what = element("p", { class: "sending-what", id: "twin-sending-what" });
  private readonly stages = ["Try", "Verdict", "Robot there"].map((name) => element("li", {}, name));
  private readonly dots = Array.from({ length: robots }, () => element("i"));
  private readonly dotRow = element("div", { class: "robots", role: "img" }, ...this.dots);
  private readonly counts = element("p", { class: "note", id: "twin-robots" });
  private readonly text = element("p", { id: "twin-sending-text" });
  private readonly reason = element("textarea", { id: "twin-reason", rows: 2, minlength: leastReason, "aria-describedby": "twin-reason-note" });
  private readonly count = element("span", { id: "twin-reason-count", class: "number" });
  private readonly submit = element("button", { type: "submit", id: "twin-nevertheless", class: "danger", disabled: true }, "Send it nevertheless");
  private readonly reasonForm: HTMLFormElement;
  private readonly elsewhere = element("p", { class: "note" }, "It was sent from elsewhere: only there it can be sent nevertheless.");

  constructor(private readonly nevertheless: (reason: string) => void) {
    this.reasonForm = element("form", { class: "reason", novalidate: true, hidden: true },
      element("label", { for: "twin-reason" }, "Why is it to be sent nevertheless?", this.reason),
      element("p", { class: "note", id: "twin-reason-note" }, this.count, " The reason is recorded with what is sent. It is tried again on simulated robots first, and then sent even if some of them fall."), this.submit);
    this.reason.addEventListener("input", () => this.countReason());
    this.countReason();
    this.reasonForm.addEventListener("submit", (event) => {
      event.preventDefault();
      if (!this.submit.disabled) this.nevertheless(this.reason.value);
    });
    this.box = element("section", { class: "sending", "aria-labelledby": "twin-sending", hidden: true }, this.heading, this.what,
      element("ol", { class: "stages" }, ...this.stages), this.dotRow, this.counts, this.text, this.worst.figure, this.reasonForm, this.elsewhere);
  }

  // `mine`: this page has sent it.
  show(state: TwinState, mine: boolean): void {
    const { sending, sendingWhat, sendingText, tried } = state;
    this.box.hidden = sending === "idle";
    this.box.dataset["sending"] = sending;
    setText(this.heading, headings[sending]);
    setText(this.what, sendingWhat);
    setText(this.text, sendingText);
    const stages = stagesOf(state);
    for (const [index, stage] of this.stages.entries()) stage.className = stages[index] ?? "";
    const marks = marksOf(state);
    for (const [index, dot] of this.dots.entries()) dot.className = marks[index] ?? "";
    setText(this.counts, marksText(marks));
    this.counts.hidden = tried === 0;
    this.dotRow.hidden = tried === 0 && sending !== "trying";
    this.dotRow.setAttribute("aria-label", marksText(marks) || "None has been tried yet");
    const refused = sending === "not passed";
    if (!refused && !this.reasonForm.hidden) {
      this.reason.value = "";
      this.countReason();
    }
    this.reasonForm.hidden = !refused || !mine;
    this.elsewhere.hidden = !refused || mine;
    if (sending === "trying") this.worst.hide();
  }

  private countReason(): void {
    const count = charactersOf(this.reason.value);
    this.submit.disabled = count < leastReason;
    setText(this.count, count < leastReason ? `${count} of ${leastReason} characters.` : `${count} characters.`);
  }
}
