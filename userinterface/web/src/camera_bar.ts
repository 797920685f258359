// Buttons that turn the camera, for who has no mouse, and what pushes a simulated robot.
import { button } from "./dom.ts";
import type { PushTool } from "./push_tool.ts";
import type { Look, Scene } from "./scene/scene.ts";

// `push`: none: the robot is no simulation.
export function fillCameraBar(bar: HTMLElement, scene: Scene, push?: PushTool): void {
  const follow = button("Follow", () => {
    scene.follows = !scene.follows;
    follow.setAttribute("aria-pressed", String(scene.follows));
  }, { "aria-pressed": "true", title: "The camera goes with the robot" });
  const looks: Look[] = ["behind", "front", "side", "top"];
  bar.append(
    follow,
    ...looks.map((look) => button(look[0]?.toUpperCase() + look.slice(1), () => scene.lookFrom(look), { title: `Look from ${look}` })),
    button("+", () => scene.zoom(0.8), { "aria-label": "Nearer" }),
    button("−", () => scene.zoom(1.25), { "aria-label": "Farther" }),
    ...(push ? [push.toggle, push.form] : []),
  );
}
