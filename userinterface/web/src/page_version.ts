// Which page this is, and which one its server has by now. A page that was left open while the robot's software changed
// must not read what the new one says.

declare const PAGE_VERSION: string; // build.mjs puts it in

export const pageVersion: string = typeof PAGE_VERSION === "undefined" ? "" : PAGE_VERSION;

const patience_ms = 2000; // or requests pile up while nobody answers

// The server's page; empty: one from before pages had versions. Throws while it does not answer.
export async function servedVersion(): Promise<string> {
  const answer = await fetch("version.json", { cache: "no-store", signal: AbortSignal.timeout(patience_ms) });
  if (answer.status === 404) return "";
  if (!answer.ok) throw new Error(await answer.text());
  return String(((await answer.json()) as { page?: unknown }).page ?? "");
}

export function otherVersionText(served: string): string {
  const theirs = served === "" ? "an older page, without a version" : `page ${served}`;
  return `This page is of another version than the robot's software: this is page ${pageVersion}, the robot has ${theirs}. It is not understood any more: load the page again. Stop still works.`;
}
