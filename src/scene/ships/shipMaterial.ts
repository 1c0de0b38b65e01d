import { Color, DoubleSide, MeshDepthMaterial, MeshStandardMaterial, ShaderChunk } from 'three';
import type { BodyLook } from '../sky/bodyLook';

/**
 * One material for all parts of all ships: finish and leg travel are attributes of the geometry (parts.ts), the compressions
 * of a ship's legs (m) attributes of its instance (hulls.ts).
 */
export interface ShipMaterial {
  readonly surface: MeshStandardMaterial;
  readonly shadow: MeshDepthMaterial;
  paint(look: BodyLook): void;
  dispose(): void;
}

const FLEX_HEAD = /* glsl */ `
attribute vec2 flex;
attribute vec4 compression;
`;
const FLEX_BODY = /* glsl */ `
#include <begin_vertex>
transformed.z += flex.y * compression[int(flex.x + 0.5)];
`;

/** The call in three's lights that gives the sun's; the built page has it without spaces. */
const SUNLIGHT = /getDirectionalLightInfo\(\s*directionalLight,\s*directLight\s*\);/;

/** three's own lights, with the sun dimmed per ship. Throws if three has no such call: all ships would be lit alike. */
function sunByShip(): string {
  const lights = ShaderChunk.lights_fragment_begin;
  if (!SUNLIGHT.test(lights)) throw new Error('lights_fragment_begin: no call of getDirectionalLightInfo');
  return lights.replace(SUNLIGHT, '$& directLight.color *= vSunlit;');
}

export function createShipMaterial(): ShipMaterial {
  const shared = {
    skyTint: { value: new Color() },
    groundTint: { value: new Color() },
  };
  const surface = new MeshStandardMaterial({ vertexColors: true, side: DoubleSide });
  surface.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, shared);
    shader.vertexShader =
      `${FLEX_HEAD}attribute vec3 surface;\nattribute float sunlit;\nvarying vec3 vSurface;\nvarying float vSunlit;\n${shader.vertexShader}`.replace(
        '#include <begin_vertex>',
        `${FLEX_BODY}\nvSurface = surface;\nvSunlit = sunlit;`,
      );
    shader.fragmentShader =
      `varying vec3 vSurface;\nvarying float vSunlit;\nuniform vec3 skyTint;\nuniform vec3 groundTint;\n${shader.fragmentShader}`
        .replace('#include <lights_fragment_begin>', sunByShip())
        .replace('#include <roughnessmap_fragment>', 'float roughnessFactor = vSurface.x;')
        .replace('#include <metalnessmap_fragment>', 'float metalnessFactor = vSurface.y;')
        .replace(
          '#include <emissivemap_fragment>',
          // Reflections of a metal, from two colours: ground below, sky above.
          `totalEmissiveRadiance = diffuseColor.rgb * vSurface.z;
          vec3 mirrored = inverseTransformDirection(reflect(-normalize(vViewPosition), normal), viewMatrix);
          totalEmissiveRadiance += diffuseColor.rgb * vSurface.y * (1.0 - 0.6 * vSurface.x)
            * mix(groundTint, skyTint, smoothstep(-0.15, 0.25, mirrored.y));`,
        );
  };
  const shadow = new MeshDepthMaterial({ side: DoubleSide });
  shadow.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, shared);
    shader.vertexShader = `${FLEX_HEAD}${shader.vertexShader}`.replace('#include <begin_vertex>', FLEX_BODY);
  };
  return {
    surface,
    shadow,
    paint(look) {
      const [r, g, b] = look.dust;
      const light = look.sunStrength * Math.sin((look.sun.elevation * Math.PI) / 180) * 1.3;
      shared.groundTint.value.setRGB(r * light, g * light, b * light);
      const [sr, sg, sb] = look.air?.horizon ?? [0.015, 0.016, 0.02];
      shared.skyTint.value.setRGB(sr, sg, sb);
    },
    dispose() {
      surface.dispose();
      shadow.dispose();
    },
  };
}
