/** Reports when the GPU has finished all commands before the fence. */
export interface Fence {
  readonly set: () => void;
  /** False before `set`. Call it again in a later task: within one task the answer does not change. */
  readonly isPassed: () => boolean;
}

export function createFence(gl: WebGL2RenderingContext): Fence {
  let sync: WebGLSync | null = null;
  let passed = false;
  return {
    set() {
      passed = false;
      sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
    },
    isPassed() {
      if (sync === null) return passed;
      // A context that is lost does nothing more.
      passed = gl.isContextLost() || gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.SIGNALED;
      if (!passed) return false;
      gl.deleteSync(sync);
      sync = null;
      return true;
    },
  };
}
