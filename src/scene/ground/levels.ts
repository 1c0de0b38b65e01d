/** Cells along a side of a level; a multiple of 4, so that its edges lie on vertices of the next coarser level. */
export const CELLS = 48;
/** Vertices along a side. */
export const VERTICES = CELLS + 1;
/** Spacing of the finest level, m: between its vertices the drawn ground is within a millimetre of smooth terrain. */
export const FINEST = 0.4;
/** m: as far as the horizon of a body as seen from some kilometres above it. */
const REACH = 260_000;

/** How many levels reach the horizon of a body. */
export function levelCount(radius: number): number {
  return Math.ceil(Math.log2(Math.min(3 * radius, REACH) / ((CELLS / 2) * FINEST))) + 1;
}

export const MAX_LEVELS = levelCount(Infinity);

/** The GPU's data of a level: VERTICES² points relative to the level's `origin`. */
export interface DrawnPoints {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** How far above the terrain's shadow, in spacings, −4 … 4: sunlit where positive. */
  readonly sunlit: Float32Array;
}
