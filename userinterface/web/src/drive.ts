// Whether a held stick moves the robot. Passive: told what is held, and when; says what is to be sent.
//
// A velocity goes out while a stick is held, and one of zero when it is let go. Whatever ends it otherwise (a lost
// link, a stop, a hidden page, a refusal) ends it until the stick has been let go: nothing starts again by itself.

export interface Velocity {
  forward: number; // m/s
  left: number; // m/s
  turn: number; // rad/s, to the left
}

export interface Bounds {
  forward: number; // m/s, so backward and left
  backward: number;
  left: number;
  turn: number; // rad/s
}

export const standstill: Velocity = { forward: 0, left: 0, turn: 0 };
export const sendEvery_ms = 80;
const lateApart_ms = 400; // late ones further apart have to do with each other no more

export function isStandstill(velocity: Velocity): boolean {
  return velocity.forward === 0 && velocity.left === 0 && velocity.turn === 0;
}

// A stick's place, each -1 to 1, as a velocity within the bounds.
export function velocityOf(stick: { ahead: number; left: number; turn: number }, bounds: Bounds): Velocity {
  const clamp = (share: number) => Math.max(-1, Math.min(1, share));
  const ahead = clamp(stick.ahead);
  return {
    forward: ahead * (ahead < 0 ? bounds.backward : bounds.forward),
    left: clamp(stick.left) * bounds.left,
    turn: clamp(stick.turn) * bounds.turn,
  };
}

// rests: nothing is held. waits: held, but the command has not been granted yet. drives. blocked: held, but it was ended;
// wants to be let go.
export type DriveState = "rests" | "waits" | "drives" | "blocked";

export class Drive {
  private current: DriveState = "rests";
  private wanted: Velocity = standstill;
  private sent_ms = -Infinity;
  private late_ms = -Infinity;
  private lateSince_ms = -Infinity;

  get state(): DriveState {
    return this.current;
  }

  // What the sticks say now. True: the command must be had for it (tell granted() or end()).
  hold(velocity: Velocity, mayCommand: boolean): boolean {
    this.wanted = velocity;
    if (this.current !== "rests" || isStandstill(velocity)) return false;
    this.current = mayCommand ? "drives" : "waits";
    this.sent_ms = -Infinity;
    return !mayCommand;
  }

  granted(): void {
    if (this.current === "waits") this.current = "drives";
  }

  // All sticks are let go. Gives what is to be sent.
  letGo(): Velocity | undefined {
    const drove = this.current === "drives";
    this.current = "rests";
    this.wanted = standstill;
    return drove ? standstill : undefined;
  }

  // A lost link, a stop, a hidden page, a refusal. True: it drove.
  end(): boolean {
    const drove = this.current === "drives";
    if (this.current !== "rests") this.current = "blocked";
    return drove;
  }

  // A velocity was too old when it came to the robot. One is nothing: the next is on its way. When they have been late for as
  // long as one holds, the robot stands, and the drive has ended: then true.
  late(now_ms: number, holds_ms: number): boolean {
    if (now_ms - this.late_ms > lateApart_ms) this.lateSince_ms = now_ms;
    this.late_ms = now_ms;
    return now_ms - this.lateSince_ms >= holds_ms && this.end();
  }

  // What is to be sent now, if anything.
  due(now_ms: number): Velocity | undefined {
    if (this.current !== "drives" || now_ms - this.sent_ms < sendEvery_ms) return undefined;
    this.sent_ms = now_ms;
    return this.wanted;
  }
}
