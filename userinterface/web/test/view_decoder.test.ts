// The robot's own example of a frame, decoded.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { acknowledgement, commanderOf, decodeView, frameBytes, hasTrouble, WrongVersion, type RowName } from "../src/view_decoder.ts";
import { viewRows } from "../src/view_layout.ts";

const golden = JSON.parse(readFileSync(new URL("view_golden.json", import.meta.url), "utf8")) as { bytes: string; values: Record<RowName, (number | null)[]> };
const goldenBytes = () => Uint8Array.from(golden.bytes.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16)).buffer;
const largest: Record<string, number> = { uint8: 254, int16: 32767, uint16: 65534, int32: 2147483647, uint32: 4294967294 };

test("every row is what the robot meant", () => {
  const frame = decodeView(goldenBytes());
  for (const row of viewRows) {
    const wanted = golden.values[row.name];
    assert.equal(frame[row.name].length, wanted.length, row.name);
    for (const [index, value] of frame[row.name].entries()) {
      const meant = wanted[index];
      if (meant === null || meant === undefined) assert.ok(Number.isNaN(value), `${row.name}[${index}]`);
      else if (row.scale === 0) assert.equal(value, meant % (row.type === "uint16" ? 65536 : 2 ** 32), `${row.name}[${index}]`);
      else {
        const end = (largest[row.type] ?? 0) * row.scale;
        assert.ok(Math.abs(value - Math.max(-end, Math.min(end, meant))) <= row.scale / 2 + 1e-9, `${row.name}[${index}]: ${value}, not ${meant}`);
      }
    }
  }
});

test("names, faults and acknowledgement", () => {
  const frame = decodeView(goldenBytes());
  assert.equal(commanderOf(frame), "page é7");
  assert.deepEqual([0, 1, 8, 9, 39].map((joint) => hasTrouble(frame, joint)), [true, false, false, true, true]);
  assert.deepEqual([...acknowledgement(frame)], [4, 3, 2, 1]);
});

test("a frame of another layout, and one that is cut off, are refused", () => {
  const other = goldenBytes();
  new DataView(other).setUint8(0, 99);
  assert.throws(() => decodeView(other), WrongVersion);
  assert.throws(() => decodeView(goldenBytes().slice(0, -1)), RangeError);
  assert.throws(() => decodeView(new ArrayBuffer(0)), RangeError);
});

test("a frame has at most 200 bytes", () => assert.ok(frameBytes(40) <= 200 && frameBytes(22) < 170));
