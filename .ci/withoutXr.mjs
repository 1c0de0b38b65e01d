// Leaves three's support of virtual reality out of the built page, which has none: 4 kB of what everybody fetches.

/** three by its own modules: its bundle is one file, from which no part can be left out. */
const THREE = 'three/src/Three.js';

/** What the renderer asks of its WebXR manager while no session can begin. */
const NO_XR = `export class WebXRManager {
  enabled = false;
  isPresenting = false;
  addEventListener() {}
  removeEventListener() {}
  setAnimationLoop() {}
  getEnvironmentBlendMode() {}
  dispose() {}
}`;

/** A plugin of the build. */
export const withoutXr = () => ({
  name: 'without-xr',
  apply: 'build',
  enforce: 'pre',
  resolveId(id, importer) {
    return id === 'three' ? this.resolve(THREE, importer, { skipSelf: true }) : null;
  },
  load: (id) => (id.endsWith('/three/src/renderers/webxr/WebXRManager.js') ? NO_XR : null),
});
