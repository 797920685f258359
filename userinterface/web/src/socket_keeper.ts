// A WebSocket that comes back by itself within a second of the network's return.

export interface SocketUser {
  opened(socket: WebSocket): void;
  received(data: string | ArrayBuffer): void;
  // `reason`: the server's words, if it had any.
  closed(reason: string): void;
}

const pause_ms = 200;
// Till a connection must be there. A packet that is lost is sent again by the computer only after a second, so the
// first tries are short; a slow network gets a longer one in between.
const patience_ms = [700, 700, 2500];

export class SocketKeeper {
  private socket: WebSocket | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private tries = 0;
  private ended = false;

  constructor(
    private readonly url: string,
    private readonly user: SocketUser,
  ) {}

  start(): void {
    this.ended = false;
    this.tryOnce();
  }

  // Until start().
  stop(): void {
    this.ended = true;
    this.drop("");
  }

  // What is there is given up, and another one is looked for.
  restart(reason: string): void {
    this.drop(reason);
    if (!this.ended) this.timer = setTimeout(() => this.tryOnce(), pause_ms);
  }

  // False: there is no connection, and nothing was sent.
  send(data: string | Uint8Array<ArrayBuffer>): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(data);
    return true;
  }

  private tryOnce(): void {
    clearTimeout(this.timer);
    const socket = new WebSocket(this.url);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.timer = setTimeout(() => this.restart("no answer"), patience_ms[this.tries++ % patience_ms.length]);
    socket.onopen = () => {
      clearTimeout(this.timer);
      this.tries = 0;
      this.user.opened(socket);
    };
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.user.received(event.data);
    socket.onclose = (event) => this.restart(event.reason);
  }

  private drop(reason: string): void {
    clearTimeout(this.timer);
    const socket = this.socket;
    this.socket = undefined;
    if (!socket) return;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
    this.user.closed(reason);
  }
}

export function socketUrl(path: string): string {
  return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}${path}`;
}
