// The page: loads the description, connects, and puts the parts together.
import "uplot/dist/uPlot.min.css";
import "./page.css";
import "./simulator/simulator.css";
import "./twin/twin.css";
import { AuthorityBanner } from "./authority_banner.ts";
import { fillCameraBar } from "./camera_bar.ts";
import { Command } from "./command.ts";
import type { Context, Tab } from "./context.ts";
import { loadDescription, TokenWanted, type Description } from "./description.ts";
import { byId } from "./dom.ts";
import { Drive } from "./drive.ts";
import { Driver } from "./driver.ts";
import { Freshness } from "./freshness.ts";
import { LinkBanner } from "./link_banner.ts";
import { News } from "./news.ts";
import { PictureTools } from "./picture_tools.ts";
import { PushTool } from "./push_tool.ts";
import { isLate, isOvertakenByStop, Rosbridge, Unanswered } from "./rosbridge.ts";
import { Scene } from "./scene/scene.ts";
import { watchForSimulator } from "./simulator/simulator.ts";
import { socketUrl } from "./socket_keeper.ts";
import { StatusBar } from "./status_bar.ts";
import { StopBar } from "./stop_bar.ts";
import { TabBar } from "./tab_bar.ts";
import { behaviourTab } from "./tabs/behaviour_tab.ts";
import { driveTab } from "./tabs/drive_tab.ts";
import { eventsTab } from "./tabs/events_tab.ts";
import { plotsTab } from "./tabs/plots_tab.ts";
import { pluginsTab } from "./tabs/plugins_tab.ts";
import { recordingsTab } from "./tabs/recordings_tab.ts";
import { stateTab } from "./tabs/state_tab.ts";
import { askForToken } from "./token_dialog.ts";
import { ViewLink } from "./view_link.ts";

const look_ms = 100;
const again_ms = 500;
let token: string | undefined;

async function description(news: News): Promise<Description> {
  for (;;) {
    try {
      return await loadDescription(token);
    } catch (error) {
      if (error instanceof TokenWanted) {
        token = await askForToken(token === undefined ? "Whoever serves it can tell you." : "That was not the right one.");
        continue;
      }
      news.say(`The robot's description does not come: ${(error as Error).message}`, "bad");
      await new Promise((resolve) => setTimeout(resolve, again_ms));
    }
  }
}

function makeAttempt(news: News): Context["attempt"] {
  return async (what, order, done = "done") => {
    try {
      await order();
      news.say(`${what}: ${done}`, "good", what);
      return true;
    } catch (error) {
      const doubt = error instanceof Unanswered ? " Look whether it was carried out: it is not sent again." : "";
      news.say(`${what}: ${(error as Error).message}${doubt}`, "bad", what);
      return false;
    }
  };
}

function connect(context: Context, driver: Driver, scene: Scene, canvas: HTMLCanvasElement, tools: PictureTools, stops: StopBar, tabs: readonly Tab[]): void {
  const { freshness, robot, news, description } = context;
  const view = new ViewLink(socketUrl("/view"), freshness, () => token);
  const status = new StatusBar(context);
  const bar = new TabBar(byId("tabs"), byId("panels"), tabs);
  context.frameTakers.push((frame) => scene.show(frame), (frame) => stops.show(frame));
  view.onFrame = (frame) => context.frameTakers.forEach((take) => take(frame));
  const banner = new LinkBanner(robot);
  const authority = new AuthorityBanner(context);
  const simulated = description.bounds.push !== undefined;
  const simulator = simulated ? watchForSimulator(context, { scene, canvas, tools, driver, tabs: bar, stops, banner }) : undefined;
  view.onWrongVersion = (text) => {
    driver.retire();
    for (const part of ["top", "camera", "panel"]) byId(part).inert = true; // the stops stay
    banner.otherVersion(text);
  };
  view.onWrongToken = () => location.reload();
  robot.onClose = () => driver.lost();
  robot.onStatus = (level, text) => {
    if (level === "error" && isLate(text)) {
      driver.late(performance.now());
      return;
    }
    if (level === "error") context.drive.end();
    if (isOvertakenByStop(text)) return; // as it should be
    news.say(level === "error" ? `What you asked for was not done: ${text}` : text, level === "error" ? "bad" : "plain");
  };
  const look = () => {
    const now_ms = performance.now();
    status.look(now_ms);
    banner.look(now_ms);
    authority.look(now_ms);
    bar.look(now_ms);
    simulator?.(now_ms);
    scene.setOld(freshness.state(now_ms) !== "live");
  };
  setInterval(look, look_ms);
  view.start();
  robot.start();
}

async function start(): Promise<void> {
  const news = new News(byId("news"));
  const robotDescription = await description(news);
  const canvas = byId<HTMLCanvasElement>("scene");
  const scene = new Scene(canvas, robotDescription);
  scene.onDrawn = () => {
    if (performance.getEntriesByName("first-picture").length === 0) performance.mark("first-picture");
  };
  const robot = new Rosbridge(socketUrl("/"), () => token);
  const name = `page ${crypto.getRandomValues(new Uint16Array(1))[0]?.toString(16).padStart(4, "0")}`;
  const context: Context = {
    description: robotDescription,
    freshness: new Freshness(),
    robot,
    command: new Command(robot, name),
    drive: new Drive(),
    news,
    token: () => token,
    frameTakers: [],
    attempt: makeAttempt(news),
  };
  const driver = new Driver(context);
  const stops = new StopBar(context, () => driver.end());
  driver.pad.onStop = () => stops.stop();
  const { push } = robotDescription.bounds;
  const tools = new PictureTools();
  const pushTool = push && new PushTool(context, scene, canvas, push, tools);
  if (pushTool) tools.add(pushTool);
  fillCameraBar(byId("camera"), scene, pushTool);
  const tabs = [driveTab(context, driver), stateTab(context, scene), behaviourTab(context), plotsTab(context), eventsTab(context), pluginsTab(context), recordingsTab(context)];
  connect(context, driver, scene, canvas, tools, stops, tabs);
  await scene.body.loadMeshes(token, () => scene.ask());
}

void start();
