// Leaves three's support of virtual reality out of the built page, which does not use it: 4 kB of every download.

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
