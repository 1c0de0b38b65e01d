import {
  DynamicDrawUsage,
  InstancedMesh,
  Matrix4,
  MeshStandardMaterial,
  Quaternion,
  TetrahedronGeometry,
  Vector3,
} from 'three';
import { cellNoise } from '../ground/noise';

/** Pieces of a crashed ship. Places are relative to the crash, local axes, m. */
export interface Debris {
  readonly mesh: InstancedMesh;
  /** Finds where each piece lands; `origin` local, m. */
  begin(origin: Float64Array, gravity: number, groundY: (x: number, z: number) => number): void;
  /** `age` s since the crash, `reach`: size of the ship, m. */
  place(age: number, gravity: number, reach: number): void;
  dispose(): void;
}

const PIECES = 64;
/** m/s: the fastest piece. */
const FASTEST = 22;
/** rad/s, while it flies. */
const TUMBLE = 7;
/** s: a piece still in the air after this is not followed; and the step in which its landing is searched. */
const LONGEST_FLIGHT = 60;
const STEP = 0.25;

interface Piece {
  readonly velocity: Vector3;
  readonly axis: Vector3;
  /** In sizes of the ship. */
  readonly size: number;
  /** s after the crash at which it comes to rest. */
  lands: number;
}

export function createDebris(): Debris {
  const shape = new TetrahedronGeometry(1, 0);
  const metal = new MeshStandardMaterial({
    color: 0x3a3a3e,
    roughness: 0.8,
    metalness: 0.4,
    flatShading: true,
  });
  const mesh = new InstancedMesh(shape, metal, PIECES);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.castShadow = true;
  mesh.frustumCulled = false;
  const pieces = Array.from({ length: PIECES }, (_, n) => pieceOf(n));
  const at = new Vector3();
  const turn = new Quaternion();
  const scale = new Vector3();
  const matrix = new Matrix4();
  let lastLanding = 0;
  let placed = NaN;

  return {
    mesh,
    begin(origin, gravity, groundY) {
      for (const piece of pieces) piece.lands = landingOf(piece, gravity, origin, groundY);
      lastLanding = Math.max(...pieces.map(({ lands }) => lands));
      placed = NaN;
    },
    place(age, gravity, reach) {
      const until = Math.min(age, lastLanding);
      // All at rest: nothing moves any more.
      if (until === placed) return;
      placed = until;
      for (let n = 0; n < PIECES; n++) {
        const { velocity, axis, size, lands } = pieces[n]!;
        const t = Math.min(age, lands);
        at.copy(velocity).multiplyScalar(t);
        at.y -= 0.5 * gravity * t * t;
        turn.setFromAxisAngle(axis, TUMBLE * t);
        scale.set(1, 0.3, 0.7).multiplyScalar(size * reach);
        mesh.setMatrixAt(n, matrix.compose(at, turn, scale));
      }
      mesh.instanceMatrix.needsUpdate = true;
    },
    dispose() {
      for (const each of [shape, metal, mesh]) each.dispose();
    },
  };
}

/** Outward and upward in all directions, small pieces faster; the same at every crash. */
function pieceOf(n: number): Piece {
  const noise = (which: number) => cellNoise(n, which, 91);
  const around = 2 * Math.PI * noise(1);
  const size = 0.006 + 0.035 * noise(3) ** 2;
  const speed = FASTEST * (0.25 + 0.75 * noise(4)) * (0.012 / (size + 0.006)) ** 0.5;
  const way = new Vector3(Math.cos(around), 0.25 + 0.9 * noise(2), Math.sin(around));
  return {
    velocity: way.normalize().multiplyScalar(Math.min(speed, FASTEST)),
    axis: new Vector3(noise(5) - 0.5, noise(6) - 0.5, noise(7) - 0.5).normalize(),
    size,
    lands: 0,
  };
}

/** s until a piece reaches the ground, within STEP: the error is hidden by the size of a small piece. */
function landingOf(
  { velocity }: Piece,
  gravity: number,
  origin: Float64Array,
  groundY: (x: number, z: number) => number,
): number {
  for (let t = STEP; t < LONGEST_FLIGHT; t += STEP) {
    const y = origin[1]! + velocity.y * t - 0.5 * gravity * t * t;
    if (y < groundY(origin[0]! + velocity.x * t, origin[2]! + velocity.z * t)) return t;
  }
  return LONGEST_FLIGHT;
}
