import {
  AdditiveBlending,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Quaternion,
  SphereGeometry,
  TetrahedronGeometry,
  Vector3,
} from 'three';
import { cellNoise } from '../ground/noise';

/** A crash as one sees it: a flash, and pieces that fly, fall by the body's own gravity and stay lying. */
export interface Crash {
  readonly group: Group;
  /** Begins at a local place, m; `size` of the ship, m. `groundY(x, z)`: local height of the ground, m. */
  begin(place: ArrayLike<number>, size: number, groundY: (x: number, z: number) => number): void;
  /** `time` s, monotone; `gravity` m/s²; `eye` local, m. */
  update(time: number, gravity: number, eye: Float64Array): void;
  clear(): void;
  dispose(): void;
}

const PIECES = 64;
/** s: the flash is over; and how wide it grows, in sizes of the ship. */
const FLASH = 0.5;
const FLASH_SIZE = 2.6;
/** m/s: the fastest piece. */
const FASTEST = 22;

interface Piece {
  readonly velocity: Vector3;
  readonly axis: Vector3;
  readonly size: number;
  /** s after the crash at which it lies. */
  lands: number;
}

export function createCrash(): Crash {
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
  const glow = new MeshBasicMaterial({
    color: 0xffe2b0,
    transparent: true,
    blending: AdditiveBlending,
    depthWrite: false,
  });
  const flash = new Mesh(new SphereGeometry(1, 24, 16), glow);
  flash.renderOrder = 4;
  const group = new Group();
  group.add(mesh, flash);
  group.visible = false;
  const pieces = Array.from({ length: PIECES }, (_, n) => pieceOf(n));
  const origin = new Float64Array(3);
  const at = new Vector3();
  const turn = new Quaternion();
  const scale = new Vector3();
  const matrix = new Matrix4();
  let began = NaN;
  let waiting = false;
  let reach = 1;
  let groundAt: (x: number, z: number) => number = () => 0;

  const begin = (time: number, gravity: number) => {
    began = time;
    waiting = false;
    for (const piece of pieces) piece.lands = landingOf(piece, gravity, origin, groundAt);
  };
  const placePieces = (age: number, gravity: number) => {
    for (const [n, piece] of pieces.entries()) {
      const t = Math.min(age, piece.lands);
      at.copy(piece.velocity).multiplyScalar(t);
      at.y -= 0.5 * gravity * t * t;
      turn.setFromAxisAngle(piece.axis, 7 * t);
      mesh.setMatrixAt(
        n,
        matrix.compose(at, turn, scale.set(1, 0.3, 0.7).multiplyScalar(piece.size * reach)),
      );
    }
    mesh.instanceMatrix.needsUpdate = true;
  };

  return {
    group,
    begin(place, size, groundY) {
      origin.set([place[0]!, place[1]!, place[2]!]);
      reach = size;
      groundAt = groundY;
      waiting = true;
    },
    update(time, gravity, eye) {
      if (waiting) begin(time, gravity);
      group.visible = !Number.isNaN(began);
      if (!group.visible) return;
      const age = time - began;
      group.position.set(origin[0]! - eye[0]!, origin[1]! - eye[1]!, origin[2]! - eye[2]!);
      placePieces(age, gravity);
      const share = Math.min(age / FLASH, 1);
      flash.visible = share < 1;
      flash.scale.setScalar(Math.max(reach * FLASH_SIZE * Math.sqrt(share), 0.01));
      glow.opacity = (1 - share) ** 2;
    },
    clear() {
      began = NaN;
      waiting = false;
      group.visible = false;
    },
    dispose() {
      for (const each of [shape, metal, mesh, glow, flash.geometry]) each.dispose();
    },
  };
}

/** Out and up in all directions, small pieces faster: the same at every crash. */
function pieceOf(n: number): Piece {
  const around = 2 * Math.PI * cellNoise(n, 1, 91);
  const up = 0.25 + 0.9 * cellNoise(n, 2, 91);
  const size = 0.006 + 0.035 * cellNoise(n, 3, 91) ** 2;
  const speed = FASTEST * (0.25 + 0.75 * cellNoise(n, 4, 91)) * (0.012 / (size + 0.006)) ** 0.5;
  return {
    velocity: new Vector3(Math.cos(around), up, Math.sin(around))
      .normalize()
      .multiplyScalar(Math.min(speed, FASTEST)),
    axis: new Vector3(
      cellNoise(n, 5, 91) - 0.5,
      cellNoise(n, 6, 91) - 0.5,
      cellNoise(n, 7, 91) - 0.5,
    ).normalize(),
    size,
    lands: 0,
  };
}

/** s until a piece meets the ground, found in quarter seconds: it may sink or hang by what a small piece hides. */
function landingOf(
  { velocity }: Piece,
  gravity: number,
  origin: Float64Array,
  groundY: (x: number, z: number) => number,
): number {
  const longest = 60;
  for (let t = 0.25; t < longest; t += 0.25) {
    const y = origin[1]! + velocity.y * t - 0.5 * gravity * t * t;
    if (y < groundY(origin[0]! + velocity.x * t, origin[2]! + velocity.z * t)) return t;
  }
  return longest;
}
