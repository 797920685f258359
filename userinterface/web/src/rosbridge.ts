// The conversation with the robot API: calls, and topics. An order that was not answered is reported as such, and is
// never sent again; a stop is said until it is answered.
import { SocketKeeper, type SocketUser } from "./socket_keeper.ts";

export type Message = Record<string, unknown>;
export interface Outcome extends Message {
  success: boolean;
  message: string;
}

// Nobody knows whether it was carried out.
export class Unanswered extends Error {}
// It was not sent, or the robot refused it.
export class Refused extends Error {}

// Of a status message: a velocity may have been on its way for too long, and was not carried out.
export function isLate(text: string): boolean {
  return text.includes("late: it may have been sent");
}

// Likewise: it was on its way when a stop was carried out.
export function isOvertakenByStop(text: string): boolean {
  return text.includes("given before a stop") || text.includes("a stop that this connection called later");
}

interface Waiting {
  service: string;
  resolve: (values: Message) => void;
  reject: (error: Error) => void;
  timer: ReturnType<typeof setTimeout>;
}
interface Subscription {
  type: string;
  throttle_ms: number;
  takers: Set<(message: Message) => void>;
}

const patience_ms = 3000;
const probe_ms = 1000;
// A lost segment holds up a stop for 0.2 s and more, unless others follow it: what the receiver then says of them has TCP send it again at once.
const stopRepeat_ms = 20;

export class Rosbridge implements SocketUser {
  private readonly keeper: SocketKeeper;
  private readonly waiting = new Map<string, Waiting>();
  private readonly subscriptions = new Map<string, Subscription>();
  private lastId = 0;
  private open = false;
  onOpen: () => void = () => {};
  onClose: () => void = () => {};
  onStatus: (level: string, text: string) => void = () => {};

  constructor(
    url: string,
    private readonly token: () => string | undefined,
  ) {
    this.keeper = new SocketKeeper(url, this);
  }

  start(): void {
    this.keeper.start();
    setInterval(() => void this.probe(), probe_ms);
  }
  get isOpen(): boolean {
    return this.open;
  }

  call(service: string, args: Message = {}, wait_ms = patience_ms): Promise<Message> {
    return new Promise((resolve, reject) => {
      const id = `${service}#${++this.lastId}`;
      if (!this.keeper.send(JSON.stringify({ op: "call_service", id, service, args }))) {
        reject(new Refused(`${service} was not sent: there is no connection to the robot`));
        return;
      }
      const timer = setTimeout(() => {
        this.waiting.delete(id);
        reject(new Unanswered(`${service} was sent, but not answered within ${wait_ms / 1000} s`));
      }, wait_ms);
      this.waiting.set(id, { service, resolve, reject, timer });
    });
  }

  // As call(), for services that answer `success`. Throws Refused with the robot's reason.
  async order(service: string, args: Message = {}, wait_ms = patience_ms): Promise<Outcome> {
    const outcome = (await this.call(service, args, wait_ms)) as Outcome;
    if (!outcome.success) throw new Refused(outcome.message || `${service} was refused`);
    return outcome;
  }

  // As order(). However often the robot hears of it, it is one stop.
  async stop(service: string, args: Message = {}): Promise<Outcome> {
    const answer = this.order(service, args);
    const message = JSON.stringify({ op: "call_service", id: `${service}#${this.lastId}`, service, args });
    const again = setInterval(() => this.keeper.send(message), stopRepeat_ms);
    try {
      return await answer;
    } finally {
      clearInterval(again);
    }
  }

  publish(topic: string, msg: Message): boolean {
    return this.keeper.send(JSON.stringify({ op: "publish", topic, msg }));
  }

  // Gives back what ends it. It is taken up again after an outage.
  subscribe(topic: string, type: string, throttle_ms: number, take: (message: Message) => void): () => void {
    let subscription = this.subscriptions.get(topic);
    if (!subscription) {
      subscription = { type, throttle_ms, takers: new Set() };
      this.subscriptions.set(topic, subscription);
      this.sendSubscription(topic, subscription);
    }
    const { takers } = subscription;
    takers.add(take);
    return () => {
      takers.delete(take);
      if (takers.size > 0 || !this.subscriptions.delete(topic)) return;
      this.keeper.send(JSON.stringify({ op: "unsubscribe", topic }));
    };
  }

  opened(): void {
    this.open = true;
    const token = this.token();
    if (token !== undefined) this.keeper.send(JSON.stringify({ op: "auth", token }));
    for (const [topic, subscription] of this.subscriptions) this.sendSubscription(topic, subscription);
    this.onOpen();
  }

  closed(): void {
    const unanswered = [...this.waiting.values()];
    this.waiting.clear();
    for (const { service, reject, timer } of unanswered) {
      clearTimeout(timer);
      reject(new Unanswered(`${service} was sent, but the connection was lost before its answer`));
    }
    if (this.open) this.onClose();
    this.open = false;
  }

  received(data: string | ArrayBuffer): void {
    const message = JSON.parse(data as string) as Message;
    if (message["op"] === "publish") {
      for (const take of this.subscriptions.get(message["topic"] as string)?.takers ?? []) take(message["msg"] as Message);
    } else if (message["op"] === "service_response") {
      this.answered(message);
    } else if (message["op"] === "status") {
      this.onStatus(String(message["level"]), String(message["msg"]));
    }
  }

  private answered(message: Message): void {
    const id = message["id"] as string;
    const call = this.waiting.get(id);
    if (!call) return;
    this.waiting.delete(id);
    clearTimeout(call.timer);
    if (message["result"] === true) call.resolve(message["values"] as Message);
    else call.reject(new Refused(String(message["values"])));
  }

  private sendSubscription(topic: string, { type, throttle_ms }: Subscription): void {
    this.keeper.send(JSON.stringify({ op: "subscribe", topic, type, throttle_rate: throttle_ms, queue_length: throttle_ms ? 1 : 100 }));
  }

  // A connection that does not answer is none.
  private async probe(): Promise<void> {
    if (!this.open) return;
    try {
      await this.call("/rosapi/get_time", {}, probe_ms);
    } catch (error) {
      if (error instanceof Unanswered && this.open) this.keeper.restart("no answer");
    }
  }
}
