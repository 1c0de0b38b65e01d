import type { BufferGeometry, Mesh, ShaderMaterial } from 'three';
import type { TerrainHeight } from '../../dynamics';
import { createGroundMesh, type GroundMesh } from './groundMesh';
import { type GroundSectors, visibleRange, writeSectors } from './groundSectors';
import { isOverHorizon } from '../sky/horizon';
import type { LocalFrame } from '../localFrame';
import { CELLS, FINEST, levelCount } from './levels';
import {
  cornerFor,
  createLevel,
  layOutLevel,
  moveLevel,
  shadeLevel,
  shadeOver,
  type TerrainLevel,
} from './terrainLevel';
import type { ViewCone } from '../camera/viewCone';

/** A level moves when the ship is this many cells from its centre. */
const SLACK = 6;

export interface Ground {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  /** The ground of another frame or terrain; `follow` fills it. */
  rebuild(frame: LocalFrame, terrainHeight: TerrainHeight): void;
  /** Follows a local point: a few levels a call move, coarsest first. */
  follow(x: number, z: number, levelsAtOnce: number): void;
  /** Places the levels relative to the eye (local, m) and leaves out those that it cannot see. */
  place(eye: Float64Array, cone: ViewCone): void;
  /** Local y below which a point over (x, z) is in the terrain's own shadow, m. */
  readonly shadowY: (x: number, z: number) => number;
  dispose(): void;
}

interface Ring {
  readonly level: TerrainLevel;
  readonly sectors: GroundSectors;
  holeKey: number;
}

const range = { start: 0, count: 0 };

function lowestOf(rings: readonly Ring[]): number {
  let lowest = Infinity;
  for (const { level } of rings) if (level.lowest < lowest) lowest = level.lowest;
  return lowest;
}

/** Cells between a level's centre and where it would be centred for a ship at (x, z). */
function offCentre(level: TerrainLevel, x: number, z: number): number {
  const { cornerX, cornerZ } = level;
  return Math.max(Math.abs(cornerFor(level, x) - cornerX), Math.abs(cornerFor(level, z) - cornerZ));
}

function isUnder(level: TerrainLevel, x: number, z: number): boolean {
  return level.filled && offCentre(level, x, z) < CELLS / 2;
}

export function createGround(material: ShaderMaterial): Ground {
  const drawn = createGroundMesh(material);
  let rings: Ring[] = [];
  let place: { frame: LocalFrame; terrainHeight: TerrainHeight } | null = null;

  const follow = (x: number, z: number, levelsAtOnce: number) => {
    if (place === null) return;
    // After a teleport the ground is complete in the next frame, however long that takes.
    let left = isUnder(rings[0]!.level, x, z) ? levelsAtOnce : Infinity;
    let changed = false;
    for (let n = rings.length - 1; n >= 0 && left > 0; n--) {
      const { level } = rings[n]!;
      if (level.filled && offCentre(level, x, z) <= SLACK) continue;
      const corner = [cornerFor(level, x), cornerFor(level, z)] as const;
      const coarser = rings[n + 1]?.level ?? null;
      moveLevel(level, corner, place.frame, place.terrainHeight, coarser);
      shadeLevel(level, coarser, place.frame);
      layOutLevel(level);
      drawn.uploadPoints(n);
      left--;
      changed = true;
    }
    if (!changed) return;
    rings.forEach((ring, n) => {
      if (cutHole(ring, rings[n - 1] ?? null)) drawn.uploadSectors(n);
    });
  };

  return {
    mesh: drawn.mesh,
    rebuild(frame, terrainHeight) {
      place = { frame, terrainHeight };
      rings = Array.from({ length: levelCount(frame.radius) }, (_, n) => createRing(n, drawn));
    },
    follow,
    place(eye, cone) {
      const lowest = lowestOf(rings);
      drawn.clear();
      for (let n = 0; n < rings.length; n++) {
        const { level, sectors } = rings[n]!;
        visibleRange(range, sectors, level, cone);
        if (range.count === 0 || isOverHorizon(level, sectors.innerCells, eye, lowest)) continue;
        const { origin } = level;
        drawn.show(n, range, origin[0]! - eye[0]!, origin[1]! - eye[1]!, origin[2]! - eye[2]!);
      }
    },
    shadowY: (x, z) => shadowOver(rings, x, z),
    dispose: () => drawn.dispose(),
  };
}

function shadowOver(rings: readonly Ring[], x: number, z: number): number {
  for (const { level } of rings) {
    const { origin, spacing } = level;
    const off = Math.max(Math.abs(x - origin[0]!), Math.abs(z - origin[2]!));
    if (level.filled && off < (CELLS / 2) * spacing) return shadeOver(level, x, z);
  }
  return -Infinity;
}

function createRing(n: number, { points, sectors }: GroundMesh): Ring {
  return { level: createLevel(FINEST * 2 ** n, points[n]!), sectors: sectors[n]!, holeKey: NaN };
}

/** Leaves out the area that the finer level covers; whether that has changed. */
function cutHole(ring: Ring, finer: Ring | null): boolean {
  const { level } = ring;
  const key =
    finer === null
      ? 0
      : (finer.level.cornerX / 2 - level.cornerX) * 4096 + (finer.level.cornerZ / 2 - level.cornerZ);
  if (key === ring.holeKey) return false;
  ring.holeKey = key;
  writeSectors(ring.sectors, level, finer?.level ?? null);
  return true;
}
