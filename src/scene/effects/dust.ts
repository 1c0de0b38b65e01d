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
import type { FlameUniforms } from './flame';
import { cellNoise } from '../ground/noise';
import { uploadFirst, uploadItems } from '../uploads';

const MAX_GRAINS = 1500;

const VERTEX = /* glsl */ `
attribute vec3 velocity;
attribute vec4 span;
uniform float time;
uniform float gravity;
uniform float drag;
uniform float pixelsPerMetre;
uniform vec4 flame;
varying float vAlpha;
varying float vFlame;
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
  // A grain close to the eye would cover half the picture.
  vAlpha *= smoothstep(1.5, 14.0, -mvPosition.z);
  vPatch = span.yz * 7.0;
  // The eye is at the world's origin; the flame's position is relative to it.
  vec3 toFlame = flame.xyz - (modelMatrix * vec4(place, 1.0)).xyz;
  vFlame = max(flame.w, 0.0) / (dot(toFlame, toFlame) + 6.0);
  gl_PointSize = alive ? clamp(size * pixelsPerMetre / -mvPosition.z, 1.0, 160.0) : 0.0;
  gl_Position = alive ? projectionMatrix * mvPosition : vec4(2.0, 2.0, 2.0, 1.0);
}`;
const FRAGMENT = /* glsl */ `
uniform vec3 albedo;
uniform float sunlight;
uniform vec3 flameColour;
uniform vec3 sunDirection;
uniform sampler2D detail;
uniform float grit;
varying float vAlpha;
varying float vFlame;
varying vec2 vPatch;
void main() {
  vec2 off = gl_PointCoord * 2.0 - 1.0;
  float round = 1.0 - dot(off, off);
  if (round <= 0.0) discard;
  // A puff, not a disc: its edge follows the ground's texture, and it is lit from the sun's side of
  // the picture. From the texture's blurred levels: on a puff as large as the picture the finest grain would show as squares.
  float lump = texture2D(detail, vPatch + gl_PointCoord * grit, 3.0).b;
  float thick = round * round * smoothstep(0.2, 0.75, lump);
  vec3 toSun = (viewMatrix * vec4(sunDirection, 0.0)).xyz;
  float lit = 0.75 + 0.45 * dot(vec3(off.x, -off.y, round), toSun) * round;
  gl_FragColor = vec4(albedo * (sunlight * lit + flameColour * vFlame), min(vAlpha * thick * 1.6, 1.0));
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

/** Grains are emitted once, then moved by gravity and, in air, drag. The GPU computes their motion. */
export interface Dust {
  readonly points: Points<BufferGeometry, ShaderMaterial>;
  /** A grain: local place and velocity relative to `origin`, m and m/s; seconds it lives, size m, opacity. */
  throwGrain(place: ArrayLike<number>, velocity: ArrayLike<number>, look: GrainLook): void;
  paint(look: BodyLook, sunDirection: Vector3): void;
  update(time: number, gravity: number, pixelsPerMetre: number): void;
  /** Share of the sun that reaches the watched ship, and with it the dust around it, 0 … 1. */
  shade(share: number): void;
  clear(): void;
  dispose(): void;
}

export interface GrainLook {
  readonly seconds: number;
  readonly size: number;
  readonly opacity: number;
}

export function createDust(detail: DataTexture, flame: FlameUniforms): Dust {
  const grains = createGrains();
  const material = createMaterial(detail, flame);
  const { uniforms } = material;
  const points = new Points(grains.geometry, material);
  points.frustumCulled = false;
  points.renderOrder = 2;
  let time = 0;
  let latest = -Infinity;
  let sunlight = 0;

  return {
    points,
    throwGrain(place, velocity, look) {
      latest = Math.max(latest, time + grains.put(place, velocity, look, time));
    },
    paint(look, sunDirection) {
      // Grains that hang in the sun are lit from all sides: brighter than the ground they came from.
      sunlight = look.sunStrength * (look.air === null ? 1.1 : 1.05);
      const [r, g, b] = look.dust;
      (uniforms['albedo']!.value as Color).setRGB(r, g, b);
      (uniforms['sunDirection']!.value as Vector3).copy(sunDirection);
      uniforms['drag']!.value = look.air?.drag ?? 0;
      // Billows in air; without it sheets of grains.
      uniforms['grit']!.value = look.air === null ? 0.4 : 0.16;
    },
    shade(share) {
      // In a hill's shadow the sunlit ground around still lights them.
      uniforms['sunlight']!.value = sunlight * (0.12 + 0.88 * share);
    },
    update(now, gravity, pixelsPerMetre) {
      time = now;
      uniforms['time']!.value = now;
      uniforms['gravity']!.value = gravity;
      uniforms['pixelsPerMetre']!.value = pixelsPerMetre;
      points.visible = now < latest;
    },
    clear() {
      grains.clear();
      latest = -Infinity;
    },
    dispose() {
      grains.geometry.dispose();
      material.dispose();
    },
  };
}

function createMaterial(detail: DataTexture, flame: FlameUniforms): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
    uniforms: {
      time: { value: 0 },
      gravity: { value: 1.6 },
      drag: { value: 0 },
      pixelsPerMetre: { value: 800 },
      albedo: { value: new Color() },
      sunlight: { value: 1 },
      sunDirection: { value: new Vector3() },
      detail: { value: detail },
      grit: { value: 0 },
      ...flame,
    },
  });
}

/** A ring of grains: the newest replaces the oldest. */
function createGrains() {
  const geometry = new BufferGeometry();
  const dynamic = (name: string, size: number) => {
    const attribute = new BufferAttribute(new Float32Array(MAX_GRAINS * size), size).setUsage(
      DynamicDrawUsage,
    );
    geometry.setAttribute(name, attribute);
    return attribute;
  };
  const places = dynamic('position', 3);
  const velocities = dynamic('velocity', 3);
  const spans = dynamic('span', 4);
  let next = 0;
  let thrown = 0;
  return {
    geometry,
    /** Returns the grain's lifetime, s. */
    put(place: ArrayLike<number>, velocity: ArrayLike<number>, look: GrainLook, time: number): number {
      const vary = 0.6 + 0.8 * cellNoise(next, thrown++ & 0xffff, 77);
      const lives = look.seconds * vary;
      places.setXYZ(next, place[0]!, place[1]!, place[2]!);
      velocities.setXYZ(next, velocity[0]!, velocity[1]!, velocity[2]!);
      spans.setXYZW(next, time, lives, look.size * vary, look.opacity);
      for (const attribute of [places, velocities, spans]) uploadItems(attribute, next, 1);
      next = (next + 1) % MAX_GRAINS;
      return lives;
    },
    clear() {
      (spans.array as Float32Array).fill(0);
      uploadFirst(spans, MAX_GRAINS);
    },
  };
}
