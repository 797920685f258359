// The socket that brings the view's frames, and takes their acknowledgements. It asks for the view of this page's own version,
// which a server of another one refuses.
import type { Freshness } from "./freshness.ts";
import { lostAfter_ms } from "./freshness.ts";
import { otherVersionText, pageVersion, servedVersion } from "./page_version.ts";
import { SocketKeeper, type SocketUser } from "./socket_keeper.ts";
import { acknowledgement, decodeView, WrongVersion, type ViewFrame } from "./view_decoder.ts";

const wrongToken = "the token is wrong"; // as the robot says it

export class ViewLink implements SocketUser {
  private readonly keeper: SocketKeeper;
  private since_ms = performance.now(); // of the connection, or the newest frame
  private open = false;
  onFrame: (frame: ViewFrame) => void = () => {};
  onWrongToken: () => void = () => {};
  onWrongVersion: (text: string) => void = () => {};

  constructor(
    url: string,
    private readonly freshness: Freshness,
    private readonly token: () => string | undefined,
  ) {
    this.keeper = new SocketKeeper(`${url}?page=${pageVersion}`, this);
  }

  start(): void {
    this.keeper.start();
    setInterval(() => this.look(), lostAfter_ms / 4);
  }

  opened(socket: WebSocket): void {
    this.open = true;
    this.since_ms = performance.now();
    const token = this.token();
    if (token !== undefined) socket.send(token);
  }

  closed(reason: string): void {
    if (!this.open) void this.askForVersion();
    this.open = false;
    if (reason === wrongToken) {
      this.keeper.stop();
      this.onWrongToken();
    }
    this.freshness.disconnected(performance.now());
  }

  received(data: string | ArrayBuffer): void {
    try {
      const frame = decodeView(data as ArrayBuffer);
      this.keeper.send(acknowledgement(frame));
      this.since_ms = performance.now();
      this.freshness.take(frame, this.since_ms);
      this.onFrame(frame);
    } catch (error) {
      if (!(error instanceof WrongVersion)) throw error;
      this.endFor(`${error.message}: load the page again. Stop still works.`);
    }
  }

  // A view that does not open may have been refused to this version.
  private async askForVersion(): Promise<void> {
    const served = await servedVersion().catch(() => pageVersion); // it does not answer: nothing is known
    if (served !== pageVersion) this.endFor(otherVersionText(served));
  }

  private endFor(text: string): void {
    this.keeper.stop();
    this.onWrongVersion(text);
  }

  // A socket through which nothing comes is given up.
  private look(): void {
    if (this.open && performance.now() - this.since_ms > lostAfter_ms) this.keeper.restart("nothing came");
  }
}
