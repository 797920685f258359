// Starts, ends and lists recordings.
import type { Context, Tab } from "../context.ts";
import { button, element, row, table } from "../dom.ts";

interface Recording {
  file: string;
  bytes: number;
  start: { sec: number };
}

export function sizeText(bytes: number): string {
  return bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

export function recordingsTab({ robot, attempt, news }: Context): Tab {
  const name = element("input", { id: "recording-name", placeholder: "named by the time", pattern: "[A-Za-z0-9_.\\-]*", maxlength: 100 });
  const { table: listing, body } = table("Recordings (MCAP), the newest first", "file", "size", "begun");
  const more = element("p", { class: "hint" });
  const list = async () => {
    const outcome = await robot.order("/recording/list");
    const recordings = outcome["recordings"] as Recording[];
    body.replaceChildren(...recordings.map(({ file, bytes, start }) =>
      row(element("span", { class: "path", title: file }, file.split("/").pop() ?? file), sizeText(bytes), new Date(start.sec * 1000).toLocaleString())));
    more.textContent = recordings.length === 0 ? "There are none yet." : outcome.message;
  };
  const listAgain = () => void list().catch((error: Error) => news.say(error.message, "bad"));
  const start = button("Record", () => void attempt("Recording", () => robot.order("/recording/start", { name: name.value })).then(listAgain));
  const stop = button("End the recording", () => void attempt("End of the recording", () => robot.order("/recording/stop", {}, 10_000)).then(listAgain));
  const content = element("div", { class: "recordings" },
    element("div", { class: "tools" }, element("label", { for: "recording-name" }, "Name"), name, start, stop, button("List again", listAgain)),
    listing, more);
  return { title: "Recordings", content, show: listAgain };
}
