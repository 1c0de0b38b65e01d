import { AdditiveBlending, BufferAttribute, BufferGeometry, Points, ShaderMaterial } from 'three';
import { cellNoise } from '../ground/noise';

export interface Stars {
  readonly points: Points<BufferGeometry, ShaderMaterial>;
  dispose(): void;
}

/** Each star is a soft disc over several pixels: as the camera turns, it moves smoothly instead of jumping from pixel to pixel. */
const VERTEX = /* glsl */ `
attribute vec4 light;
varying vec3 vColour;
void main() {
  vColour = light.rgb;
  gl_PointSize = light.a;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const FRAGMENT = /* glsl */ `
varying vec3 vColour;
void main() {
  vec2 off = gl_PointCoord * 2.0 - 1.0;
  float spread = exp(-4.0 * dot(off, off)) - 0.018;
  if (spread <= 0.0) discard;
  gl_FragColor = vec4(vColour * spread, 1.0);
}`;

const COUNT = 2400;
/** m: anything between the near and the far plane. */
const DISTANCE = 5000;
/** Diameters on the screen, device pixels. */
const FAINT = 3.2;
const BRIGHT = 5.2;
/** The denser band is inclined by half a radian. */
const COS_BAND = 0.88;
const SIN_BAND = 0.48;

/** Not a catalogue: directions and brightness come from a hash, fixed in ICRF, denser along one great circle. */
export function createStars(): Stars {
  const positions = new Float32Array(COUNT * 3);
  const light = new Float32Array(COUNT * 4);
  for (let n = 0; n < COUNT; n++) {
    positions.set(directionOf(n), n * 3);
    light.set(lightOf(n), n * 4);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('light', new BufferAttribute(light, 4));
  // Additive, yet not transparent: drawn before the ground, which covers them.
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    blending: AdditiveBlending,
    depthTest: false,
    depthWrite: false,
  });
  const points = new Points(geometry, material);
  points.renderOrder = -1;
  points.frustumCulled = false;
  return {
    points,
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}

function directionOf(n: number): [number, number, number] {
  const around = cellNoise(n, 0, 5) * 2 * Math.PI;
  const spread = cellNoise(n, 2, 5) * 2 - 1;
  const z = cellNoise(n, 1, 5) < 0.45 ? spread ** 3 * 0.35 : spread;
  const across = Math.sqrt(1 - z * z);
  const x = across * Math.cos(around);
  const y = across * Math.sin(around);
  return [x * DISTANCE, (y * COS_BAND - z * SIN_BAND) * DISTANCE, (y * SIN_BAND + z * COS_BAND) * DISTANCE];
}

/** Linear RGB and diameter. */
function lightOf(n: number): [number, number, number, number] {
  const bright = 0.16 + 1.1 * cellNoise(n, 3, 5) ** 7;
  const warm = cellNoise(n, 4, 5);
  const size = FAINT + (BRIGHT - FAINT) * Math.min(bright, 1);
  return [bright * (0.8 + 0.3 * warm), bright * 0.92, bright * (1.12 - 0.3 * warm), size];
}
