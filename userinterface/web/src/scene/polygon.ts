// Plane geometry of the soles.

export type Point = readonly [number, number];

// Counter-clockwise (Andrew's monotone chain).
export function convexHull(points: readonly Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turnsLeft = (a: Point, b: Point, c: Point) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 1e-12;
  const half = (sequence: readonly Point[]) => {
    const chain: Point[] = [];
    for (const point of sequence) {
      while (chain.length >= 2 && !turnsLeft(chain[chain.length - 2] as Point, chain[chain.length - 1] as Point, point)) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}
