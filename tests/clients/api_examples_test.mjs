// Sends each example of the reference, in its order, and looks for the answer that it promises.
// Arguments: the API's port, the file with the examples.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import WebSocket from "ws";

const kPatience_ms = 15000;
const examples = JSON.parse(readFileSync(process.argv[3], "utf8"));
const socket = new WebSocket(`ws://127.0.0.1:${process.argv[2]}`);
const waiting = [];
let heard = () => {};
socket.on("message", (data, binary) => {
  waiting.push(binary ? { binary: true } : JSON.parse(data.toString()));
  heard();
});
await new Promise((resolve, reject) => socket.once("open", resolve).once("error", reject));

const holds = (answer, promised) =>
  Object.entries(promised).every(([key, value]) => JSON.stringify(answer[key]) === JSON.stringify(value));

// What comes until the promised answer does; errors on the way are failures, but for what asks for one.
async function answerTo(example) {
  const end = Date.now() + kPatience_ms;
  for (;;) {
    while (waiting.length > 0) {
      const message = waiting.shift();
      if (holds(message, example.answer)) {
        return message;
      }
      if (message.op === "status" && message.level === "error") {
        throw new Error(`${example.name}: ${message.msg}`);
      }
    }
    const left = end - Date.now();
    if (left <= 0) {
      throw new Error(`${example.name}: no answer like ${JSON.stringify(example.answer)}`);
    }
    await new Promise((resolve) => {
      const timer = setTimeout(resolve, left);
      heard = () => (clearTimeout(timer), resolve());
    });
  }
}

let answered = 0;
for (const example of examples) {
  socket.send(JSON.stringify(example.send));
  if (example.answer !== null) {
    await answerTo(example);
    ++answered;
  }
}
assert.equal(socket.readyState, WebSocket.OPEN, "none of the examples ends the connection");
console.log(`${examples.length} examples sent, ${answered} answers as promised`);
process.exit(0);
