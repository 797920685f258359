// What a pre-flight's robots and the stages of what was sent are marked with. Passive.
import type { TwinState } from "./twin_state.ts";

// up: stayed up and did it. fell. refused: stayed up, and did not do it. failed: one of the two, and it is not told which.
export const markNames = { up: "stayed up and did it", fell: "fell", refused: "did not do it", failed: "fell or did not do it" } as const;
export type Mark = keyof typeof markNames;
export type StageMark = "now" | "good" | "bad" | "";
const mostMarked = 1000; // whatever is told
type Verdict = Pick<TwinState, "passed" | "tried" | "sendingText">;

// Of each robot that was tried. The verdict tells how the worst one ended, and falling is the worst: where it did not fall, none did.
export function marksOf({ passed, tried, sendingText }: Verdict): Mark[] {
  const robots = Math.min(tried, mostMarked);
  const up = Math.min(passed, robots);
  const worst: Mark = /; robot \d+ fell after /.test(sendingText) ? "fell" : /; robot \d+: /.test(sendingText) ? "refused" : "failed";
  return Array.from({ length: robots }, (_none, index) => (index < up ? "up" : worst === "fell" && index > up ? "failed" : worst));
}

// "17 stayed up and did it, 3 did not do it".
export function marksText(marks: readonly Mark[]): string {
  const counts = (Object.keys(markNames) as Mark[]).map((mark) => ({ mark, count: marks.filter((one) => one === mark).length }));
  return counts.filter(({ count }) => count > 0).map(({ mark, count }) => `${count} ${markNames[mark]}`).join(", ");
}

// Of the three stages: try, verdict, robot there. Where there is no verdict, nothing was sent.
export function stagesOf({ sending, passed, tried }: Pick<TwinState, "sending" | "passed" | "tried">): readonly StageMark[] {
  const verdict = passed === tried ? "good" : "bad";
  switch (sending) {
    case "trying":
      return ["now", "", ""];
    case "sending":
      return ["good", verdict, "now"];
    case "done":
      return ["good", verdict, "good"];
    case "not passed":
      return ["good", "bad", ""];
    case "failed":
      return tried > 0 ? ["good", verdict, "bad"] : ["bad", "", ""];
    default:
      return ["", "", ""];
  }
}
