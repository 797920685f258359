// Says where a mission commands the robot, or waits because a person does; and lets it go on.
import { authorityOf, commandOf, stateOf, type BehaviourState, type CommandState } from "./behaviour_messages.ts";
import type { Context } from "./context.ts";
import { byId, setText } from "./dom.ts";
import { nobodyCommands } from "./status_bar.ts";

const old_ms = 3000; // of the behaviour's state, which comes each second at least

export class AuthorityBanner {
  private readonly box = byId("authority");
  private readonly text = byId("authority-text");
  private readonly person = byId("commander"); // which of them has the command, of the status bar
  private readonly button = byId<HTMLButtonElement>("let-go");
  private command: CommandState | undefined;
  private behaviour: BehaviourState | undefined;
  private behaviour_ms = -Infinity;

  constructor(private readonly context: Context) {
    const { robot, attempt, command } = context;
    this.button.addEventListener("click", () => void attempt("Let the behaviour command", () => command.during(() => robot.order("/command/let_go"))));
    robot.subscribe("/command/state", "gaitway_msgs/msg/CommandState", 0, (message) => (this.command = commandOf(message)));
    robot.subscribe("/behaviour/state", "gaitway_msgs/msg/BehaviourState", 0, (message) => {
      this.behaviour = stateOf(message);
      this.behaviour_ms = performance.now();
    });
  }

  look(now_ms: number): void {
    const { robot } = this.context;
    const authority = robot.isOpen ? authorityOf(this.command, now_ms - this.behaviour_ms > old_ms ? undefined : this.behaviour) : undefined;
    this.box.hidden = authority === undefined;
    this.person.hidden = authority !== undefined && this.person.textContent === nobodyCommands;
    if (!authority) return;
    setText(this.text, authority.text);
    this.text.title = authority.why;
    this.button.hidden = !authority.lets_go;
  }
}
