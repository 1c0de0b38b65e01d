import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

/** A flat ring that follows the ground. Its vertices are relative to its centre, m. */
export interface GroundRing {
  readonly geometry: BufferGeometry;
  /** Fits the ring to the ground around `centre` (local, m). */
  readonly fit: (centre: ArrayLike<number>, groundY: (x: number, z: number) => number) => void;
}

/** m above the ground it follows. */
const LIFT = 0.2;

/** A ring of outer `radius` and `width`, m. Fit it before it is drawn. */
export function createGroundRing(radius: number, width: number, segments: number): GroundRing {
  const points = new Float32Array((segments + 1) * 6);
  const index: number[] = [];
  for (let i = 0; i < segments; i++) index.push(2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2);
  const position = new BufferAttribute(points, 3).setUsage(DynamicDrawUsage);
  const geometry = new BufferGeometry().setAttribute('position', position).setIndex(index);
  const put = (at: number, x: number, y: number, z: number) => {
    points[at] = x;
    points[at + 1] = y;
    points[at + 2] = z;
  };
  return {
    geometry,
    fit(centre, groundY) {
      const cx = centre[0]!;
      const cy = centre[1]!;
      const cz = centre[2]!;
      for (let i = 0; i <= segments; i++) {
        const angle = (2 * Math.PI * i) / segments;
        for (let side = 0; side < 2; side++) {
          const r = side === 0 ? radius - width : radius;
          const x = r * Math.cos(angle);
          const z = r * Math.sin(angle);
          put(6 * i + 3 * side, x, groundY(cx + x, cz + z) - cy + LIFT, z);
        }
      }
      position.needsUpdate = true;
    },
  };
}
