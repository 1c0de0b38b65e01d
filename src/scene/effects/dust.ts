import {
  BufferAttribute,
  BufferGeometry,
  Color,
  type DataTexture,
  DynamicDrawUsage,
  Points,
  ShaderMaterial,
  Vector3,
} from 'three';
import type { BodyLook } from '../sky/bodyLook';
import { cellNoise } from '../ground/noise';

const MOST = 1500;

const VERTEX = /* glsl */ `
attribute vec3 velocity;
attribute vec4 span;
uniform float time;
uniform float gravity;
uniform float drag;
uniform float pixelsPerMetre;
varying float vAlpha;
varying vec2 vPatch;
void main() {
  float age = time - span.x;
  float share = age / span.y;
  float run = drag > 0.0 ? (1.0 - exp(-drag * age)) / drag : age;
  vec3 place = position + velocity * run;
  place.y += drag > 0.0 ? -gravity * 0.02 * age : -0.5 * gravity * age * age;
  vec4 mvPosition = modelViewMatrix * vec4(place, 1.0);
  bool alive = share >= 0.0 && share < 1.0 && place.y > position.y - 0.6;
  float size = span.z * (0.5 + share * (drag > 0.0 ? 3.6 : 2.2));
  vAlpha = alive ? span.w * (1.0 - share) * (1.0 - share) * smoothstep(0.0, 0.06, share) : 0.0;
  vPatch = span.yz * 7.0;
  gl_PointSize = alive ? clamp(size * pixelsPerMetre / -mvPosition.z, 1.0, 160.0) : 0.0;
  gl_Position = alive ? projectionMatrix * mvPosition : vec4(2.0, 2.0, 2.0, 1.0);
}`;
const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform vec3 sunDirection;
uniform sampler2D detail;
uniform float grit;
varying float vAlpha;
varying vec2 vPatch;
void main() {
  vec2 off = gl_PointCoord * 2.0 - 1.0;
  float round = 1.0 - dot(off, off);
  if (round <= 0.0) discard;
  // A puff and no disc: ragged by the ground's own texture, lit from the sun's side of the picture.
  // Of its blurred levels: on a puff as large as the picture the finest grain would show as squares.
  float lump = texture2D(detail, vPatch + gl_PointCoord * grit, 3.0).b;
  float thick = round * smoothstep(0.2, 0.75, lump);
  vec3 toSun = (viewMatrix * vec4(sunDirection, 0.0)).xyz;
  float lit = 0.75 + 0.45 * dot(vec3(off.x, -off.y, round), toSun) * round;
  gl_FragColor = vec4(colour * lit, min(vAlpha * thick * 1.6, 1.0));
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

/** Grains thrown once and left to gravity (and to the air where there is some): the way is worked out on the GPU. */
export interface Dust {
  readonly points: Points<BufferGeometry, ShaderMaterial>;
  /** A grain: local place and velocity relative to `origin`, m and m/s; seconds it lives, size m, opacity. */
  throwGrain(place: ArrayLike<number>, velocity: ArrayLike<number>, look: GrainLook): void;
  paint(look: BodyLook, sunDirection: Vector3): void;
  update(time: number, gravity: number, pixelsPerMetre: number): void;
  clear(): void;
  dispose(): void;
}

export interface GrainLook {
  readonly seconds: number;
  readonly size: number;
  readonly opacity: number;
}

export function createDust(detail: DataTexture): Dust {
  const geometry = new BufferGeometry();
  const dynamic = (size: number) =>
    new BufferAttribute(new Float32Array(MOST * size), size).setUsage(DynamicDrawUsage);
  const places = dynamic(3);
  const velocities = dynamic(3);
  const spans = dynamic(4);
  geometry.setAttribute('position', places);
  geometry.setAttribute('velocity', velocities);
  geometry.setAttribute('span', spans);
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
    uniforms: {
      time: { value: 0 },
      gravity: { value: 1.6 },
      drag: { value: 0 },
      pixelsPerMetre: { value: 800 },
      colour: { value: new Color() },
      sunDirection: { value: new Vector3() },
      detail: { value: detail },
      grit: { value: 0 },
    },
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  points.renderOrder = 2;
  let next = 0;
  let time = 0;
  let thrown = 0;
  let latest = -Infinity;

  const clear = () => {
    (spans.array as Float32Array).fill(0);
    spans.needsUpdate = true;
    latest = -Infinity;
  };
  return {
    points,
    throwGrain(place, velocity, { seconds, size, opacity }) {
      places.setXYZ(next, place[0]!, place[1]!, place[2]!);
      velocities.setXYZ(next, velocity[0]!, velocity[1]!, velocity[2]!);
      const vary = 0.6 + 0.8 * cellNoise(next, thrown++ & 0xffff, 77);
      spans.setXYZW(next, time, seconds * vary, size * vary, opacity);
      places.needsUpdate = true;
      velocities.needsUpdate = true;
      spans.needsUpdate = true;
      next = (next + 1) % MOST;
      latest = Math.max(latest, time + seconds * vary);
    },
    paint(look, sunDirection) {
      // Grains that hang in the sun are lit from all sides: brighter than the ground they came from.
      const light = look.sunStrength * (look.air === null ? 1.1 : 1.05);
      const [r, g, b] = look.dust;
      (material.uniforms['colour']!.value as Color).setRGB(r * light, g * light, b * light);
      (material.uniforms['sunDirection']!.value as Vector3).copy(sunDirection);
      material.uniforms['drag']!.value = look.air?.drag ?? 0;
      // Billows in air; without it sheets of grains.
      material.uniforms['grit']!.value = look.air === null ? 0.4 : 0.16;
    },
    update(now, gravity, pixelsPerMetre) {
      time = now;
      material.uniforms['time']!.value = now;
      material.uniforms['gravity']!.value = gravity;
      material.uniforms['pixelsPerMetre']!.value = pixelsPerMetre;
      points.visible = now < latest;
    },
    clear,
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}
