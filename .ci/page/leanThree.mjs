// Leaves out of the built page the parts of three that the page does not use: 20 kB of every download.
import { leanShader } from './leanShaders.mjs';

/** three's separate modules: its bundle is one file, from which nothing can be left out. */
const THREE = 'three/src/Three.js';

/** The members of its WebXR manager that the renderer uses while no session can begin. */
const NO_XR = `export class WebXRManager {
  enabled = false;
  isPresenting = false;
  addEventListener() {}
  removeEventListener() {}
  setAnimationLoop() {}
  getEnvironmentBlendMode() {}
  dispose() {}
}`;

/** No material of the page reflects an environment map. */
const NO_ENVIRONMENTS = `export function WebGLEnvironments() {
  return {
    get(texture) {
      if (texture) throw new Error('environments are left out of the page by .ci/page/leanThree.mjs');
      return null;
    },
    dispose() {},
  };
}`;

/** CSS names of colours: the page uses numbers. */
const COLOUR_NAMES = /const _colorKeywords = \{[^}]*\}/;

/** Throws if three has changed so that nothing is left out. */
function withoutColourNames(code) {
  if (!COLOUR_NAMES.test(code)) throw new Error('leanThree: three has no table of colour names');
  return code.replace(COLOUR_NAMES, 'const _colorKeywords = {}');
}

/** Shaders of materials and backgrounds that the page does not draw. If one is drawn, it fails to compile, with this reason. */
const UNUSED_SHADERS =
  /\/three\/src\/renderers\/shaders\/ShaderLib\/(background|backgroundCube|cube|distance|equirect|linedashed|mesh(matcap|normal|phong|toon)|points|shadow|sprite|vsm)\.glsl\.js$/;
const NO_SHADER = `export const vertex = '#error left out of the page by .ci/page/leanThree.mjs';
export const fragment = vertex;`;

const SHADERS = /\/three\/src\/renderers\/shaders\/Shader(Chunk|Lib)\/.*\.glsl\.js$/;

function moduleInstead(id) {
  if (UNUSED_SHADERS.test(id)) return NO_SHADER;
  if (id.endsWith('/three/src/renderers/webgl/WebGLEnvironments.js')) return NO_ENVIRONMENTS;
  return id.endsWith('/three/src/renderers/webxr/WebXRManager.js') ? NO_XR : null;
}

/** A plugin of the build. */
export const leanThree = () => ({
  name: 'lean-three',
  apply: 'build',
  enforce: 'pre',
  resolveId(id, importer) {
    return id === 'three' ? this.resolve(THREE, importer, { skipSelf: true }) : null;
  },
  load: moduleInstead,
  transform(code, id) {
    if (id.endsWith('/three/src/math/Color.js')) return withoutColourNames(code);
    return SHADERS.test(id) ? code.replace(/`[^`]*`/g, leanShader) : null;
  },
});
