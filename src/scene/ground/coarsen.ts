import { BufferAttribute, BufferGeometry } from 'three';

/** The level of detail of a part: sides of round parts, and the size (m) below which a part is left out. */
export interface Coarseness {
  readonly sides: number;
  readonly smallest: number;
}

/** Parts of at most so many triangles stay as they are. */
const FEW = 24;
/** From this length over its radius on, a part is a rod: three sides and no ends. */
const SLENDER = 7;
/** Heights of a part at which its width is kept, as shares of its length. */
const STATIONS = [0, 0.5, 1] as const;

/** A part (axis z, m) with less detail: a prism as wide as the part at either end and half way, or null: too small to see. */
export function coarsen(part: BufferGeometry, { sides, smallest }: Coarseness): BufferGeometry | null {
  part.computeBoundingBox();
  const { min, max } = part.boundingBox!;
  const size = Math.max(max.x - min.x, max.y - min.y, max.z - min.z);
  // A ring would turn into a plate.
  if (size < smallest || part.type === 'TorusGeometry') return null;
  if ((part.index ?? part.getAttribute('position')).count <= FEW * 3) return part.clone();
  const widths = widthsOf(part, min.z, max.z);
  const isRod = max.z - min.z > SLENDER * Math.max(...widths);
  return prism(widths, [min.z, max.z], isRod ? { sides: 3, capped: false } : { sides, capped: true });
}

/** Largest distance from the axis around each station. */
function widthsOf(part: BufferGeometry, from: number, to: number): number[] {
  const position = part.getAttribute('position');
  const widths: number[] = STATIONS.map(() => 0);
  for (let i = 0; i < position.count; i++) {
    const share = (position.getZ(i) - from) / (to - from || 1);
    const station = Math.round(share * (STATIONS.length - 1));
    widths[station] = Math.max(widths[station]!, Math.hypot(position.getX(i), position.getY(i)));
  }
  // A part with no vertex half way is straight between its ends.
  if (widths[1] === 0) widths[1] = (widths[0]! + widths[2]!) / 2;
  return widths;
}

interface PrismStyle {
  readonly sides: number;
  readonly capped: boolean;
}

function prism(
  widths: readonly number[],
  [from, to]: readonly [number, number],
  { sides, capped }: PrismStyle,
): BufferGeometry {
  const corners: number[] = [];
  const put = (station: number, side: number, share = 1) => {
    const angle = (side / sides) * 2 * Math.PI;
    const width = widths[station]! * share;
    const z = from + (to - from) * STATIONS[station]!;
    corners.push(width * Math.cos(angle), width * Math.sin(angle), z);
  };
  const isStraight = Math.abs(widths[1]! - (widths[0]! + widths[2]!) / 2) < 0.02;
  const steps = isStraight ? [[0, 2] as const] : [[0, 1] as const, [1, 2] as const];
  for (let side = 0; side < sides; side++) {
    for (const [low, high] of steps) {
      put(low, side);
      put(low, side + 1);
      put(high, side);
      put(high, side);
      put(low, side + 1);
      put(high, side + 1);
    }
    if (!capped) continue;
    put(0, side + 1);
    put(0, side);
    put(0, side, 0);
    put(2, side);
    put(2, side + 1);
    put(2, side, 0);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  geometry.computeVertexNormals();
  return geometry;
}
