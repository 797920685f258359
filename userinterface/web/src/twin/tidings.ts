// What has happened between two states that people are to be told. Passive.
import type { Weight } from "../news.ts";
import type { TwinState } from "./twin_state.ts";

export interface Tiding {
  about: string;
  text: string;
  weight: Weight;
}

// Of what the twin told: all but a link that is there, and something that the robot there has done.
export const isWarning = (told: string) => !/^connected\b|\bdone$|: done: /.test(told);

const because = (text: string) => (text ? `: ${text}` : "");

function ofLink(before: TwinState, { link, text, robot }: TwinState): Tiding[] {
  if (before.link === link) return [];
  const about = "robot there";
  if (link === "connected") return [{ about, text: `The robot there is connected${robot ? `: ${robot}` : ""}`, weight: "good" }];
  if (link === "lost") return [{ about, text: `The robot there is lost${because(text)}. It is tried again by itself.`, weight: "bad" }];
  if (link === "refused") return [{ about, text: `The robot there has been refused${because(text)}. It is not tried again before you press Connect again.`, weight: "bad" }];
  return [];
}

function ofSending(before: TwinState, { sending, sendingWhat, sendingText }: TwinState): Tiding[] {
  if (before.sending === sending) return [];
  const about = "sending";
  switch (sending) {
    case "sending":
      return [{ about, text: `The robot there begins: ${sendingWhat}`, weight: "plain" }];
    case "done":
      return [{ about, text: `The robot there has done it: ${sendingWhat}`, weight: "good" }];
    case "not passed":
      return [{ about, text: `Not sent: ${sendingWhat}${because(sendingText)}`, weight: "bad" }];
    case "failed":
      return [{ about, text: `Sending has failed: ${sendingWhat}${because(sendingText)}`, weight: "bad" }];
    case "stopped":
      return [{ about, text: `Stopped: ${sendingWhat}${because(sendingText)}`, weight: "plain" }];
    default:
      return [];
  }
}

export function tidingsOf(before: TwinState, after: TwinState): Tiding[] {
  const ended = before.follows && !after.follows && after.followsText !== "";
  const follows: Tiding[] = ended ? [{ about: "follows", text: `The simulated robot does not follow any more: ${after.followsText}`, weight: "plain" }] : [];
  return [...ofLink(before, after), ...follows, ...ofSending(before, after)];
}
