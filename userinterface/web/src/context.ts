// What every part of the page knows of the robot.
import type { Command } from "./command.ts";
import type { Description } from "./description.ts";
import type { Drive } from "./drive.ts";
import type { Freshness } from "./freshness.ts";
import type { News } from "./news.ts";
import type { Rosbridge } from "./rosbridge.ts";
import type { ViewFrame } from "./view_decoder.ts";

export interface Context {
  readonly description: Description;
  readonly freshness: Freshness;
  readonly robot: Rosbridge;
  readonly command: Command;
  readonly drive: Drive;
  readonly news: News;
  readonly token: () => string | undefined;
  readonly frameTakers: ((frame: ViewFrame) => void)[];
  // Carries out what a person asked for; what became of it is told. Gives whether it was done; `done`: in one word,
  // where that is only its beginning.
  readonly attempt: (what: string, order: () => Promise<unknown>, done?: string) => Promise<boolean>;
}

// One of the views beside the picture. `look`: a few times a second while it is shown.
export interface Tab {
  readonly title: string;
  readonly content: HTMLElement;
  readonly show?: () => void;
  readonly hide?: () => void;
  readonly look?: (now_ms: number) => void;
}
