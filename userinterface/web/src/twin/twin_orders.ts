// What the page asks of the twin. Nobody needs the command of the simulated robot for it. Passive.
import type { Message } from "../rosbridge.ts";
import type { SendRequest } from "./send_request.ts";

export interface Caller {
  order(service: string, args?: Message, wait_ms?: number): Promise<Message>;
}
export interface PicturePart {
  total: number; // bytes of the whole picture
  bytes: Uint8Array<ArrayBuffer>;
}

const patience_ms = 5000;
const mostPicture_bytes = 16_000_000;
const attempts = 3; // at a picture that becomes another one meanwhile

export class TwinOrders {
  constructor(private readonly robot: Caller) {}

  async follow(follows: boolean): Promise<void> {
    await this.robot.order("/simulation/twin/follow", { data: follows }, patience_ms);
  }
  // It is answered when it begins to be tried.
  async send(request: SendRequest): Promise<void> {
    await this.robot.order("/simulation/twin/send", request, patience_ms);
  }
  async stop(): Promise<void> {
    await this.robot.order("/simulation/twin/stop", {}, patience_ms);
  }
  async reconnect(): Promise<void> {
    await this.robot.order("/simulation/twin/reconnect", {}, patience_ms);
  }
  // Of the worst simulated robot, as PNG.
  picture(): Promise<Uint8Array<ArrayBuffer>> {
    return wholePicture((first) => this.picturePart(first));
  }

  private async picturePart(first: number): Promise<PicturePart> {
    const answer = await this.robot.order("/simulation/twin/picture", { first }, patience_ms);
    return { total: Number(answer["total"]), bytes: Uint8Array.from(atob(String(answer["data"])), (letter) => letter.charCodeAt(0)) };
  }
}

type Part = (first: number) => Promise<PicturePart>;

// `part`: the bytes from this one on. Throws where they make no picture.
export async function wholePicture(part: Part): Promise<Uint8Array<ArrayBuffer>> {
  for (let attempt = 0; attempt < attempts; ++attempt) {
    const whole = await readOnce(part);
    if (whole) return whole;
  }
  throw new Error(`the picture became another one ${attempts} times while it was read`);
}

// undefined: it became another one meanwhile.
async function readOnce(part: Part): Promise<Uint8Array<ArrayBuffer> | undefined> {
  let { total, bytes } = await part(0);
  if (!(total > 0 && total <= mostPicture_bytes)) throw new Error(`the picture has ${total} bytes, and must have 1 … ${mostPicture_bytes}`);
  const whole = new Uint8Array(total);
  for (let filled = 0; ; ) {
    if (total !== whole.length) return undefined;
    if (bytes.length === 0 || filled + bytes.length > total) throw new Error(`the picture has ${total} bytes, but its part from ${filled} on has ${bytes.length}`);
    whole.set(bytes, filled);
    filled += bytes.length;
    if (filled === total) return whole;
    ({ total, bytes } = await part(filled));
  }
}
