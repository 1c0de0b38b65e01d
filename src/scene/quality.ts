/** Costly parts of the picture in software rendering: together they take more than half of the time. */
export interface Quality {
  readonly antialias: boolean;
  /** Samples along the ground as it is seen at a grazing angle. */
  readonly anisotropy: number;
}

export const FINE: Quality = { antialias: true, anisotropy: 4 };
const QUICK: Quality = { antialias: false, anisotropy: 1 };

const BY_PROCESSOR = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/**
 * Quality for this machine, by the renderer's name; a browser that hides it is assumed to use a GPU.
 *
 * @example
 * ```ts
 * const quality = qualityFor(document);
 * console.log(quality.antialias);
 * ```
 */
export function qualityFor(document: Document): Quality {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) return QUICK;
  const names = [gl.getParameter(gl.RENDERER) as unknown];
  const unmasked = gl.getExtension('WEBGL_debug_renderer_info');
  if (unmasked !== null) names.push(gl.getParameter(unmasked.UNMASKED_RENDERER_WEBGL));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return BY_PROCESSOR.test(names.join(' ')) ? QUICK : FINE;
}
