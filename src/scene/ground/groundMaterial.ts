import { Color, type DataTexture, ShaderMaterial, UniformsLib, UniformsUtils, Vector3 } from 'three';
import type { FlameUniforms } from '../effects/flame';
import type { BodyLook } from '../sky/bodyLook';
import { MAX_LEVELS, VERTICES } from './levels';

/** A vertex is relative to its level's place (groundMesh.ts). */
const VERTEX = /* glsl */ `
#include <common>
#include <shadowmap_pars_vertex>
attribute float sunlit;
uniform vec4 eyeGrain;
uniform vec3 levelPlaces[${MAX_LEVELS}];
varying vec4 vPlane;
varying vec3 vNormal;
varying vec3 vPosition;
varying float vSunlit;
void main() {
  vec4 worldPosition = vec4(position + levelPlaces[gl_VertexID / ${VERTICES * VERTICES}], 1.0);
  vec4 mvPosition = viewMatrix * worldPosition;
  vec3 transformedNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * mvPosition;
  vPlane = worldPosition.xzxz + eyeGrain;
  vNormal = normal;
  vPosition = worldPosition.xyz;
  vSunlit = sunlit;
  #include <shadowmap_vertex>
}`;

/** The eye is at the world's origin: a fragment's position is also the way from the eye to it. */
const FRAGMENT = /* glsl */ `
#include <common>
#include <packing>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
uniform sampler2D detail;
uniform vec3 dust;
uniform vec3 stone;
uniform vec3 cover;
uniform float regolith;
uniform vec3 sunColour;
uniform vec3 sunDirection;
uniform vec3 fillColour;
uniform vec3 hazeColour;
uniform vec3 hazeGlow;
uniform float hazePerMetre;
uniform vec4 flame;
uniform vec3 flameColour;
varying vec4 vPlane;
varying vec3 vNormal;
varying vec3 vPosition;
varying float vSunlit;
void main() {
  float range = length(vPosition);
  vec3 toEye = -vPosition / range;
  vec4 fine = texture2D(detail, vPlane.xy * (1.0 / 4.0));
  vec4 mid = texture2D(detail, vPlane.yx * (1.0 / 32.0));
  vec4 wide = texture2D(detail, vPlane.zw * (1.0 / 512.0));
  vec4 vast = texture2D(detail, vPlane.wz * (1.0 / 4096.0));
  vec2 slope = (fine.rg - 0.5) * 0.9 + (mid.gr - 0.5) * 0.7 + (wide.rg - 0.5) * 0.4 + (vast.gr - 0.5) * 0.2;
  vec3 normal = normalize(vNormal - vec3(slope.x, 0.0, slope.y));
  float stony = clamp(fine.a * 0.9 + mid.a * 0.5, 0.0, 1.0);
  vec3 albedo = mix(dust, cover, smoothstep(0.42, 0.58, 0.5 * wide.b + 0.5 * vast.b));
  albedo = mix(albedo, stone, stony * 0.7);
  albedo *= 0.62 + 0.28 * fine.b + 0.36 * mid.b * wide.b + 0.34 * vast.b;
  albedo = mix(albedo, stone * 0.9, smoothstep(0.75, 0.45, vNormal.y) * 0.8);

  vec3 toFlame = flame.xyz - vPosition;
  float flameRange = dot(toFlame, toFlame);
  // Below 0: a wreck's scorched ground, of that radius in m.
  float scorched = flame.w < 0.0 ? smoothstep(1.0, 0.2, sqrt(flameRange) / -flame.w + 0.7 * (mid.b - 0.5)) : 0.0;
  albedo *= 1.0 - 0.82 * scorched;

  // The terrain alone decides where it is night. Grain is lit relative to it, with a soft minimum: under a low sun every other grain
  // is turned away, and cut off at zero these run together into black blotches.
  float facing = max(dot(normalize(vNormal), sunDirection), 0.0);
  float relief = dot(normal, sunDirection) / max(facing, 0.06);
  float toSun = facing * min(0.5 * (relief + sqrt(relief * relief + 0.3)), 2.4);
  float toView = max(dot(normal, toEye), 0.0);
  float lambert = toSun;
  float backscatter = toSun / (toSun + toView + 0.2) * (0.8 + 0.5 * pow(max(dot(toEye, sunDirection), 0.0), 6.0));
  float lit = mix(lambert, backscatter, regolith);
  lit *= smoothstep(-0.25, 0.25, vSunlit) * getShadowMask();
  // Light from around: most from above, and from where the sun shines on other ground.
  float open = 0.55 + 0.3 * normal.y - 0.5 * normal.x;
  vec3 colour = albedo * (sunColour * lit + fillColour * open);

  colour += albedo * flameColour * (max(flame.w, 0.0) * max(dot(normal, toFlame), 0.0) / (sqrt(flameRange) * (flameRange + 4.0)));

  float haze = 1.0 - exp(-range * hazePerMetre);
  float towardsSun = pow(max(dot(-toEye, sunDirection), 0.0), 8.0);
  colour = mix(colour, hazeColour + hazeGlow * towardsSun, haze);
  gl_FragColor = vec4(colour, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

/** Periods of the grain, m: of the two finer textures together, and of all. */
const FINE_PERIOD = 32;
const GRAIN_PERIOD = 4096;

/** Sets where the eye (local, m) is over the grain, as a remainder, so that floats hold it exactly. */
export function placeGrain(material: ShaderMaterial, eye: Float64Array): void {
  const grain = material.uniforms['eyeGrain']!.value as number[];
  grain[0] = eye[0]! % FINE_PERIOD;
  grain[1] = eye[2]! % FINE_PERIOD;
  grain[2] = eye[0]! % GRAIN_PERIOD;
  grain[3] = eye[2]! % GRAIN_PERIOD;
}

export function createGroundMaterial(detail: DataTexture, flame: FlameUniforms): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    lights: true,
    uniforms: {
      ...UniformsUtils.clone(UniformsLib.lights),
      detail: { value: detail },
      eyeGrain: { value: [0, 0, 0, 0] },
      dust: { value: new Color() },
      stone: { value: new Color() },
      cover: { value: new Color() },
      regolith: { value: 0 },
      sunColour: { value: new Color() },
      sunDirection: { value: new Vector3() },
      fillColour: { value: new Color() },
      hazeColour: { value: new Color() },
      hazeGlow: { value: new Color() },
      hazePerMetre: { value: 0 },
      ...flame,
    },
  });
}

export function paintGround(material: ShaderMaterial, look: BodyLook, sunDirection: Vector3): void {
  const { uniforms } = material;
  const colour = (name: string, [r, g, b]: readonly [number, number, number], scale = 1) =>
    (uniforms[name]!.value as Color).setRGB(r * scale, g * scale, b * scale);
  colour('dust', look.dust);
  colour('stone', look.stone);
  colour('cover', look.cover);
  colour('sunColour', look.sunColour, look.sunStrength);
  colour('fillColour', look.fill, look.air === null ? 1 : 3);
  colour('hazeColour', look.air?.horizon ?? [0, 0, 0]);
  colour('hazeGlow', look.air?.glow ?? [0, 0, 0], 0.35);
  uniforms['regolith']!.value = look.regolith;
  uniforms['hazePerMetre']!.value = look.air === null ? 0 : 1 / look.air.clearness;
  (uniforms['sunDirection']!.value as Vector3).copy(sunDirection);
}
