import {
  Color,
  DynamicDrawUsage,
  IcosahedronGeometry,
  InstancedMesh,
  Matrix4,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
} from 'three';
import type { TerrainHeight } from '../../dynamics';
import type { BodyLook } from '../sky/bodyLook';
import type { LocalFrame } from '../localFrame';
import { cellNoise } from './noise';
import { groundPoint } from './terrainLevel';
import { uploadFirst } from '../uploads';
import { coneMeets, copyCone, createCone, isNearCone, type ViewCone } from '../camera/viewCone';

/** Cells of stones around the ship: size of a cell in m, cells to each side, stones in a cell. */
const CELL = 5;
const REACH = 11;
const PER_CELL = 2;
const MAX_STONES = (2 * REACH + 1) ** 2 * PER_CELL;
/** The sun's shadow map reaches about as far around the ship, m: stones farther away cast no shadow. */
const SHADOW_REACH = 18;
/** m: how far outside the picture a stone is still drawn, so that the choice holds while the eye moves a little. */
const MARGIN = 2;

/** Stones up to knee height, half sunk. They are not in the dynamics, so all are too small to matter under a foot. */
export interface Rocks {
  readonly mesh: InstancedMesh;
  /** The ground of another frame or terrain. */
  setGround(frame: LocalFrame, terrainHeight: TerrainHeight): void;
  /** `shadowY`: local y below which it is in the terrain's shadow. Stones in shadow are left out. */
  follow(x: number, z: number, shadowY: (x: number, z: number) => number): void;
  /** Places the stones relative to the eye (local, m) and leaves out those out of sight. */
  place(eye: Float64Array, cone: ViewCone): void;
  paint(look: BodyLook): void;
  dispose(): void;
}

export function createRocks(): Rocks {
  const geometry = stone();
  const material = new MeshLambertMaterial({ flatShading: true });
  const mesh = new InstancedMesh(geometry, material, MAX_STONES);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  mesh.count = 0;
  const drawn = { seen: 0, shadowed: 0 };
  mesh.onBeforeShadow = () => (mesh.count = drawn.shadowed);
  mesh.onAfterShadow = () => (mesh.count = drawn.seen);
  const field = createField();
  const culled = createCone();
  let isCulled = false;
  let where: StoneGround | null = null;

  return {
    mesh,
    setGround(frame, terrainHeight) {
      where = { frame, terrainHeight };
      field.cellX = NaN;
    },
    follow(x, z, shadowY) {
      const i = Math.round(x / CELL);
      const k = Math.round(z / CELL);
      if (where === null || (Math.abs(i - field.cellX) <= 1 && Math.abs(k - field.cellZ) <= 1)) return;
      field.cellX = i;
      field.cellZ = k;
      scatter(field, where, shadowY);
      isCulled = false;
    },
    place(eye, cone) {
      const { origin } = field;
      mesh.position.set(origin[0]! - eye[0]!, origin[1]! - eye[1]!, origin[2]! - eye[2]!);
      if (isCulled && isNearCone(culled, cone, MARGIN / 2, MARGIN / (2 * REACH * CELL))) return;
      copyCone(culled, cone);
      isCulled = true;
      writeVisible(mesh, drawn, field, cone);
    },
    paint(look) {
      const [r, g, b] = look.stone;
      material.color.copy(new Color().setRGB(r, g, b));
      field.stoniness = look.stoniness;
    },
    dispose() {
      geometry.dispose();
      material.dispose();
      mesh.dispose();
    },
  };
}

interface StoneGround {
  readonly frame: LocalFrame;
  readonly terrainHeight: TerrainHeight;
}

/** The stones around a cell. */
interface StoneField {
  cellX: number;
  cellZ: number;
  stoniness: number;
  /** Local, m; the matrices are relative to it. */
  readonly origin: Float64Array;
  /** Those within reach of the shadow map come first. */
  readonly matrices: Float32Array;
  count: number;
  /** Number of those within reach of the shadow map. */
  close: number;
}

function createField(): StoneField {
  return {
    cellX: NaN,
    cellZ: NaN,
    stoniness: 1,
    origin: new Float64Array(3),
    matrices: new Float32Array(MAX_STONES * 16),
    count: 0,
    close: 0,
  };
}

const matrix = new Matrix4();
const point = new Float64Array(3);

function scatter(field: StoneField, where: StoneGround, shadowY: (x: number, z: number) => number): void {
  const { cellX, cellZ, origin, matrices } = field;
  groundPoint(origin, 0, cellX * CELL, cellZ * CELL, where);
  const far: Matrix4[] = [];
  field.count = 0;
  for (let k = cellZ - REACH; k <= cellZ + REACH; k++) {
    for (let i = cellX - REACH; i <= cellX + REACH; i++) {
      for (let n = 0; n < PER_CELL; n++) {
        const seed = 31 + n * 7;
        if (cellNoise(i, k, seed) > 0.3 * field.stoniness) continue;
        const x = (i + cellNoise(i, k, seed + 1)) * CELL;
        const z = (k + cellNoise(i, k, seed + 2)) * CELL;
        groundPoint(point, 0, x, z, where);
        if (point[1]! < shadowY(x, z)) continue;
        const away = poseStone(matrix, i, k, seed, origin);
        if (away < SHADOW_REACH) matrix.toArray(matrices, 16 * field.count++);
        else far.push(matrix.clone());
      }
    }
  }
  field.close = field.count;
  for (const each of far) each.toArray(matrices, 16 * field.count++);
}

const turn = new Quaternion();
const axis = new Vector3();
const size = new Vector3();
const at = new Vector3();

/** The stone of a cell at `point`, half sunk; gives its distance along the ground from the origin, m. */
function poseStone(out: Matrix4, i: number, k: number, seed: number, origin: Float64Array): number {
  const radius = 0.05 + 0.3 * cellNoise(i, k, seed + 3) ** 4;
  at.set(point[0]! - origin[0]!, point[1]! - origin[1]! + radius * 0.15, point[2]! - origin[2]!);
  axis.set(cellNoise(i, k, seed + 4) - 0.5, 1, cellNoise(i, k, seed + 5) - 0.5).normalize();
  turn.setFromAxisAngle(axis, 2 * Math.PI * cellNoise(i, k, seed + 6));
  size.set(radius, radius * (0.55 + 0.4 * cellNoise(i, k, seed + 4)), radius * 0.85);
  out.compose(at, turn, size);
  return Math.hypot(at.x, at.z);
}

/** Copies the stones in sight to the instances, and only those to the GPU. */
function writeVisible(
  mesh: InstancedMesh,
  drawn: { seen: number; shadowed: number },
  { matrices, origin, count, close }: StoneField,
  cone: ViewCone,
): void {
  const { instanceMatrix } = mesh;
  const to = instanceMatrix.array;
  let seen = 0;
  drawn.shadowed = 0;
  for (let n = 0; n < count; n++) {
    const from = n * 16;
    if (!coneMeets(cone, matrices[from + 12]! + origin[0]!, matrices[from + 14]! + origin[2]!, MARGIN))
      continue;
    for (let i = 0; i < 16; i++) to[seen * 16 + i] = matrices[from + i]!;
    seen++;
    if (n < close) drawn.shadowed = seen;
  }
  drawn.seen = seen;
  mesh.count = seen;
  uploadFirst(instanceMatrix, seen);
}

function stone(): IcosahedronGeometry {
  const geometry = new IcosahedronGeometry(1, 1);
  const position = geometry.getAttribute('position');
  for (let i = 0; i < position.count; i++) {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
    const bump = 0.75 + 0.5 * cellNoise(Math.round(x * 40), Math.round(y * 40 + z * 1600), 3);
    position.setXYZ(i, x * bump, y * bump, z * bump);
  }
  return geometry;
}
