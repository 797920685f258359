// From a touch on the page's emergency stop to its bytes at the module's socket: a headless Chromium is touched, and what stands between it and the
// module notes when the call comes. For each touch a line with both instants, in ns of CLOCK_MONOTONIC; then it waits for a line before the next.
//
//     touch_path.mjs PORT TOUCHES     (command_path.py calls it)
import net from "node:net";
import readline from "node:readline";
import { openBrowser, RobotPage } from "../../../tests/clients/page_browser.mjs";

const [port, touches] = process.argv.slice(2).map(Number);
let heard = () => {};

// Of whole frames from a client, whose payloads are masked.
function* payloads(state, bytes) {
  state.unread = Buffer.concat([state.unread, bytes]);
  if (!state.open) {
    const end = state.unread.indexOf("\r\n\r\n");
    if (end < 0) return;
    state.open = true;
    state.unread = state.unread.subarray(end + 4);
  }
  while (state.unread.length >= 6) {
    const short = state.unread[1] & 127;
    const head = short === 126 ? 4 : 2;
    const size = short === 126 ? state.unread.readUInt16BE(2) : short;
    if (state.unread.length < head + 4 + size) return;
    const mask = state.unread.subarray(head, head + 4);
    yield state.unread.subarray(head + 4, head + 4 + size).map((byte, i) => byte ^ mask[i % 4]).toString();
    state.unread = state.unread.subarray(head + 4 + size);
  }
}

const tap = net.createServer((near) => {
  const far = net.connect(port, "127.0.0.1");
  const state = { unread: Buffer.alloc(0), open: false };
  for (const [from, to] of [[near, far], [far, near]]) {
    from.setNoDelay(true);
    from.on("data", (bytes) => {
      const at = process.hrtime.bigint();
      to.write(bytes);
      if (from === near) for (const text of payloads(state, bytes)) if (text.includes("/emergency_stop")) heard(at);
    });
    from.on("end", () => to.end());
    from.on("error", () => to.destroy());
  }
});
await new Promise((resolve) => tap.listen(0, "127.0.0.1", resolve));
const browser = await openBrowser();
const lines = readline.createInterface({ input: process.stdin })[Symbol.asyncIterator]();
try {
  const robot = await RobotPage.open(browser, `http://127.0.0.1:${tap.address().port}/`, { width: 800, height: 900, hasTouch: true });
  await robot.live();
  const box = await (await robot.page.$("#emergency")).boundingBox();
  for (let touch = 0; touch < touches; ++touch) {
    await robot.until(() => !document.getElementById("activity").textContent.includes("emergency stop"), "released");
    const called = new Promise((resolve) => (heard = resolve));
    const at = process.hrtime.bigint();
    const tapped = robot.page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
    console.log(`${at} ${await called}`);
    await tapped;
    await lines.next();
  }
} finally {
  await browser.close();
  tap.close();
  process.exit();
}
