import type { TerrainHeight } from '../../dynamics';
import type { LocalFrame } from '../localFrame';
import { CELLS, type DrawnPoints, VERTICES } from './levels';

/** Vertices along a side, with one more all around for the slopes at the edge. */
const SIDE = CELLS + 3;
/**
 * One ring of the ground: a square grid of `spacing` metres on the plane y = 0 of the local frame, each point pushed along
 * its radius to body radius + terrain height, in doubles. Points are kept while the grid moves: a step
 * of the ship costs one row of terrain calls, not a square.
 */
export interface TerrainLevel extends DrawnPoints {
  readonly spacing: number;
  /** Grid index (in spacings from the frame's origin) of vertex (0, 0). */
  cornerX: number;
  cornerZ: number;
  filled: boolean;
  /** Of the body's sphere, and how far the level's points reach above (or below) it, m. */
  radius: number;
  lowest: number;
  highest: number;
  /** SIDE × SIDE points x, y, z in the local frame. */
  points: Float64Array;
  spare: Float64Array;
  /** Height of the terrain's own shadow over each point's column, m, local y. */
  readonly shade: Float64Array;
  /** Of the drawn points, local, m. */
  readonly origin: Float64Array;
}

export function createLevel(spacing: number, { positions, normals, sunlit }: DrawnPoints): TerrainLevel {
  return {
    spacing,
    cornerX: 0,
    cornerZ: 0,
    filled: false,
    radius: Infinity,
    lowest: 0,
    highest: 0,
    points: new Float64Array(SIDE * SIDE * 3),
    spare: new Float64Array(SIDE * SIDE * 3),
    shade: new Float64Array(SIDE * SIDE),
    origin: new Float64Array(3),
    positions,
    normals,
    sunlit,
  };
}

/** The corner that centres a level on (x, z), on an even index. */
export function cornerFor(level: TerrainLevel, along: number): number {
  return 2 * Math.round(along / level.spacing / 2) - CELLS / 2;
}

/** Moves a level to a corner; computes only the points that neither it nor the next coarser level, of the same ground, has. */
export function moveLevel(
  level: TerrainLevel,
  corner: readonly [number, number],
  frame: LocalFrame,
  terrainHeight: TerrainHeight,
  coarser: TerrainLevel | null = null,
): void {
  const [cornerX, cornerZ] = corner;
  const { points: old, spare: fresh } = level;
  const place = { frame, terrainHeight };
  const shiftX = cornerX - level.cornerX;
  const shiftZ = cornerZ - level.cornerZ;
  for (let k = 0; k < SIDE; k++) {
    const oldK = k + shiftZ;
    for (let i = 0; i < SIDE; i++) {
      const oldI = i + shiftX;
      const at = (k * SIDE + i) * 3;
      if (level.filled && oldK >= 0 && oldK < SIDE && oldI >= 0 && oldI < SIDE) {
        copyPoint(fresh, at, old, (oldK * SIDE + oldI) * 3);
        continue;
      }
      const x = cornerX + i - 1;
      const z = cornerZ + k - 1;
      // Every second row and column is the coarser level's too.
      const shared = coarser === null || ((x | z) & 1) === 1 ? -1 : pointAt(coarser, x / 2, z / 2);
      if (shared >= 0) copyPoint(fresh, at, coarser!.points, shared);
      else groundPoint(fresh, at, x * level.spacing, z * level.spacing, place);
    }
  }
  level.points = fresh;
  level.spare = old;
  level.radius = frame.radius;
  measureHeights(level);
  level.cornerX = cornerX;
  level.cornerZ = cornerZ;
  level.filled = true;
}

function copyPoint(out: Float64Array, to: number, points: Float64Array, from: number): void {
  out[to] = points[from]!;
  out[to + 1] = points[from + 1]!;
  out[to + 2] = points[from + 2]!;
}

/** Where `points` has the vertex of a grid index (whole spacings from the frame's origin), or −1: the level has none there. */
function pointAt({ filled, cornerX, cornerZ }: TerrainLevel, x: number, z: number): number {
  if (!filled) return -1;
  const i = x - cornerX + 1;
  const k = z - cornerZ + 1;
  return i >= 0 && i < SIDE && k >= 0 && k < SIDE ? (k * SIDE + i) * 3 : -1;
}

function measureHeights(level: TerrainLevel): void {
  const { points, radius } = level;
  let lowest = Infinity;
  let highest = -Infinity;
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i]!;
    const y = points[i + 1]!;
    const z = points[i + 2]!;
    // |r| − R without the difference of two planet radii.
    const over = x * x + y * y + z * z + 2 * y * radius;
    const height = over / (Math.sqrt(radius * radius + over) + radius);
    if (height < lowest) lowest = height;
    if (height > highest) highest = height;
  }
  level.lowest = lowest;
  level.highest = highest;
}

interface Place {
  readonly frame: LocalFrame;
  readonly terrainHeight: TerrainHeight;
}

/** The point of the ground over (x, z) of the tangent plane. */
export function groundPoint(out: Float64Array, at: number, x: number, z: number, place: Place): void {
  const { frame, terrainHeight } = place;
  const { axes, radius } = frame;
  const perLength = 1 / Math.sqrt(x * x + radius * radius + z * z);
  const lx = x * perLength;
  const ly = radius * perLength;
  const lz = z * perLength;
  const height = terrainHeight(
    frame.bodyName,
    axes[0]! * lx + axes[3]! * ly + axes[6]! * lz,
    axes[1]! * lx + axes[4]! * ly + axes[7]! * lz,
    axes[2]! * lx + axes[5]! * ly + axes[8]! * lz,
  );
  const r = radius + height;
  out[at] = lx * r;
  // ly·r − radius without losing the small difference of two planet radii.
  out[at + 1] = ly * height - (radius * (x * x + z * z) * perLength * perLength) / (1 + ly);
  out[at + 2] = lz * r;
}

/** Sweeps each row away from the sun; at the sunward edge the coarser level supplies the shadow of the ground beyond. */
export function shadeLevel(level: TerrainLevel, coarser: TerrainLevel | null, frame: LocalFrame): void {
  const { points, shade } = level;
  const drop = level.spacing * frame.sunSlope;
  for (let k = 0; k < SIDE; k++) {
    const edge = k * SIDE + SIDE - 1;
    const z = (level.cornerZ + k - 1) * level.spacing;
    const x = (level.cornerX + SIDE - 2) * level.spacing;
    let over = coarser === null ? -Infinity : shadeOver(coarser, x, z);
    shade[edge] = over;
    for (let i = SIDE - 2; i >= 0; i--) {
      const at = k * SIDE + i;
      const before = points[(at + 1) * 3 + 1]!;
      over = (over > before ? over : before) - drop;
      shade[at] = over;
    }
  }
}

/** A level's shadow height over (x, z), between its points. */
export function shadeOver(level: TerrainLevel, x: number, z: number): number {
  const u = x / level.spacing - level.cornerX + 1;
  const v = z / level.spacing - level.cornerZ + 1;
  const i = Math.min(Math.max(Math.floor(u), 0), SIDE - 2);
  const k = Math.min(Math.max(Math.floor(v), 0), SIDE - 2);
  const at = k * SIDE + i;
  const { shade } = level;
  const near = shade[at]! + (shade[at + 1]! - shade[at]!) * (u - i);
  const far = shade[at + SIDE]! + (shade[at + SIDE + 1]! - shade[at + SIDE]!) * (u - i);
  const over = near + (far - near) * (v - k);
  return Number.isNaN(over) ? -Infinity : over;
}

/** Fills the drawn arrays. The outer edge is drawn on the coarser level's edges, so that no crack shows between them. */
export function layOutLevel(level: TerrainLevel): void {
  const { points, shade, origin, positions, normals, sunlit, spacing } = level;
  origin[0] = (level.cornerX + CELLS / 2) * spacing;
  origin[1] = points[((1 + CELLS / 2) * SIDE + 1 + CELLS / 2) * 3 + 1]!;
  origin[2] = (level.cornerZ + CELLS / 2) * spacing;
  const [ox, oy, oz] = [origin[0], origin[1], origin[2]];
  for (let k = 0, to = 0; k < VERTICES; k++) {
    for (let i = 0; i < VERTICES; i++, to++) {
      const at = (k + 1) * SIDE + i + 1;
      const p = at * 3;
      positions[to * 3] = points[p]! - ox;
      positions[to * 3 + 1] = points[p + 1]! - oy;
      positions[to * 3 + 2] = points[p + 2]! - oz;
      const slopeX = (points[p + 4]! - points[p - 2]!) / (points[p + 3]! - points[p - 3]!);
      const down = p - SIDE * 3;
      const next = p + SIDE * 3;
      const slopeZ = (points[next + 1]! - points[down + 1]!) / (points[next + 2]! - points[down + 2]!);
      const perLength = 1 / Math.sqrt(slopeX * slopeX + slopeZ * slopeZ + 1);
      normals[to * 3] = -slopeX * perLength;
      normals[to * 3 + 1] = perLength;
      normals[to * 3 + 2] = -slopeZ * perLength;
      const above = (points[p + 1]! - shade[at]!) / spacing;
      sunlit[to] = Math.max(-4, Math.min(4, above));
    }
  }
  stitchEdges(positions);
}

/** Odd vertices of the edges go half way between their neighbours. */
function stitchEdges(positions: Float32Array): void {
  const last = CELLS * VERTICES;
  for (let i = 1; i < CELLS; i += 2) {
    midpoint(positions, i, 1);
    midpoint(positions, last + i, 1);
    midpoint(positions, i * VERTICES, VERTICES);
    midpoint(positions, i * VERTICES + CELLS, VERTICES);
  }
}

function midpoint(positions: Float32Array, at: number, step: number): void {
  for (let axis = 0; axis < 3; axis++) {
    positions[at * 3 + axis] = (positions[(at - step) * 3 + axis]! + positions[(at + step) * 3 + axis]!) / 2;
  }
}
