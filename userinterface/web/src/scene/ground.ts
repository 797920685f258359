// What lies on the ground: the grid, footsteps planned and made, the support polygon, ZMP and CoM.
import * as THREE from "three";
import type { ViewFrame } from "../view_decoder.ts";
import { convexHull, type Point } from "./polygon.ts";
import type { RobotBody } from "./robot_body.ts";

const madeAtMost = 24;
const stepLeast_m = 0.005; // odometry's height is hardly better
const heights_m = { made: 0.001, support: 0.002, planned: 0.003, marks: 0.004 };

export interface GroundColours {
  ground: number;
  grid: number;
  made: number;
  planned: number;
  support: number;
  zmp: number;
  plannedZmp: number;
  com: number;
}

function outline(capacity: number, colour: number): THREE.LineLoop {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * capacity), 3));
  const line = new THREE.LineLoop(geometry, new THREE.LineBasicMaterial({ color: colour }));
  line.frustumCulled = false;
  line.visible = false;
  return line;
}

function setOutline(line: THREE.LineLoop, points: readonly Point[], height_m: number): void {
  const position = line.geometry.getAttribute("position") as THREE.BufferAttribute;
  for (const [index, [x, y]] of points.entries()) position.setXYZ(index, x, y, height_m);
  position.needsUpdate = true;
  line.geometry.setDrawRange(0, points.length);
  line.visible = points.length > 2;
}

function disc(radius_m: number, colour: number): THREE.Mesh<THREE.CircleGeometry, THREE.MeshBasicMaterial> {
  const mesh = new THREE.Mesh(new THREE.CircleGeometry(radius_m, 24), new THREE.MeshBasicMaterial({ color: colour, depthTest: false }));
  mesh.renderOrder = 2;
  mesh.visible = false;
  return mesh;
}

export class Ground {
  readonly group = new THREE.Group();
  private grid: THREE.GridHelper;
  private readonly support: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly supportEdge: THREE.LineLoop;
  private readonly planned: THREE.LineLoop[];
  private readonly made: THREE.LineLoop[] = [];
  private readonly zmp;
  private readonly plannedZmp;
  private readonly com;
  private readonly comDrop: THREE.Line;
  private gridShown = true;
  private readonly stood: [boolean, boolean] = [false, false];

  constructor(
    private readonly sole: { length: number; width: number; ahead: number },
    private readonly size_m: number, // of the robot: marks are as large as suits it
    private colours: GroundColours,
  ) {
    this.grid = this.makeGrid();
    this.support = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ color: colours.support, transparent: true, opacity: 0.3, depthTest: false }));
    this.support.renderOrder = 1;
    this.support.frustumCulled = false;
    this.supportEdge = outline(8, colours.support);
    this.planned = Array.from({ length: 4 }, () => outline(4, colours.planned));
    const mark_m = size_m * 0.028;
    this.zmp = disc(mark_m, colours.zmp);
    this.plannedZmp = disc(mark_m * 0.6, colours.plannedZmp);
    this.com = disc(mark_m * 0.8, colours.com);
    this.comDrop = new THREE.Line(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), new THREE.Vector3(0, 0, 1)]),
      new THREE.LineBasicMaterial({ color: colours.com }));
    this.comDrop.visible = false;
    this.group.add(this.grid, this.support, this.supportEdge, ...this.planned, this.zmp, this.plannedZmp, this.com, this.comDrop);
  }

  setColours(colours: GroundColours): void {
    this.colours = colours;
    this.group.remove(this.grid);
    this.grid.dispose();
    this.grid = this.makeGrid();
    this.group.add(this.grid);
    const paint = (target: THREE.Mesh | THREE.Line, colour: number) => (target.material as THREE.MeshBasicMaterial).color.setHex(colour);
    for (const line of this.made) paint(line, colours.made);
    for (const line of this.planned) paint(line, colours.planned);
    for (const part of [this.support, this.supportEdge]) paint(part, colours.support);
    paint(this.zmp, colours.zmp);
    paint(this.plannedZmp, colours.plannedZmp);
    for (const part of [this.com, this.comDrop]) paint(part, colours.com);
  }

  // For good: there is another one.
  hideGrid(): void {
    this.gridShown = false;
    this.grid.visible = false;
  }

  // `body`: posed as the frame has it.
  show(frame: ViewFrame, body: RobotBody): void {
    const [baseX = NaN, baseY = NaN] = frame.base_place;
    if (Number.isNaN(baseX)) return;
    this.grid.position.set(Math.round(baseX), Math.round(baseY), 0);
    this.showSteps(frame, baseX, baseY);
    this.showSupport(frame, body);
    const mark = (target: THREE.Mesh, values: readonly number[]) => {
      const [x = NaN, y = NaN] = values;
      target.visible = !Number.isNaN(x + y);
      if (target.visible) target.position.set(baseX + x, baseY + y, heights_m.marks);
    };
    mark(this.zmp, frame.zmp);
    mark(this.plannedZmp, frame.planned_zmp);
    mark(this.com, frame.com);
    this.comDrop.visible = this.com.visible && !Number.isNaN(frame.com[2] ?? NaN);
    if (this.comDrop.visible) {
      this.comDrop.position.copy(this.com.position);
      this.comDrop.scale.z = frame.com[2] ?? 0;
    }
  }

  private showSteps(frame: ViewFrame, baseX: number, baseY: number): void {
    const count = frame.footstep_count[0] ?? 0;
    for (const [index, line] of this.planned.entries()) {
      const [x = 0, y = 0, yaw = 0] = frame.footstep.slice(3 * index, 3 * index + 3);
      line.visible = index < count;
      if (line.visible) setOutline(line, this.rectangle(baseX + x, baseY + y, yaw), heights_m.planned);
    }
  }

  private showSupport(frame: ViewFrame, body: RobotBody): void {
    const bearing: Point[] = [];
    for (const side of [0, 1] as const) {
      const stands = frame.contact[side] === 1;
      const sole = stands ? body.soleCorners(side) : [];
      const corners = sole.map(({ x, y }): Point => [x, y]);
      bearing.push(...corners);
      if (stands && !this.stood[side]) this.addMade(corners, Math.max(...sole.map(({ z }) => z)));
      this.stood[side] = stands;
    }
    const hull = convexHull(bearing);
    setOutline(this.supportEdge, hull, heights_m.support);
    this.support.visible = hull.length > 2;
    if (!this.support.visible) return;
    this.support.geometry.dispose();
    this.support.geometry = new THREE.ShapeGeometry(new THREE.Shape(hull.map(([x, y]) => new THREE.Vector2(x, y))));
    this.support.position.z = heights_m.support;
  }

  // `height_m`: of the sole; it may have stepped onto something.
  private addMade(corners: readonly Point[], height_m: number): void {
    const line = this.made.length < madeAtMost ? outline(4, this.colours.made) : this.made.shift();
    if (!line) return;
    this.made.push(line);
    this.group.add(line);
    setOutline(line, corners, heights_m.made + (height_m > stepLeast_m ? height_m : 0));
  }

  private rectangle(x: number, y: number, yaw: number): Point[] {
    const { length, width, ahead } = this.sole;
    const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
    const corners: Point[] = [[ahead + length / 2, width / 2], [ahead - length / 2, width / 2], [ahead - length / 2, -width / 2], [ahead + length / 2, -width / 2]];
    return corners.map(([a, b]) => [x + cos * a - sin * b, y + sin * a + cos * b]);
  }

  private makeGrid(): THREE.GridHelper {
    const extent_m = 2 * Math.ceil(this.size_m * 5);
    const grid = new THREE.GridHelper(extent_m, extent_m * 4, this.colours.grid, this.colours.grid);
    grid.rotation.x = Math.PI / 2;
    grid.visible = this.gridShown;
    return grid;
  }
}
