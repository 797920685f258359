// The robot's body in three dimensions, from its description.
import * as THREE from "three";
import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";
import type { Grip } from "./push_arrow.ts";
import { withToken, type Description, type Placed, type Shape } from "../description.ts";

function put(target: THREE.Object3D, { place, turn }: Placed): void {
  target.position.fromArray(place);
  target.quaternion.fromArray(turn);
}

function simpleGeometry({ kind, size }: Shape): THREE.BufferGeometry {
  if (kind === "sphere") return new THREE.SphereGeometry(size[0] / 2, 20, 14);
  if (kind === "cylinder") return new THREE.CylinderGeometry(size[0] / 2, size[0] / 2, size[2], 24).rotateX(Math.PI / 2);
  return new THREE.BoxGeometry(...size);
}

// STL, its vertices in metres about the middle of its box.
async function meshGeometry(shape: Shape, token: string | undefined): Promise<THREE.BufferGeometry> {
  const answer = await fetch(shape.mesh?.slice(1) ?? "", withToken(token));
  if (!answer.ok) throw new Error(await answer.text());
  const geometry = new STLLoader().parse(await answer.arrayBuffer());
  const scale = shape.scale ?? [1, 1, 1];
  const centre = shape.centre ?? [0, 0, 0];
  geometry.scale(...scale).translate(-centre[0], -centre[1], -centre[2]);
  geometry.computeVertexNormals();
  return geometry;
}

export class RobotBody {
  readonly base = new THREE.Group();
  private readonly links: THREE.Group[];
  private readonly turning: { group: THREE.Group; rest: THREE.Quaternion; axis: THREE.Vector3 }[] = [];
  private readonly materials = new Map<string, THREE.MeshLambertMaterial>();
  private readonly spin = new THREE.Quaternion();

  constructor(private readonly description: Description) {
    this.links = description.links.map(() => new THREE.Group());
    this.base.add(this.links[0] ?? new THREE.Group());
    for (const joint of description.joints) {
      const group = this.links[joint.child];
      if (!group) continue;
      put(group, joint);
      this.links[joint.parent]?.add(group);
      this.turning.push({ group, rest: group.quaternion.clone(), axis: new THREE.Vector3(...joint.axis) });
    }
    this.pose(description.joints.map(({ home }) => home));
    for (const [index, { shapes }] of description.links.entries()) {
      for (const shape of shapes) this.links[index]?.add(this.solid(shape, simpleGeometry(shape)));
    }
  }

  // Puts the meshes in the place of the boxes that stand for them until then.
  async loadMeshes(token: string | undefined, loaded: () => void): Promise<void> {
    const jobs: Promise<void>[] = [];
    for (const [index, { shapes }] of this.description.links.entries()) {
      for (const [at, shape] of shapes.entries()) {
        const stand = this.links[index]?.children.filter((child) => child instanceof THREE.Mesh)[at];
        if (!(stand instanceof THREE.Mesh) || shape.mesh === undefined) continue;
        jobs.push(meshGeometry(shape, token).then((geometry) => {
          (stand.geometry as THREE.BufferGeometry).dispose();
          stand.geometry = geometry;
          loaded();
        }));
      }
    }
    await Promise.all(jobs);
  }

  pose(joints_rad: readonly number[]): void {
    for (const [index, { group, rest, axis }] of this.turning.entries()) {
      const angle = joints_rad[index];
      if (angle === undefined || Number.isNaN(angle)) continue;
      group.quaternion.copy(rest).multiply(this.spin.setFromAxisAngle(axis, angle));
    }
  }

  // The place on a link that the ray meets first; of the newest pose.
  gripAt(ray: THREE.Raycaster): Grip | undefined {
    this.base.updateWorldMatrix(false, true);
    for (const { object, point } of ray.intersectObject(this.base, true)) {
      const link = this.links.findIndex((group) => group === object.parent);
      const group = this.links[link];
      if (group) return { link, group, place: group.worldToLocal(point.clone()) };
    }
    return undefined;
  }

  // The middle of a link's first shape, or its origin.
  gripOn(link: number): Grip | undefined {
    const group = this.links[link];
    const shape = group?.children.find((child) => child instanceof THREE.Mesh);
    return group && { link, group, place: shape?.position.clone() ?? new THREE.Vector3() };
  }

  // Of a sole, in the world; of the newest pose.
  solePose(side: 0 | 1): THREE.Matrix4 {
    const { link, place, turn } = this.description.soles[side];
    const sole = new THREE.Matrix4().compose(new THREE.Vector3(...place), new THREE.Quaternion(...turn), new THREE.Vector3(1, 1, 1));
    const group = this.links[link];
    if (!group) return sole;
    group.updateWorldMatrix(true, false);
    return sole.premultiply(group.matrixWorld);
  }

  // Its corners.
  soleCorners(side: 0 | 1): THREE.Vector3[] {
    const { size, centre } = this.description.soles[side];
    const sole = this.solePose(side);
    const signs: [number, number][] = [[1, 1], [-1, 1], [-1, -1], [1, -1]];
    return signs.map(([x, y]) => new THREE.Vector3(centre[0] + (x * size[0]) / 2, centre[1] + (y * size[1]) / 2, 0).applyMatrix4(sole));
  }

  // Faded while what is shown is not of now.
  setOld(old: boolean): void {
    for (const material of this.materials.values()) {
      material.transparent = old;
      material.opacity = old ? 0.35 : 1;
      material.needsUpdate = true;
    }
  }

  private solid(shape: Shape, geometry: THREE.BufferGeometry): THREE.Mesh {
    const key = shape.rgba.join();
    let material = this.materials.get(key);
    if (!material) {
      const [red, green, blue] = shape.rgba;
      material = new THREE.MeshLambertMaterial({ color: new THREE.Color().setRGB(red, green, blue, THREE.SRGBColorSpace) });
      this.materials.set(key, material);
    }
    const mesh = new THREE.Mesh(geometry, material);
    put(mesh, shape);
    return mesh;
  }
}
