// What becomes of what was sent: being tried, the verdict with the worst simulated robot, and whether the robot there does it. What did not
// pass may be sent with a reason.
import { element, setText } from "../dom.ts";
import { leastReason } from "./send_request.ts";
import type { Sending, TwinState } from "./twin_state.ts";

const robots = 20; // of a pre-flight
const headings: Record<Sending, string> = {
  idle: "", trying: "Being tried on simulated robots", sending: "The robot there does it", done: "Done", "not passed": "Not sent", failed: "Failed", stopped: "Stopped",
};
// Of the three stages: try, verdict, robot there.
const stages: Record<Sending, readonly string[]> = {
  idle: [], trying: ["now", "", ""], sending: ["good", "good", "now"], done: ["good", "good", "good"], "not passed": ["good", "bad", ""], failed: ["", "", "bad"], stopped: ["", "", ""],
};

export class SendingCard {
  readonly box: HTMLElement;
  private readonly heading = element("h2", { id: "twin-sending", role: "status" });
  private readonly what = element("p", { class: "sending-what", id: "twin-sending-what" });
  private readonly stages = ["Try", "Verdict", "Robot there"].map((name) => element("li", {}, name));
  private readonly dots = Array.from({ length: robots }, () => element("i"));
  private readonly dotRow = element("div", { class: "robots", role: "img" }, ...this.dots);
  private readonly text = element("p", { id: "twin-sending-text" });
  private readonly canvas = element("canvas", { id: "twin-worst", role: "img", "aria-label": "The worst of the simulated robots" });
  private readonly figure = element("figure", { class: "worst", hidden: true }, this.canvas, element("figcaption", {}, "The worst of the simulated robots"));
  private readonly reason = element("textarea", { id: "twin-reason", rows: 2, minlength: leastReason, "aria-describedby": "twin-reason-note" });
  private readonly reasonForm: HTMLFormElement;
  private readonly elsewhere = element("p", { class: "note" }, "It was sent from elsewhere: only there it can be sent nevertheless.");

  constructor(private readonly nevertheless: (reason: string) => void) {
    this.reasonForm = element("form", { class: "reason", novalidate: true, hidden: true },
      element("label", { for: "twin-reason" }, "Why is it to be sent nevertheless?", this.reason),
      element("p", { class: "note", id: "twin-reason-note" }, `At least ${leastReason} characters. The reason is recorded with what is sent.`),
      element("button", { type: "submit", id: "twin-nevertheless", class: "danger" }, "Send it nevertheless"));
    this.reasonForm.addEventListener("submit", (event) => {
      event.preventDefault();
      this.nevertheless(this.reason.value);
    });
    this.box = element("section", { class: "sending", "aria-labelledby": "twin-sending", hidden: true }, this.heading, this.what,
      element("ol", { class: "stages" }, ...this.stages), this.dotRow, this.text, this.figure, this.reasonForm, this.elsewhere);
  }

  // `mine`: this page has sent it.
  show({ sending, sendingWhat, sendingText, passed, tried }: TwinState, mine: boolean): void {
    this.box.hidden = sending === "idle";
    this.box.dataset["sending"] = sending;
    setText(this.heading, headings[sending]);
    setText(this.what, sendingWhat);
    setText(this.text, sendingText);
    for (const [index, stage] of this.stages.entries()) stage.className = stages[sending][index] ?? "";
    for (const [index, dot] of this.dots.entries()) dot.className = index < Math.min(passed, tried) ? "up" : index < tried ? "fell" : "";
    this.dotRow.hidden = tried === 0 && sending !== "trying";
    this.dotRow.setAttribute("aria-label", tried === 0 ? "None has been tried yet" : `${passed} of ${tried} stayed up`);
    const refused = sending === "not passed";
    if (!refused && !this.reasonForm.hidden) this.reason.value = "";
    this.reasonForm.hidden = !refused || !mine;
    this.elsewhere.hidden = !refused || mine;
    if (sending === "trying") this.figure.hidden = true;
  }

  // PNG. The page's policy lets no image come from a blob: it is decoded and drawn.
  async showPicture(png: Uint8Array<ArrayBuffer>): Promise<void> {
    const bitmap = await createImageBitmap(new Blob([png], { type: "image/png" }));
    this.canvas.width = bitmap.width;
    this.canvas.height = bitmap.height;
    this.canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
    bitmap.close();
    this.figure.hidden = false;
  }
  hidePicture(): void {
    this.figure.hidden = true;
  }
}
