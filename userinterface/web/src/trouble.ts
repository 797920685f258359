// What is wrong between this page and the robot, in the order in which a person wants to hear of it. Passive.
import { ageText } from "./freshness.ts";

// As /link_state tells it.
export interface LinkState {
  state: "up" | "down" | "refused";
  text: string;
  link: string;
  seconds: number;
}

export interface Knowledge {
  otherVersion?: string; // this page is not its server's any more: why, for people
  link?: LinkState;
  linkTold_ms: number; // when `link` came
  certificate: string; // what is wrong with it; empty: nothing
}

export interface Trouble {
  text: string;
  age?: string; // for so long: changes all the time, and is for the eyes alone
  weight: "bad" | "caution"; // bad: nothing works until it is mended
  action: "reload" | "hide" | undefined;
}

const sentence = (text: string) => (text === "" ? "" : text.charAt(0).toUpperCase() + text.slice(1) + (/[.?!]$/.test(text) ? "" : "."));

// Undefined: there is none.
export function troubleOf({ otherVersion, link, linkTold_ms, certificate }: Knowledge, now_ms: number): Trouble | undefined {
  if (otherVersion !== undefined) return { text: otherVersion, weight: "bad", action: "reload" };
  if (link && link.state !== "up") {
    const age = `For ${ageText(link.seconds * 1000 + now_ms - linkTold_ms)}.`;
    return { text: `${sentence(`the robot is not there: ${link.text}`)} ${sentence(certificate)}`.trim(), age, weight: "bad", action: undefined };
  }
  const text = [link?.text ?? "", certificate].map(sentence).join(" ").trim();
  return text === "" ? undefined : { text, weight: "caution", action: "hide" };
}
