import { BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Points, ShaderMaterial } from 'three';
import type { BodyLook } from './bodyLook';
import { cellNoise } from './noise';

const MOST = 900;

const VERTEX = /* glsl */ `
attribute vec3 velocity;
attribute vec4 span;
uniform float time;
uniform float gravity;
uniform float drag;
uniform float pixelsPerMetre;
varying float vAlpha;
varying float vShade;
void main() {
  float age = time - span.x;
  float share = age / span.y;
  float run = drag > 0.0 ? (1.0 - exp(-drag * age)) / drag : age;
  vec3 place = position + velocity * run;
  place.y += drag > 0.0 ? -gravity * 0.02 * age : -0.5 * gravity * age * age;
  vec4 mvPosition = modelViewMatrix * vec4(place, 1.0);
  bool alive = share >= 0.0 && share < 1.0 && place.y > position.y - 0.6;
  float size = span.z * (0.5 + share * (drag > 0.0 ? 3.2 : 1.7));
  vAlpha = alive ? span.w * (1.0 - share) * (1.0 - share) * smoothstep(0.0, 0.06, share) : 0.0;
  vShade = 0.8 + 0.2 * share;
  gl_PointSize = alive ? clamp(size * pixelsPerMetre / -mvPosition.z, 1.0, 90.0) : 0.0;
  gl_Position = alive ? projectionMatrix * mvPosition : vec4(2.0, 2.0, 2.0, 1.0);
}`;
const FRAGMENT = /* glsl */ `
uniform vec3 colour;
varying float vAlpha;
varying float vShade;
void main() {
  vec2 off = gl_PointCoord * 2.0 - 1.0;
  float round = 1.0 - dot(off, off);
  if (round <= 0.0) discard;
  gl_FragColor = vec4(colour * vShade, vAlpha * round * round);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

/** Grains thrown once and left to gravity (and to the air where there is some): the way is worked out on the GPU. */
export interface Dust {
  readonly points: Points<BufferGeometry, ShaderMaterial>;
  /** A grain: local place and velocity relative to `origin`, m and m/s; seconds it lives, size m, opacity. */
  throwGrain(place: ArrayLike<number>, velocity: ArrayLike<number>, look: GrainLook): void;
  paint(look: BodyLook): void;
  update(time: number, gravity: number, pixelsPerMetre: number): void;
  clear(): void;
  dispose(): void;
}

export interface GrainLook {
  readonly seconds: number;
  readonly size: number;
  readonly opacity: number;
}

export function createDust(): Dust {
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
    paint(look) {
      // Grains that hang in the sun are lit from all sides: brighter than the ground they came from.
      const light = look.sunStrength * (look.air === null ? 1.25 : 0.95);
      const [r, g, b] = look.dust;
      (material.uniforms['colour']!.value as Color).setRGB(r * light, g * light, b * light);
      material.uniforms['drag']!.value = look.air?.drag ?? 0;
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
