// The time line's arithmetic: where an instant lies on it, what is written beside it, where its marks are. Passive.
import type { Mark, MarkKind, SimulationState } from "./simulation_state.ts";

const shortest_s = 1; // of the line: a simulator that has just begun has a line, too

export function lineEnd_s({ recorded_s }: Pick<SimulationState, "recorded_s">): number {
  return Math.max(recorded_s, shortest_s);
}
// 0 at the beginning, 1 at the end.
export function shareOf(time_s: number, end_s: number): number {
  return Math.min(Math.max(time_s / end_s, 0), 1);
}
// The instant at this share, to a whole millisecond; none that has not been simulated.
export function instantAt(share: number, { recorded_s }: Pick<SimulationState, "recorded_s">): number {
  const time_s = Math.min(Math.max(share, 0) * lineEnd_s({ recorded_s }), recorded_s);
  return Math.min(Math.round(time_s * 1000), Math.floor(recorded_s * 1000 + 1e-6)) / 1000;
}

export const timeText = (time_s: number) => `${time_s.toFixed(3)} s`;

const least_s = 0.0005;
// Empty: nothing would be forgotten.
export function forgottenText(time_s: number, recorded_s: number): string {
  const after_s = recorded_s - time_s;
  return after_s > least_s ? `The ${timeText(after_s)} after this instant will be forgotten when it plays on.` : "";
}

export interface PlacedMark {
  share: number;
  kind: MarkKind;
  count: number; // of its kind so close that they would be drawn on one another
  at_s: number; // of the first of them
}
export const markNames: Record<MarkKind, string> = { command: "command", push: "push", fault: "fault", world: "change of the world", fall: "fall" };

// `least`: of the line, between two marks of a kind that are drawn apart.
export function placeMarks(marks: readonly Mark[], end_s: number, least: number): PlacedMark[] {
  const placed: PlacedMark[] = [];
  const newest = new Map<MarkKind, PlacedMark>();
  for (const { at_s, kind } of [...marks].sort((a, b) => a.at_s - b.at_s)) {
    const share = shareOf(at_s, end_s);
    const before = newest.get(kind);
    if (before && share - before.share < least) {
      before.count += 1;
      continue;
    }
    const mark = { share, kind, count: 1, at_s };
    placed.push(mark);
    newest.set(kind, mark);
  }
  return placed;
}

export function markText({ kind, count, at_s }: PlacedMark): string {
  return count === 1 ? `${markNames[kind]} at ${timeText(at_s)}` : `${count} × ${markNames[kind]} from ${timeText(at_s)}`;
}

// A whole number of the ticks that a person reads easily, ten at most.
export function tickEvery_s(end_s: number): number {
  const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600];
  return steps.find((step) => end_s / step <= 10) ?? Math.ceil(end_s / 36_000) * 3600;
}
