/** Runs in the page before its own script: skips triangles, makes all other WebGL calls. */
export function leaveOutTriangles(): void {
  const nothing = () => undefined;
  Object.assign(WebGL2RenderingContext.prototype, {
    drawElements: nothing,
    drawArrays: nothing,
    drawElementsInstanced: nothing,
    drawArraysInstanced: nothing,
  });
}

/** Runs in the page before its own script: its canvases have no WebGL. */
export function refuseWebGL(): void {
  const prototype = HTMLCanvasElement.prototype as { getContext: (...given: unknown[]) => unknown };
  const { getContext } = prototype;
  prototype.getContext = function (kind, ...settings) {
    return kind === 'webgl2' ? null : getContext.call(this, kind, ...settings);
  };
}
