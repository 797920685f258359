// The shapes that stand in a simulated world, of the size 1.
import * as THREE from "three";
import type { SolidShape } from "../simulator/solids.ts";

const makers: Record<SolidShape, (fine: boolean) => THREE.BufferGeometry> = {
  box: () => new THREE.BoxGeometry(1, 1, 1),
  cylinder: (fine) => new THREE.CylinderGeometry(0.5, 0.5, 1, fine ? 24 : 8).rotateX(Math.PI / 2),
  sphere: (fine) => (fine ? new THREE.SphereGeometry(0.5, 20, 14) : new THREE.SphereGeometry(0.5, 8, 5)),
};
const made = new Map<string, THREE.BufferGeometry>();

export function shapeOf(shape: SolidShape, fine: boolean): THREE.BufferGeometry {
  const key = `${shape} ${fine}`;
  const geometry = made.get(key) ?? makers[shape](fine);
  made.set(key, geometry);
  return geometry;
}
