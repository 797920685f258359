// Starts, ends and lists recordings.
import type { Context, Tab } from "../context.ts";
import { button, element, row, setText, table } from "../dom.ts";

interface Recording {
  file: string;
  bytes: number;
  start: { sec: number };
}

export function sizeText(bytes: number): string {
  return bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

const listEvery_ms = 1000;

export function recordingsTab({ robot, attempt, news }: Context): Tab {
  const name = element("input", { id: "recording-name", placeholder: "named by the time", pattern: "[A-Za-z0-9_.\\-]*", maxlength: 100 });
  const { table: listing, body } = table("Recordings (MCAP), the newest first", "file", "size", "begun");
  const more = element("p", { class: "hint path" });
  const sizes = new Map<string, number>();
  let listed_ms = -Infinity;
  // What has grown since it was looked at last is being recorded.
  const stateOf = ({ file, bytes }: Recording): string => {
    const before = sizes.get(file);
    sizes.set(file, bytes);
    return `${sizeText(bytes)}${before !== undefined && bytes > before ? ", recording" : ""}`;
  };
  const list = async () => {
    listed_ms = performance.now();
    const outcome = await robot.order("/recording/list");
    const recordings = outcome["recordings"] as Recording[];
    body.replaceChildren(...recordings.map((recording) =>
      row(element("span", { class: "path", title: recording.file }, recording.file.split("/").pop() ?? recording.file), stateOf(recording), new Date(recording.start.sec * 1000).toLocaleString())));
    const folder = recordings[0]?.file.replace(/\/[^/]*$/, "");
    setText(more, folder === undefined ? "There are none yet." : `On the robot's computer, in ${folder}. ${outcome.message}`);
  };
  const listAgain = () => void list().catch((error: Error) => news.say(error.message, "bad"));
  const begin = () => void attempt("Recording", () => robot.order("/recording/start", { name: name.value }), "begun").then(listAgain);
  const start = button("Record", begin);
  const stop = button("End the recording", () => void attempt("Recording", () => robot.order("/recording/stop", {}, 10_000), "ended").then(listAgain));
  name.addEventListener("keydown", (event) => event.key === "Enter" && begin());
  const content = element("div", { class: "recordings" },
    element("div", { class: "tools" }, element("label", { for: "recording-name" }, "Name"), name, start, stop),
    listing, more);
  return {
    title: "Recordings",
    content,
    show: listAgain,
    look: (now_ms) => {
      if (robot.isOpen && now_ms - listed_ms > listEvery_ms) void list().catch(() => {}); // the page tells a lost connection elsewhere
    },
  };
}
