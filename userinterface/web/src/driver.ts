// Brings what is held to the robot, and ends it for whatever reason there is.
import type { Context } from "./context.ts";
import { readBounds, apiBounds } from "./bounds.ts";
import { Refused } from "./rosbridge.ts";
import { velocityOf, standstill, isStandstill, type Bounds, type Velocity } from "./drive.ts";
import { GamePad, Keys, ScreenStick, strongest } from "./sticks.ts";
import { LastWalk } from "./twin/last_walk.ts";
import { commanderOf } from "./view_decoder.ts";

const look_ms = 20;
const boundsEvery_ms = 2000;
const foreign_ms = 700; // so long another name in the frames may be an old one

export class Driver {
  readonly walk = new ScreenStick("round", "Walk: up and down ahead and back, sideways turns. Keys W, A, S, D or arrows.", () => this.look());
  readonly side = new ScreenStick("wide", "Sidestep to the left and right. Keys Q and E.", () => this.look());
  readonly pad = new GamePad();
  readonly lastWalk = new LastWalk();
  private readonly keys = new Keys();
  private foreignSince_ms: number | undefined;
  private boundsRead_ms = -Infinity;
  private boundsKnown = false; // before, a stick's place is no velocity: the robot may allow less than half of what the API does
  private retired = false;
  bounds: Bounds;
  sent: Velocity = standstill;

  constructor(private readonly context: Context) {
    this.bounds = apiBounds(context.description);
    document.addEventListener("keydown", (event) => {
      if (this.keys.press(event)) event.preventDefault();
      this.look();
    });
    document.addEventListener("keyup", (event) => {
      this.keys.release(event);
      this.look();
    });
    window.addEventListener("blur", () => this.letGo());
    window.addEventListener("pagehide", () => this.leave());
    document.addEventListener("visibilitychange", () => document.hidden && this.leave());
    setInterval(() => this.look(), look_ms);
  }

  // Whatever is held counts no more until it is let go.
  end(): void {
    if (this.context.drive.end()) this.publish(standstill);
  }

  // The connection has ended: nothing can be said any more, and nothing is said later.
  lost(): void {
    const { drive, command, news } = this.context;
    if (command.mine) news.say("The connection was lost, and with it the command.", "bad");
    drive.end();
    command.lost();
    this.sent = standstill;
    this.lastWalk.take(standstill, performance.now());
  }

  // A velocity was too old when it came to the robot.
  late(now_ms: number): void {
    const { drive, news, description } = this.context;
    if (!drive.late(now_ms, description.bounds.velocity_holds * 1000)) return;
    news.say("The drive has ended: what you ask for comes too late, since the connection, or this computer, is slow. Let go of the stick first.", "bad");
  }

  // For good: what this page says may mean something else by now.
  retire(): void {
    this.leave();
    this.retired = true;
  }

  private letGo(): void {
    this.keys.letGo();
    this.walk.letGo();
    this.side.letGo();
  }

  // Who does not look does not command.
  private leave(): void {
    this.letGo();
    this.end();
    if (this.context.command.mine) void this.context.command.giveBack().catch(() => {});
  }

  private look(): void {
    const padWish = this.pad.wish; // its stop buttons work whatever the page may do
    if (this.retired) return;
    const { drive, freshness, command, news } = this.context;
    const now_ms = performance.now();
    const screen = { ahead: this.walk.y, turn: -this.walk.x, left: -this.side.x };
    const wish = strongest([screen, this.keys.wish, document.hidden ? undefined : padWish]);
    this.walk.mirror(-wish.turn, wish.ahead);
    this.side.mirror(-wish.left, 0);
    const held = this.boundsKnown ? velocityOf(wish, this.bounds) : standstill;
    if (isStandstill(held)) {
      const last = drive.letGo();
      if (last) this.publish(last);
    } else if (drive.hold(held, command.mine)) {
      command.take().then(() => drive.granted(), (error: Error) => {
        drive.end();
        news.say(`You cannot drive: ${error.message}`, "bad");
      });
    }
    if (drive.state === "drives" && freshness.state(now_ms) === "lost") {
      this.end();
      news.say("Nothing comes from the robot any more: the drive has ended. Let go of the stick first.", "bad");
    }
    const velocity = drive.due(now_ms);
    if (velocity) this.publish(velocity);
    this.keepCommand(now_ms);
    this.keepBounds(now_ms);
  }

  private publish({ forward, left, turn }: Velocity): void {
    this.sent = { forward, left, turn };
    this.lastWalk.take(this.sent, performance.now());
    this.context.robot.publish("/cmd_vel", { linear: { x: forward, y: left }, angular: { z: turn } });
  }

  private keepCommand(now_ms: number): void {
    const { command, freshness, news, drive } = this.context;
    if (!command.mine) {
      this.foreignSince_ms = undefined;
      return;
    }
    command.keep(now_ms).catch((error: Error) => {
      if (!(error instanceof Refused)) return; // it was not answered: the frames tell who commands
      drive.end();
      news.say("You do not command any more: the robot has not heard from this page in time (is this computer busy?), or somebody has stopped it.", "bad");
    });
    const frame = freshness.newest;
    const foreign = frame !== undefined && freshness.state(now_ms) !== "lost" && commanderOf(frame) !== command.name;
    this.foreignSince_ms = foreign ? (this.foreignSince_ms ?? now_ms) : undefined;
    if (this.foreignSince_ms === undefined || now_ms - this.foreignSince_ms < foreign_ms) return;
    drive.end();
    command.lost();
    news.say("You do not command any more: somebody has stopped the robot, or the connection was too slow.", "bad");
  }

  private keepBounds(now_ms: number): void {
    const { robot, description } = this.context;
    if (!robot.isOpen || document.hidden || now_ms - this.boundsRead_ms < boundsEvery_ms) return;
    this.boundsRead_ms = now_ms;
    readBounds(robot, description).then(
      (bounds) => {
        this.bounds = bounds;
        this.boundsKnown = true;
      },
      () => {}, // those that are known hold on
    );
  }
}
