import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  Mesh,
  type ShaderMaterial,
  Sphere,
  Vector3,
} from 'three';
import type { TerrainHeight } from '../../dynamics';
import { createSectors, type GroundSectors, visibleRange, writeSectors } from './groundSectors';
import { isOverHorizon } from '../sky/horizon';
import type { LocalFrame } from '../localFrame';
import {
  CELLS,
  cornerFor,
  createLevel,
  layOutLevel,
  moveLevel,
  shadeLevel,
  shadeOver,
  type TerrainLevel,
} from './terrainLevel';
import type { ViewCone } from '../camera/viewCone';

/** Spacing of the finest level, m: between its vertices the drawn ground is within a millimetre of smooth terrain. */
const FINEST = 0.4;
/** A level moves when the ship is this many cells from its centre. */
const SLACK = 6;

export interface Ground {
  readonly group: Group;
  /** The ground of another frame or terrain; `follow` fills it. */
  rebuild(frame: LocalFrame, terrainHeight: TerrainHeight): void;
  /** Follows a local point: a few levels a call move, coarsest first. */
  follow(x: number, z: number, levelsAtOnce: number): void;
  /** Places the meshes relative to the eye (local, m) and leaves out those that it cannot see. */
  place(eye: Float64Array, cone: ViewCone): void;
  /** Local y below which a point over (x, z) is in the terrain's own shadow, m. */
  readonly shadowY: (x: number, z: number) => number;
  dispose(): void;
}

interface Ring {
  readonly level: TerrainLevel;
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly sectors: GroundSectors;
  holeKey: number;
}

/** How many levels reach the horizon of a body as seen from some kilometres above it. */
function levelCount(radius: number): number {
  const reach = Math.min(3 * radius, 260_000);
  return Math.ceil(Math.log2(reach / ((CELLS / 2) * FINEST))) + 1;
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
  const group = new Group();
  let rings: Ring[] = [];
  let place: { frame: LocalFrame; terrainHeight: TerrainHeight } | null = null;

  const drop = () => {
    for (const ring of rings) {
      group.remove(ring.mesh);
      ring.mesh.geometry.dispose();
    }
    rings = [];
  };

  const follow = (x: number, z: number, levelsAtOnce: number) => {
    if (place === null) return;
    // After a teleport the ground is complete in the next frame, however long that takes.
    let left = isUnder(rings[0]!.level, x, z) ? levelsAtOnce : Infinity;
    let changed = false;
    for (let n = rings.length - 1; n >= 0 && left > 0; n--) {
      const { level, mesh } = rings[n]!;
      if (level.filled && offCentre(level, x, z) <= SLACK) continue;
      const corner = [cornerFor(level, x), cornerFor(level, z)] as const;
      const coarser = rings[n + 1]?.level ?? null;
      moveLevel(level, corner, place.frame, place.terrainHeight, coarser);
      shadeLevel(level, coarser, place.frame);
      layOutLevel(level);
      upload(mesh.geometry);
      left--;
      changed = true;
    }
    if (changed) rings.forEach((ring, n) => cutHole(ring, rings[n - 1] ?? null));
  };

  return {
    group,
    rebuild(frame, terrainHeight) {
      drop();
      place = { frame, terrainHeight };
      rings = Array.from({ length: levelCount(frame.radius) }, (_, n) =>
        createRing(FINEST * 2 ** n, material),
      );
      for (const ring of rings) group.add(ring.mesh);
    },
    follow,
    place(eye, cone) {
      const lowest = lowestOf(rings);
      for (const { level, mesh, sectors } of rings) {
        const { origin } = level;
        visibleRange(range, sectors, level, cone);
        mesh.visible = range.count > 0 && !isOverHorizon(level, sectors.innerCells, eye, lowest);
        mesh.geometry.setDrawRange(range.start, range.count);
        mesh.matrixWorld.setPosition(origin[0]! - eye[0]!, origin[1]! - eye[1]!, origin[2]! - eye[2]!);
      }
    },
    shadowY: (x, z) => shadowOver(rings, x, z),
    dispose: drop,
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

function createRing(spacing: number, material: ShaderMaterial): Ring {
  const level = createLevel(spacing);
  const geometry = new BufferGeometry();
  const sectors = createSectors();
  const dynamic = (array: Float32Array | Uint16Array, size: number) =>
    new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
  geometry.setAttribute('position', dynamic(level.positions, 3));
  geometry.setAttribute('normal', dynamic(level.normals, 3));
  geometry.setAttribute('sunlit', dynamic(level.sunlit, 1));
  geometry.setIndex(dynamic(sectors.indices, 1));
  geometry.boundingSphere = new Sphere(new Vector3(), CELLS * spacing);
  const mesh = new Mesh(geometry, material);
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  // `place` writes it: it only shifts.
  mesh.matrixWorldAutoUpdate = false;
  return { level, mesh, sectors, holeKey: NaN };
}

function upload(geometry: BufferGeometry): void {
  for (const name of ['position', 'normal', 'sunlit']) geometry.getAttribute(name).needsUpdate = true;
}

/** Leaves out the area that the finer level covers, if that has changed. */
function cutHole(ring: Ring, finer: Ring | null): void {
  const { level } = ring;
  const key =
    finer === null
      ? 0
      : (finer.level.cornerX / 2 - level.cornerX) * 4096 + (finer.level.cornerZ / 2 - level.cornerZ);
  if (key === ring.holeKey) return;
  ring.holeKey = key;
  const { geometry } = ring.mesh;
  writeSectors(ring.sectors, level, finer?.level ?? null);
  geometry.index!.needsUpdate = true;
}
