import {
  BackSide,
  BufferAttribute,
  BufferGeometry,
  Color,
  type DataTexture,
  Group,
  Mesh,
  Points,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import type { BodyLook } from './bodyLook';
import { cellNoise } from '../ground/noise';

const VERTEX = /* glsl */ `
varying vec3 vDirection;
void main() {
  vDirection = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = /* glsl */ `
#include <common>
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 glow;
uniform vec3 sunDirection;
uniform vec3 sunColour;
uniform float air;
uniform float dip;
uniform float clouds;
uniform vec4 neighbour;
uniform vec3 day;
uniform vec3 spots;
uniform sampler2D detail;
varying vec3 vDirection;
void main() {
  vec3 way = normalize(vDirection);
  float toSun = dot(way, sunDirection);
  float height = max(way.y + dip, 0.0);
  vec3 colour = mix(horizon, zenith, pow(height, 0.42)) * air;
  colour += glow * air * (0.35 * pow(max(toSun, 0.0), 8.0) + 0.5 * pow(max(toSun, 0.0), 90.0));
  if (clouds > 0.0 && way.y > 0.0) {
    // Streaks on a sheet overhead; at the horizon the air hides them.
    vec2 sheet = way.xz / (way.y + 0.09);
    float cover = texture2D(detail, sheet * vec2(0.018, 0.05)).b * 0.6 + texture2D(detail, sheet.yx * 0.11).b * 0.4;
    float cloud = smoothstep(0.38, 0.66, cover) * smoothstep(0.0, 0.16, way.y) * clouds * air;
    colour = mix(colour, sunColour * (0.82 + 0.5 * pow(max(toSun, 0.0), 6.0)), cloud);
  }
  // The disc is drawn wider than the sun's half degree: what a lens makes of it.
  float disc = smoothstep(0.99988, 0.99995, toSun);
  colour += sunColour * (6.0 * disc + 0.5 * pow(max(toSun, 0.0), 2600.0) + 0.06 * pow(max(toSun, 0.0), 260.0));

  vec3 across = way - neighbour.xyz * dot(way, neighbour.xyz);
  float off = length(across) / neighbour.w;
  if (off < 1.0 && dot(way, neighbour.xyz) > 0.0) {
    vec3 normal = across / neighbour.w - neighbour.xyz * sqrt(1.0 - off * off);
    float light = max(dot(normal, sunDirection), 0.0);
    vec2 place = vec2(atan(normal.x, normal.z) * 0.16, normal.y * 0.33);
    float cover = smoothstep(0.4, 0.62, texture2D(detail, place).b * 0.7 + texture2D(detail, place * 3.0).b * 0.35);
    colour = mix(day, spots, cover) * light * 1.4 + 0.004;
    colour += glow * 0.12 * pow(off, 6.0) * light;
  }
  gl_FragColor = vec4(colour, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

export interface Sky {
  readonly group: Group;
  paint(look: BodyLook, sunDirection: Vector3): void;
  /** `height` m of the eye over the ground, `radius` of the body m, `turn` ICRF -> local for the stars. */
  look(height: number, radius: number, turn: Float64Array): void;
  dispose(): void;
}

/** Radius of the dome and of the stars' sphere, m: anything between the near and the far plane. */
const DOME = 5000;

export function createSky(detail: DataTexture): Sky {
  const dome = new Mesh(
    new SphereGeometry(DOME, 24, 16),
    new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: BackSide,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        zenith: { value: new Color() },
        horizon: { value: new Color() },
        glow: { value: new Color() },
        sunDirection: { value: new Vector3() },
        sunColour: { value: new Color() },
        air: { value: 0 },
        dip: { value: 0 },
        clouds: { value: 0 },
        neighbour: { value: [0, -1, 0, 1e-3] },
        day: { value: new Color() },
        spots: { value: new Color() },
        detail: { value: detail },
      },
    }),
  );
  dome.renderOrder = -2;
  dome.frustumCulled = false;
  const stars = createStars();
  const group = new Group();
  group.add(dome, stars);
  let air: BodyLook['air'] = null;

  return {
    group,
    paint(look, sunDirection) {
      air = look.air;
      stars.visible = air === null;
      const { uniforms } = dome.material;
      const colour = (name: string, [r, g, b]: readonly [number, number, number]) =>
        (uniforms[name]!.value as Color).setRGB(r, g, b);
      colour('zenith', air?.zenith ?? [0, 0, 0]);
      colour('horizon', air?.horizon ?? [0, 0, 0]);
      uniforms['clouds']!.value = air?.clouds ?? 0;
      colour('glow', air?.glow ?? [0, 0, 0]);
      colour('sunColour', look.sunColour);
      (uniforms['sunDirection']!.value as Vector3).copy(sunDirection);
      const other = look.neighbour;
      const placed = uniforms['neighbour']!.value as number[];
      placed.splice(0, 4, 0, -1, 0, 1e-3);
      if (other === null) return;
      const [azimuth, elevation] = [(other.azimuth * Math.PI) / 180, (other.elevation * Math.PI) / 180];
      placed[0] = Math.cos(elevation) * Math.cos(azimuth);
      placed[1] = Math.sin(elevation);
      placed[2] = Math.cos(elevation) * Math.sin(azimuth);
      placed[3] = Math.sin((other.radius * Math.PI) / 180);
      colour('day', other.day);
      colour('spots', other.spots);
    },
    look(height, radius, turn) {
      const { uniforms } = dome.material;
      // Above the air the sky goes black; the horizon sinks with height.
      uniforms['air']!.value = air === null ? 0 : Math.exp(-Math.max(height, 0) / (3 * air.scaleHeight));
      uniforms['dip']!.value = Math.sqrt(Math.max(2 * height, 0) / radius);
      stars.quaternion.set(turn[0]!, turn[1]!, turn[2]!, turn[3]!);
    },
    dispose() {
      dome.geometry.dispose();
      dome.material.dispose();
      stars.geometry.dispose();
      stars.material.dispose();
    },
  };
}

const STAR_VERTEX = /* glsl */ `
attribute vec4 light;
varying vec3 vColour;
void main() {
  vColour = light.rgb;
  gl_PointSize = light.a;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const STAR_FRAGMENT = /* glsl */ `
varying vec3 vColour;
void main() { gl_FragColor = vec4(vColour, 1.0); }`;

/** Not a catalogue: directions and brightness from a hash, fixed in ICRF, denser along one great circle. */
function createStars(): Points<BufferGeometry, ShaderMaterial> {
  const count = 1800;
  const positions = new Float32Array(count * 3);
  const light = new Float32Array(count * 4);
  for (let n = 0; n < count; n++) {
    const around = cellNoise(n, 0, 5) * 2 * Math.PI;
    const inBand = cellNoise(n, 1, 5) < 0.45;
    const spread = cellNoise(n, 2, 5) * 2 - 1;
    const z = inBand ? spread ** 3 * 0.35 : spread;
    const across = Math.sqrt(1 - z * z);
    // The band leans by half a radian.
    const [x, y] = [across * Math.cos(around), across * Math.sin(around)];
    positions.set([x * DOME, (y * 0.88 - z * 0.48) * DOME, (y * 0.48 + z * 0.88) * DOME], n * 3);
    const bright = 0.12 + 0.9 * cellNoise(n, 3, 5) ** 7;
    const warm = cellNoise(n, 4, 5);
    light.set(
      [bright * (0.8 + 0.3 * warm), bright * 0.92, bright * (1.12 - 0.3 * warm), bright > 0.5 ? 2.4 : 1.5],
      n * 4,
    );
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('light', new BufferAttribute(light, 4));
  const material = new ShaderMaterial({
    vertexShader: STAR_VERTEX,
    fragmentShader: STAR_FRAGMENT,
    depthTest: false,
    depthWrite: false,
  });
  const stars = new Points(geometry, material);
  stars.renderOrder = -1;
  stars.frustumCulled = false;
  return stars;
}
