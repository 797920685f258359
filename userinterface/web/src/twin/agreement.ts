// Whether the simulated and the real robot agree: the channels in the units that people read, the worst first, and a verdict. Passive.
import type { Channel, TwinState } from "./twin_state.ts";
import { oldAfter_s } from "./twin_state.ts";

const shownUnits: Record<string, { unit: string; times: number; decimals: number }> = {
  rad: { unit: "°", times: 180 / Math.PI, decimals: 1 },
  m: { unit: "m", times: 1, decimals: 2 },
  N: { unit: "N", times: 1, decimals: 0 },
};

export const spoken = (name: string) => name.replaceAll("_", " ");
export const unitOf = (unit: string) => shownUnits[unit] ?? { unit, times: 1, decimals: 2 };

// "3.4°", "0.12 m"; a dash where it is not known.
export function valueText(value: number, unit: string): string {
  if (!Number.isFinite(value)) return "–";
  const shown = unitOf(unit);
  const digits = Math.abs(value * shown.times).toFixed(shown.decimals);
  const minus = value < 0 && Number(digits) !== 0 ? "−" : "";
  return `${minus}${digits}${shown.unit === "°" ? "" : " "}${shown.unit}`;
}

// How much of its limit the difference takes; NaN: it is not known, or never told.
export const shareOf = ({ difference, limit }: Channel) => (limit > 0 ? difference / limit : NaN);
export const isAbove = (channel: Channel) => shareOf(channel) > 1;

// The worst first; then those of which nothing is known, as they came.
export function worstFirst(channels: readonly Channel[]): Channel[] {
  const rank = (channel: Channel) => {
    const share = shareOf(channel);
    return Number.isNaN(share) ? -1 : share;
  };
  return [...channels].sort((a, b) => rank(b) - rank(a));
}

export type Verdict = "agree" | "differ" | "unknown" | "lost";
export interface Agreement {
  verdict: Verdict;
  text: string; // a sentence
  short: string; // a few words
}

// Of a difference of place or heading, in a few words; undefined: it is of something else.
function placedWords({ name, difference }: Channel, channels: readonly Channel[]): string | undefined {
  if (name === "heading") return `looks ${((difference * 180) / Math.PI).toFixed(0)}° aside`;
  if (!name.startsWith("place")) return undefined;
  const apart_m = Math.hypot(...channels.filter((one) => one.name.startsWith("place") && Number.isFinite(one.difference)).map((one) => one.difference));
  return `stands ${apart_m.toFixed(1)} m beside`;
}

const words = { connecting: "is being connected", lost: "is lost", refused: "has been refused" } as const;

// `age_s`: of what was measured, by now.
export function agreementOf({ link, channels, follows, followsText }: TwinState, age_s: number): Agreement {
  if (link !== "connected") return { verdict: "lost", text: `Nothing is compared: the robot there ${words[link]}.`, short: `Robot there: ${link}` };
  if (!(age_s <= oldAfter_s)) return { verdict: "lost", text: "Nothing is compared: the robot there tells nothing new.", short: "Robot there: old" };
  if (!follows) return { verdict: "unknown", text: `Not compared: ${followsText || "the simulated robot does not do what the robot there does"}.`, short: followsText ? `Not compared: ${followsText}` : "Not compared" };
  const judged = worstFirst(channels).filter((channel) => Number.isFinite(shareOf(channel)));
  const [worst] = judged;
  if (!worst) return { verdict: "unknown", text: "Not compared: nothing is known of the last 2 s yet.", short: "Not compared yet" };
  const [name, by] = [spoken(worst.name), valueText(worst.difference, worst.unit)];
  const above = judged.filter(isAbove).length;
  const what = `${name}, ${by} (limit ${valueText(worst.limit, worst.unit)})`;
  if (above === 0) return { verdict: "agree", text: `Real and simulated agree. The largest difference: ${what}.`, short: "Real and simulated agree" };
  return { verdict: "differ", text: `${above} of ${judged.length} differ. Most of all: ${what}.`, short: placedWords(worst, channels) ?? `${name} differs by ${by}` };
}
