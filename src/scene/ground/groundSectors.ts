import { CELLS, VERTICES } from './levels';
import { type TerrainLevel } from './terrainLevel';
import type { ViewCone } from '../camera/viewCone';

/**
 * A level's triangles ordered by sectors around its centre, so that one draw leaves out those behind the eye. The list
 * is there twice in a row: any run of neighbouring sectors, past the last one too, is one range.
 */
export interface GroundSectors {
  /** SECTOR_INDICES numbers; the level's vertex 0 is `firstVertex`. */
  readonly indices: Uint16Array;
  readonly firstVertex: number;
  /** Where each sector begins in `indices`; twice round, and the end. */
  readonly starts: Uint32Array;
  /** No triangle is nearer to the level's centre, in cells. */
  innerCells: number;
}

const SECTORS = 8;
const WHOLE = 2 * Math.PI;
export const SECTOR_INDICES = CELLS * CELLS * 6 * 2;

export function createSectors(indices: Uint16Array, firstVertex: number): GroundSectors {
  return {
    indices,
    firstVertex,
    starts: new Uint32Array(2 * SECTORS + 1),
    innerCells: 0,
  };
}

/** The cells whose centre is in a sector, for each sector. */
const CELLS_OF: readonly (readonly number[])[] = cellsOfSectors();

function cellsOfSectors(): number[][] {
  const cells = Array.from({ length: SECTORS }, (): number[] => []);
  for (let cell = 0; cell < CELLS * CELLS; cell++) {
    const x = (cell % CELLS) + 0.5 - CELLS / 2;
    const z = Math.floor(cell / CELLS) + 0.5 - CELLS / 2;
    cells[Math.floor(((Math.atan2(z, x) + WHOLE) / WHOLE) * SECTORS) % SECTORS]!.push(cell);
  }
  return cells;
}

/** Writes a level's triangles without the square that the finer level covers. */
export function writeSectors(out: GroundSectors, level: TerrainLevel, finer: TerrainLevel | null): void {
  const { indices, starts, firstVertex } = out;
  const holeX = finer === null ? -1 : finer.cornerX / 2 - level.cornerX;
  const holeZ = finer === null ? -1 : finer.cornerZ / 2 - level.cornerZ;
  const hole = finer === null ? 0 : CELLS / 2;
  // A cell belongs to the sector of its centre and may lean out by less than one.
  out.innerCells = Math.max(0, Math.min(holeX, holeZ, CELLS / 2 - holeX, CELLS / 2 - holeZ) - 1);
  let count = 0;
  for (let sector = 0; sector < SECTORS; sector++) {
    starts[sector] = count;
    for (const cell of CELLS_OF[sector]!) {
      const i = cell % CELLS;
      const k = (cell - i) / CELLS;
      if (i >= holeX && i < holeX + hole && k >= holeZ && k < holeZ + hole) continue;
      const a = firstVertex + k * VERTICES + i;
      const b = a + VERTICES;
      indices[count] = a;
      indices[count + 1] = b;
      indices[count + 2] = a + 1;
      indices[count + 3] = a + 1;
      indices[count + 4] = b;
      indices[count + 5] = b + 1;
      count += 6;
    }
  }
  indices.copyWithin(count, 0, count);
  for (let sector = 0; sector <= SECTORS; sector++)
    starts[SECTORS + sector] = count + (sector === SECTORS ? count : starts[sector]!);
}

/** A range of `indices`. */
export interface IndexRange {
  start: number;
  count: number;
}

/** Directions of the sectors' bounds. */
const COS = Float64Array.from({ length: SECTORS + 1 }, (_, n) => Math.cos((n / SECTORS) * WHOLE));
const SIN = Float64Array.from({ length: SECTORS + 1 }, (_, n) => Math.sin((n / SECTORS) * WHOLE));
/** To the square's corners, and far enough that the chord between two corners of the outline clears the arc; in cells. */
const OUTER_CELLS = ((CELLS / 2) * Math.SQRT2) / Math.cos(WHOLE / SECTORS / 2);

const seen = new Uint8Array(SECTORS);
/** Outline of a sector: x, z of its four corners. */
const outline = new Float64Array(8);

/** The shortest run of sectors that holds all that is inside the cone; an empty range if nothing of the level is. */
export function visibleRange(
  out: IndexRange,
  sectors: GroundSectors,
  level: TerrainLevel,
  cone: ViewCone,
): void {
  const { starts } = sectors;
  let first = 0;
  let run = SECTORS;
  if (!cone.whole && isNearlyFlat(level)) {
    for (let sector = 0; sector < SECTORS; sector++) {
      outlineSector(sector, level, sectors.innerCells);
      seen[sector] = isBeyond(cone, 0, level.spacing) || isBeyond(cone, 2, level.spacing) ? 0 : 1;
    }
    // The longest run out of sight is left out.
    let longest = 0;
    for (let at = 0; at < SECTORS; at++) {
      let hidden = 0;
      while (hidden < SECTORS && seen[(at + hidden) % SECTORS] === 0) hidden++;
      if (hidden <= longest) continue;
      longest = hidden;
      first = (at + hidden) % SECTORS;
    }
    run = SECTORS - longest;
  }
  out.start = starts[first]!;
  out.count = starts[first + run]! - out.start;
}

/** The grid is on the tangent plane, its points on the sphere: within an eighth of the radius they are less than a cell apart. */
function isNearlyFlat({ spacing, cornerX, cornerZ, radius }: TerrainLevel): boolean {
  const off = Math.max(Math.abs(cornerX + CELLS / 2), Math.abs(cornerZ + CELLS / 2));
  return (off + CELLS) * spacing < radius / 8;
}

function outlineSector(sector: number, level: TerrainLevel, innerCells: number): void {
  const { spacing } = level;
  const x = (level.cornerX + CELLS / 2) * spacing;
  const z = (level.cornerZ + CELLS / 2) * spacing;
  const outer = OUTER_CELLS * spacing;
  for (let side = 0; side < 2; side++) {
    const cos = COS[sector + side]!;
    const sin = SIN[sector + side]!;
    outline[side * 4] = x + cos * innerCells * spacing;
    outline[side * 4 + 1] = z + sin * innerCells * spacing;
    outline[side * 4 + 2] = x + cos * outer;
    outline[side * 4 + 3] = z + sin * outer;
  }
}

/** Whether the whole outline is outside of one plane of the cone, by a margin. */
function isBeyond({ x, z, inward }: ViewCone, plane: number, margin: number): boolean {
  for (let i = 0; i < 8; i += 2) {
    const inside = (outline[i]! - x) * inward[plane]! + (outline[i + 1]! - z) * inward[plane + 1]!;
    if (inside > -margin) return false;
  }
  return true;
}
