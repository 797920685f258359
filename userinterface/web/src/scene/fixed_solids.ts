// The solids of a world that stay where they are, as few large meshes: those of one tile of the floor are one mesh, with the light already in
// the colours of its corners. Two thousand of them then cost a processor that draws by itself little more than twenty; as instances each would
// cost it a draw of its own.
import * as THREE from "three";
import type { Solid } from "../simulator/solids.ts";
import { shapeOf } from "./solid_shapes.ts";

const tile_m = 3;
const fineAtMost = 300; // solids: a larger world has coarser cylinders and balls

// The picture's lights (scene.ts), in the world's frame: brightness of a face that looks along `normal`, after Lambert.
const sun = new THREE.Vector3(1.5, 2, 4).normalize();
const sunlight = 2.2, skylight = 2;
const underneath = new THREE.Color(0x8899aa);
function light(normal: THREE.Vector3, colour: THREE.Color): THREE.Color {
  const up = 0.5 + 0.5 * normal.z;
  const direct = sunlight * Math.max(normal.dot(sun), 0);
  const lit = (below: number) => (direct + skylight * (below + (1 - below) * up)) / Math.PI;
  return colour.setRGB(lit(underneath.r), lit(underneath.g), lit(underneath.b));
}

class TileBuilder {
  private readonly positions: number[] = [];
  private readonly colours: number[] = [];
  private readonly indices: number[] = [];
  private readonly matrix = new THREE.Matrix4();
  private readonly turn = new THREE.Quaternion();
  private readonly point = new THREE.Vector3();
  private readonly lit = new THREE.Color();
  private readonly paint = new THREE.Color();

  add(solid: Solid, fine: boolean): void {
    const shape = shapeOf(solid.shape, fine);
    const [places, normals] = [shape.getAttribute("position"), shape.getAttribute("normal")];
    const first = this.positions.length / 3;
    const size = new THREE.Vector3(...solid.size);
    this.matrix.compose(this.point.fromArray(solid.place), this.turn.fromArray(solid.turn), size);
    this.paint.setRGB(...solid.colour, THREE.SRGBColorSpace);
    for (let i = 0; i < places.count; ++i) {
      this.point.fromBufferAttribute(places, i).applyMatrix4(this.matrix);
      this.positions.push(this.point.x, this.point.y, this.point.z);
      const { r, g, b } = light(this.point.fromBufferAttribute(normals, i).divide(size).normalize().applyQuaternion(this.turn), this.lit).multiply(this.paint);
      this.colours.push(r, g, b);
    }
    for (const index of shape.index?.array ?? []) this.indices.push(first + index);
  }

  mesh(material: THREE.Material): THREE.Mesh {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(this.positions, 3));
    geometry.setAttribute("color", new THREE.Float32BufferAttribute(this.colours, 3));
    geometry.setIndex(this.indices);
    geometry.computeBoundingSphere();
    return new THREE.Mesh(geometry, material);
  }
}

export class FixedSolids {
  readonly group = new THREE.Group();
  private readonly material = new THREE.MeshBasicMaterial({ vertexColors: true });

  set brightness(share: number) {
    this.material.color.setScalar(share);
  }

  show(solids: readonly Solid[]): void {
    for (const mesh of this.group.children.splice(0)) (mesh as THREE.Mesh).geometry.dispose();
    const tiles = new Map<string, TileBuilder>();
    for (const solid of solids) {
      const at = `${Math.floor(solid.place[0] / tile_m)} ${Math.floor(solid.place[1] / tile_m)}`;
      const tile = tiles.get(at) ?? new TileBuilder();
      tiles.set(at, tile);
      tile.add(solid, solids.length <= fineAtMost);
    }
    for (const tile of tiles.values()) this.group.add(tile.mesh(this.material));
  }

  // What lies wholly behind the haze is not drawn. `eye`: in the world's frame.
  see(eye: THREE.Vector3, far_m: number): void {
    for (const mesh of this.group.children) {
      const ball = (mesh as THREE.Mesh).geometry.boundingSphere;
      mesh.visible = !ball || eye.distanceTo(ball.center) - ball.radius < far_m;
    }
  }
}
