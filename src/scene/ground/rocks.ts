import {
  Color,
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
import { coneMeets, type ViewCone } from '../camera/viewCone';

/** Cells of stones around the ship: metres a cell, cells to each side. */
const CELL = 5;
const REACH = 11;
const PER_CELL = 2;
const MOST = (2 * REACH + 1) ** 2 * PER_CELL;
/** The sun's shadow map reaches about as far around the ship, m: stones farther off throw no shadow. */
const SHADOW_REACH = 18;

/** Stones up to knee height, half sunk; the law does not know them, so none is large enough to be missed under a foot. */
export interface Rocks {
  readonly mesh: InstancedMesh;
  lay(frame: LocalFrame, terrainHeight: TerrainHeight): void;
  /** `shadowY` tells below which local y the terrain's shadow lies: stones in it are black on black and left out. */
  follow(x: number, z: number, shadowY: (x: number, z: number) => number): void;
  /** Places them relative to the eye (local, m) and leaves out what it cannot see. */
  place(eye: Float64Array, cone: ViewCone): void;
  paint(look: BodyLook): void;
  dispose(): void;
}

export function createRocks(): Rocks {
  const geometry = stone();
  const material = new MeshLambertMaterial({ flatShading: true });
  const mesh = new InstancedMesh(geometry, material, MOST);
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  mesh.count = 0;
  let shadowed = 0;
  let seen = 0;
  mesh.onBeforeShadow = () => (mesh.count = shadowed);
  mesh.onAfterShadow = () => (mesh.count = seen);
  /** Matrices of all stones, those within the shadows' reach first, and how many there are of either. */
  const matrices = new Float32Array(MOST * 16);
  let all = 0;
  let close = 0;
  let where: { frame: LocalFrame; terrainHeight: TerrainHeight } | null = null;
  let cellX = NaN;
  let cellZ = NaN;
  let stoniness = 1;
  const origin = new Float64Array(3);
  const point = new Float64Array(3);
  const matrix = new Matrix4();
  const turn = new Quaternion();
  const axis = new Vector3();
  const size = new Vector3();
  const at = new Vector3();

  const scatter = (shadowY: (x: number, z: number) => number) => {
    if (where === null) return;
    groundPoint(origin, 0, cellX * CELL, cellZ * CELL, where);
    const far: Matrix4[] = [];
    all = 0;
    for (let k = cellZ - REACH; k <= cellZ + REACH; k++) {
      for (let i = cellX - REACH; i <= cellX + REACH; i++) {
        for (let n = 0; n < PER_CELL; n++) {
          const seed = 31 + n * 7;
          if (cellNoise(i, k, seed) > 0.3 * stoniness) continue;
          const x = (i + cellNoise(i, k, seed + 1)) * CELL;
          const z = (k + cellNoise(i, k, seed + 2)) * CELL;
          groundPoint(point, 0, x, z, where);
          if (point[1]! < shadowY(x, z)) continue;
          const radius = 0.05 + 0.3 * cellNoise(i, k, seed + 3) ** 4;
          at.set(point[0]! - origin[0]!, point[1]! - origin[1]! + radius * 0.15, point[2]! - origin[2]!);
          axis.set(cellNoise(i, k, seed + 4) - 0.5, 1, cellNoise(i, k, seed + 5) - 0.5).normalize();
          turn.setFromAxisAngle(axis, 6.28 * cellNoise(i, k, seed + 6));
          size.set(radius, radius * (0.55 + 0.4 * cellNoise(i, k, seed + 4)), radius * 0.85);
          matrix.compose(at, turn, size);
          if (Math.hypot(at.x, at.z) < SHADOW_REACH) matrix.toArray(matrices, 16 * all++);
          else far.push(matrix.clone());
        }
      }
    }
    close = all;
    for (const each of far) each.toArray(matrices, 16 * all++);
  };

  const leaveOutHidden = (cone: ViewCone) => {
    const drawn = mesh.instanceMatrix.array;
    seen = 0;
    shadowed = 0;
    for (let n = 0; n < all; n++) {
      const from = n * 16;
      if (!coneMeets(cone, matrices[from + 12]! + origin[0]!, matrices[from + 14]! + origin[2]!, 1)) continue;
      for (let i = 0; i < 16; i++) drawn[seen * 16 + i] = matrices[from + i]!;
      seen++;
      if (n < close) shadowed = seen;
    }
    mesh.count = seen;
    mesh.instanceMatrix.needsUpdate = true;
  };

  return {
    mesh,
    lay(frame, terrainHeight) {
      where = { frame, terrainHeight };
      cellX = NaN;
    },
    follow(x, z, shadowY) {
      const [i, k] = [Math.round(x / CELL), Math.round(z / CELL)];
      if (Math.abs(i - cellX) <= 1 && Math.abs(k - cellZ) <= 1) return;
      cellX = i;
      cellZ = k;
      scatter(shadowY);
    },
    place(eye, cone) {
      leaveOutHidden(cone);
      mesh.position.set(origin[0]! - eye[0]!, origin[1]! - eye[1]!, origin[2]! - eye[2]!);
    },
    paint(look) {
      const [r, g, b] = look.stone;
      material.color.copy(new Color().setRGB(r, g, b));
      stoniness = look.stoniness;
    },
    dispose() {
      geometry.dispose();
      material.dispose();
      mesh.dispose();
    },
  };
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
