// Says over the picture what is wrong between this page and the robot, for as long as it is.
import { byId, setText } from "./dom.ts";
import type { Message, Rosbridge } from "./rosbridge.ts";
import { troubleOf, type Knowledge, type LinkState } from "./trouble.ts";

export class LinkBanner {
  private readonly box = byId("trouble");
  private readonly text = byId("trouble-text");
  private readonly age = byId("trouble-age");
  private readonly button = byId<HTMLButtonElement>("trouble-button");
  private readonly known: Knowledge = { linkTold_ms: 0, certificate: "" };
  rests = false; // a simulated robot is paused: that nothing comes from it is as it should be
  private hidden = ""; // the text that a person has seen enough of

  constructor(private readonly robot: Rosbridge) {
    robot.subscribe("/link_state", "gaitway_msgs/msg/LinkState", 0, (message: Message) => {
      this.known.link = message as unknown as LinkState;
      this.known.linkTold_ms = performance.now();
    });
    robot.subscribe("/certificate_state", "std_msgs/msg/String", 0, (message: Message) => (this.known.certificate = String(message["data"])));
    this.button.addEventListener("click", () => {
      if (this.known.otherVersion !== undefined) location.reload();
      else this.hidden = this.text.textContent ?? "";
    });
  }

  // For good: only a page that is loaded again is of the right version.
  otherVersion(text: string): void {
    this.known.otherVersion = text;
  }

  look(now_ms: number): void {
    // Without a connection nobody tells how the link is.
    if (!this.robot.isOpen) delete this.known.link;
    const { link, ...others } = this.known;
    const trouble = troubleOf(link && !this.rests ? this.known : others, now_ms);
    this.box.hidden = !trouble || (trouble.action === "hide" && trouble.text === this.hidden);
    if (!trouble) return;
    this.box.className = `trouble ${trouble.weight}`;
    setText(this.text, trouble.text);
    setText(this.age, trouble.age ?? "");
    this.button.hidden = trouble.action === undefined;
    setText(this.button, trouble.action === "reload" ? "Load again" : "Hide");
  }
}
