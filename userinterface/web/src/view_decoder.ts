// The robot's view frame, decoded by the table that the robot itself encodes it with.
import { viewRows, viewVersion, type ViewRow, type ViewType } from "./view_layout.ts";

const bytesOf: Record<ViewType, number> = { uint8: 1, int16: 2, uint16: 2, int32: 4, uint32: 4 };
const unknownOf: Record<ViewType, number> = { uint8: 255, int16: -32768, uint16: 65535, int32: -2147483648, uint32: 4294967295 };

export type RowName = (typeof viewRows)[number]["name"];
// What is not known is NaN.
export type ViewFrame = Record<RowName, number[]>;

export class WrongVersion extends Error {}

function rawAt(bytes: DataView, type: ViewType, offset: number): number {
  switch (type) {
    case "uint8":
      return bytes.getUint8(offset);
    case "int16":
      return bytes.getInt16(offset, true);
    case "uint16":
      return bytes.getUint16(offset, true);
    case "int32":
      return bytes.getInt32(offset, true);
    case "uint32":
      return bytes.getUint32(offset, true);
  }
}

function valueOf(row: ViewRow, raw: number): number {
  if (row.scale === 0) return raw;
  return raw === unknownOf[row.type] ? NaN : raw * row.scale;
}

export function frameBytes(jointCount: number): number {
  return viewRows.reduce((sum, row) => sum + bytesOf[row.type] * (row.count || jointCount), 0);
}

// Throws WrongVersion for a frame of another layout, and RangeError for one that is cut off or too long.
export function decodeView(buffer: ArrayBuffer): ViewFrame {
  const bytes = new DataView(buffer);
  if (bytes.getUint8(0) !== viewVersion) throw new WrongVersion(`the robot shows layout ${bytes.getUint8(0)}, this page knows ${viewVersion}`);
  const jointCount = bytes.getUint8(1);
  if (buffer.byteLength !== frameBytes(jointCount)) {
    throw new RangeError(`a view frame of ${jointCount} joints has ${frameBytes(jointCount)} bytes, this one ${buffer.byteLength}`);
  }
  const frame: Partial<ViewFrame> = {};
  let offset = 0;
  for (const row of viewRows) {
    const values: number[] = [];
    for (let i = 0; i < (row.count || jointCount); ++i) {
      values.push(valueOf(row, rawAt(bytes, row.type, offset)));
      offset += bytesOf[row.type];
    }
    frame[row.name] = values;
  }
  return frame as ViewFrame;
}

// The four bytes that tell the robot that a frame has come.
export function acknowledgement(frame: ViewFrame): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(4);
  new DataView(bytes.buffer).setUint32(0, frame.frame[0] ?? 0, true);
  return bytes;
}

export function commanderOf(frame: ViewFrame): string {
  const end = frame.commander.indexOf(0);
  return new TextDecoder().decode(Uint8Array.from(end < 0 ? frame.commander : frame.commander.slice(0, end)));
}

export function hasTrouble(frame: ViewFrame, joint: number): boolean {
  return (((frame.joint_trouble[joint >> 3] ?? 0) >> (joint & 7)) & 1) === 1;
}

export const modes = { batches: 0, safeTail: 1, holds: 2, emergencyStop: 3 } as const;
export const activities = ["not known", "stands", "walks", "plays a motion", "falls", "lies"] as const;
export const lies = 5; // of `activities`
export const modeTexts = ["plays batches", "plays a safe tail", "holds, waits for a batch", "emergency stop"] as const;
// In the order of the row `age`.
export const ageNames = ["joints", "pose", "message controller", "plan", "robot's clock"] as const;
