import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  ShaderMaterial,
  Vector3,
} from 'three';
import { uploadFirst } from '../uploads';

/**
 * Soft shadows of the ships outside the shadow map, which covers the watched ship only. Each lies on the ground's slope where the sun
 * casts it, and a low sun stretches it along the light.
 */
export interface BlobShadows {
  readonly mesh: InstancedMesh;
  clear(): void;
  /** `ship` and `ground` local, m: the ship's place and a point of the ground down-sun of it; `normal` of the ground there. */
  put(ship: ArrayLike<number>, ground: Vector3, normal: Vector3, eye: Float64Array, radius: number): void;
  finish(): void;
  /** Towards the sun, local, unit. */
  paint(sunDirection: Vector3): void;
  dispose(): void;
}

const MAX_SHADOWS = 256;
/** Opacity under a ship at the ground, and how fast it fades with height, per m along the light. */
const DARKNESS = 0.62;
const FADES = 1 / 120;
/** Longest shadow under a low sun, in widths. */
const MAX_STRETCH = 8;
/** m above the ground. */
const LIFT = 0.06;

const VERTEX = /* glsl */ `
varying vec2 vAcross;
varying float vDark;
attribute float darkness;
void main() {
  vAcross = position.xz;
  vDark = darkness;
  gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
}`;
const FRAGMENT = /* glsl */ `
varying vec2 vAcross;
varying float vDark;
void main() {
  float off = length(vAcross);
  gl_FragColor = vec4(0.0, 0.0, 0.0, vDark * smoothstep(1.0, 0.72, off));
}`;

/** A square on the ground, faded to a disc by its shader. */
function createSquare(): BufferGeometry {
  const geometry = new BufferGeometry();
  const corners = Float32Array.of(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1);
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  return geometry.setIndex([0, 1, 2, 0, 2, 3]);
}

function createMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -8,
  });
}

export function createBlobShadows(): BlobShadows {
  const geometry = createSquare();
  const material = createMaterial();
  const mesh = new InstancedMesh(geometry, material, MAX_SHADOWS);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  const darkness = new InstancedBufferAttribute(new Float32Array(MAX_SHADOWS), 1);
  darkness.setUsage(DynamicDrawUsage);
  geometry.setAttribute('darkness', darkness);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  mesh.renderOrder = 1;
  const sun = new Vector3(0, 1, 0);
  const along = new Vector3();
  const across = new Vector3();
  const matrix = new Matrix4();
  let count = 0;

  return {
    mesh,
    clear() {
      count = 0;
    },
    put(ship, ground, normal, eye, radius) {
      if (count === MAX_SHADOWS) return;
      const way = Math.hypot(ship[0]! - ground.x, ship[1]! - ground.y, ship[2]! - ground.z);
      const facing = Math.max(sun.dot(normal), 0);
      if (facing === 0) return;
      across.crossVectors(sun, normal).normalize();
      along.crossVectors(across, normal);
      along.multiplyScalar(radius * Math.min(1 / facing, MAX_STRETCH));
      across.multiplyScalar(radius);
      matrix.makeBasis(along, normal, across);
      matrix.setPosition(
        ground.x - eye[0]! + normal.x * LIFT,
        ground.y - eye[1]! + normal.y * LIFT,
        ground.z - eye[2]! + normal.z * LIFT,
      );
      mesh.setMatrixAt(count, matrix);
      darkness.setX(count, DARKNESS * Math.exp(-way * FADES));
      count += 1;
    },
    finish() {
      mesh.count = count;
      mesh.visible = count > 0;
      uploadFirst(mesh.instanceMatrix, count);
      uploadFirst(darkness, count);
    },
    paint(sunDirection) {
      sun.copy(sunDirection);
    },
    dispose() {
      geometry.dispose();
      material.dispose();
      mesh.dispose();
    },
  };
}
