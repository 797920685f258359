// What people hold: the two sticks on the screen, keys, and a game pad, as one wish of -1 to 1 each.
import { element, isTyping } from "./dom.ts";

export interface Wish {
  ahead: number;
  left: number;
  turn: number;
}

// Of key codes, so that they lie where they lie on every keyboard.
const keyWishes: Record<string, Partial<Wish>> = {
  KeyW: { ahead: 1 }, ArrowUp: { ahead: 1 },
  KeyS: { ahead: -1 }, ArrowDown: { ahead: -1 },
  KeyA: { turn: 1 }, ArrowLeft: { turn: 1 },
  KeyD: { turn: -1 }, ArrowRight: { turn: -1 },
  KeyQ: { left: 1 }, KeyE: { left: -1 },
};
const gentle = 0.6; // of a key without Shift
const deadZone = 0.15;

const beyondDeadZone = (value: number) => (Math.abs(value) < deadZone ? 0 : (value - Math.sign(value) * deadZone) / (1 - deadZone));

export class Keys {
  private readonly held = new Set<string>();
  private fast = false;

  press(event: KeyboardEvent): boolean {
    this.fast = event.shiftKey;
    if (!(event.code in keyWishes) || event.ctrlKey || event.altKey || event.metaKey || isTyping(event.target)) return false;
    this.held.add(event.code);
    return true;
  }
  release(event: KeyboardEvent): void {
    this.fast = event.shiftKey;
    this.held.delete(event.code);
  }
  letGo(): void {
    this.held.clear();
  }
  get wish(): Wish {
    const sum: Wish = { ahead: 0, left: 0, turn: 0 };
    for (const code of this.held) {
      const wish = keyWishes[code];
      sum.ahead += wish?.ahead ?? 0;
      sum.left += wish?.left ?? 0;
      sum.turn += wish?.turn ?? 0;
    }
    const share = this.fast ? 1 : gentle;
    return { ahead: Math.sign(sum.ahead) * share, left: Math.sign(sum.left) * share, turn: Math.sign(sum.turn) * share };
  }
}

// A knob in a field: x to the right, y upwards, each -1 to 1.
export class ScreenStick {
  readonly field: HTMLElement;
  private readonly knob = element("div", { class: "knob" });
  private pointer: number | undefined;
  x = 0;
  y = 0;

  constructor(
    kind: "round" | "wide",
    label: string,
    private readonly changed: () => void,
  ) {
    this.field = element("div", { class: `stick ${kind}`, role: "img", "aria-label": label, title: label }, this.knob);
    this.field.addEventListener("pointerdown", (event) => this.grasp(event));
    this.field.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
      this.field.addEventListener(end, (event) => event.pointerId === this.pointer && this.letGo());
    }
  }

  letGo(): void {
    this.pointer = undefined;
    this.place(0, 0);
  }

  // Where keys or a game pad would have it, while nobody holds it.
  mirror(x: number, y: number): void {
    if (this.pointer === undefined) this.draw(x, y);
  }

  private grasp(event: PointerEvent): void {
    if (event.button !== 0 || this.pointer !== undefined) return;
    event.preventDefault();
    this.pointer = event.pointerId;
    this.field.setPointerCapture(event.pointerId);
    this.move(event);
  }

  private move(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return;
    const box = this.field.getBoundingClientRect();
    const reach_px = Math.min(box.width, box.height) / 2 - 20;
    let x = (event.clientX - box.left - box.width / 2) / (this.field.classList.contains("wide") ? box.width / 2 - 24 : reach_px);
    let y = this.field.classList.contains("wide") ? 0 : -(event.clientY - box.top - box.height / 2) / reach_px;
    const length = Math.hypot(x, y);
    if (length > 1) {
      x /= length;
      y /= length;
    }
    this.place(x, y);
  }

  private place(x: number, y: number): void {
    this.x = x;
    this.y = y;
    this.draw(x, y);
    this.changed();
  }

  private draw(x: number, y: number): void {
    this.knob.style.setProperty("--x", String(x));
    this.knob.style.setProperty("--y", String(-y));
  }
}

// Left stick: ahead and sideways; right stick: turns. Any of the four face buttons stops.
export class GamePad {
  private stopHeld = false;
  onStop: () => void = () => {};

  get wish(): Wish | undefined {
    const pad = navigator.getGamepads?.().find((one) => one?.connected);
    if (!pad) return undefined;
    const stops = pad.buttons.slice(0, 4).some((one) => one.pressed);
    if (stops && !this.stopHeld) this.onStop();
    this.stopHeld = stops;
    const axis = (index: number) => beyondDeadZone(pad.axes[index] ?? 0);
    return { ahead: -axis(1), left: -axis(0), turn: -axis(2) };
  }
}

export function strongest(wishes: readonly (Wish | undefined)[]): Wish {
  const of = (wish: Wish) => Math.abs(wish.ahead) + Math.abs(wish.left) + Math.abs(wish.turn);
  return wishes.reduce<Wish>((most, wish) => (wish && of(wish) > of(most) ? wish : most), { ahead: 0, left: 0, turn: 0 });
}
