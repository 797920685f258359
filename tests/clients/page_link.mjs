// A link between a browser and the robot that can be cut, and that can stall: then nothing goes through, and nobody is told.
import net from "node:net";

export class Link {
  #server;
  #sockets = new Set();
  #stalled = false;
  #cut = false;

  static async to(port) {
    const link = new Link();
    link.#server = net.createServer({ pauseOnConnect: true }, (near) => link.#join(near, port));
    await new Promise((resolve) => link.#server.listen(0, "127.0.0.1", resolve));
    link.#server.unref(); // a test that fails before it ends its link holds up nobody
    return link;
  }
  get port() {
    return this.#server.address().port;
  }
  cut() {
    this.#cut = true;
    for (const socket of this.#sockets) socket.resetAndDestroy();
  }
  stall() {
    this.#stalled = true;
    for (const socket of this.#sockets) socket.pause();
  }
  // Of what was cut or stalled.
  mend() {
    this.#cut = this.#stalled = false;
    for (const socket of this.#sockets) socket.resume();
  }
  end() {
    this.cut();
    this.#server.close();
  }

  #join(near, port) {
    if (this.#cut) {
      near.resetAndDestroy();
      return;
    }
    const far = net.connect(port, "127.0.0.1");
    for (const [from, to] of [[near, far], [far, near]]) {
      this.#sockets.add(from);
      from.setNoDelay(true);
      from.unref();
      from.on("data", (bytes) => to.write(bytes));
      from.on("end", () => to.end());
      from.on("error", () => to.destroy());
      from.on("close", () => this.#sockets.delete(from));
      if (this.#stalled) from.pause();
      else from.resume();
    }
  }
}
