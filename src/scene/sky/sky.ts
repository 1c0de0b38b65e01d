import {
  BackSide,
  Color,
  type DataTexture,
  Group,
  Mesh,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import type { BodyLook } from './bodyLook';
import { createStars } from './stars';
import type { SceneLook } from './underSun';

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
uniform vec3 cloudColour;
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
    colour = mix(colour, cloudColour * (0.82 + 0.5 * pow(max(toSun, 0.0), 6.0)), cloud);
  }
  // The disc is drawn wider than the sun's half degree, as a lens shows it.
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
  paint(look: SceneLook): void;
  /** `height` m of the eye over the ground, `radius` of the body m, `turn` ICRF -> local for the stars. */
  look(height: number, radius: number, turn: Float64Array): void;
  dispose(): void;
}

/** Radius of the dome, m: anything between the near and the far plane. */
const DOME = 5000;
/** Clouds by night, of their brightness by day. */
const NIGHT_CLOUDS = 0.025;

export function createSky(detail: DataTexture): Sky {
  const dome = createDome(detail);
  const stars = createStars();
  const group = new Group();
  group.add(dome, stars.points);
  let air: BodyLook['air'] = null;

  return {
    group,
    paint(look) {
      air = look.air;
      stars.points.visible = air === null || look.isNight;
      paintDome(dome.material, look);
    },
    look(height, radius, turn) {
      const { uniforms } = dome.material;
      // Above the air the sky goes black; the horizon sinks with height.
      uniforms['air']!.value = air === null ? 0 : Math.exp(-Math.max(height, 0) / (3 * air.scaleHeight));
      uniforms['dip']!.value = Math.sqrt(Math.max(2 * height, 0) / radius);
      stars.points.quaternion.set(turn[0]!, turn[1]!, turn[2]!, turn[3]!);
    },
    dispose() {
      dome.geometry.dispose();
      dome.material.dispose();
      stars.dispose();
    },
  };
}

function createDome(detail: DataTexture): Mesh<SphereGeometry, ShaderMaterial> {
  const material = new ShaderMaterial({
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
      cloudColour: { value: new Color() },
      air: { value: 0 },
      dip: { value: 0 },
      clouds: { value: 0 },
      neighbour: { value: [0, -1, 0, 1e-3] },
      day: { value: new Color() },
      spots: { value: new Color() },
      detail: { value: detail },
    },
  });
  const dome = new Mesh(new SphereGeometry(DOME, 24, 16), material);
  dome.renderOrder = -2;
  dome.frustumCulled = false;
  return dome;
}

const BLACK = [0, 0, 0] as const;
const RADIANS = Math.PI / 180;

function paintDome({ uniforms }: ShaderMaterial, look: SceneLook): void {
  const { air, neighbour } = look;
  const colour = (name: string, [r, g, b]: readonly [number, number, number], by = 1) =>
    (uniforms[name]!.value as Color).setRGB(r * by, g * by, b * by);
  colour('zenith', air?.zenith ?? BLACK);
  colour('horizon', air?.horizon ?? BLACK);
  colour('glow', air?.glow ?? BLACK);
  colour('sunColour', look.sunColour);
  colour('cloudColour', look.sunColour, look.isNight ? NIGHT_CLOUDS : 1);
  uniforms['clouds']!.value = air?.clouds ?? 0;
  const { azimuth, elevation } = look.trueSun;
  (uniforms['sunDirection']!.value as Vector3).set(...directionOf(azimuth, elevation));
  const placed = uniforms['neighbour']!.value as number[];
  placed.splice(0, 4, 0, -1, 0, 1e-3);
  if (neighbour === null) return;
  const towards = directionOf(neighbour.azimuth, neighbour.elevation);
  placed.splice(0, 4, ...towards, Math.sin(neighbour.radius * RADIANS));
  colour('day', neighbour.day);
  colour('spots', neighbour.spots);
}

/** Local, unit; degrees, from the x axis towards z and above the horizon. */
function directionOf(azimuth: number, elevation: number): [number, number, number] {
  const level = Math.cos(elevation * RADIANS);
  return [
    level * Math.cos(azimuth * RADIANS),
    Math.sin(elevation * RADIANS),
    level * Math.sin(azimuth * RADIANS),
  ];
}
