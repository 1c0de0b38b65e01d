/** A WebGL 2 context that draws nothing and counts what it holds: three's renderer, and with it the whole scene, then runs in node. */

/** What three asks of a context, by the constant's name; LIMIT for every other. */
const PARAMETERS: Readonly<Record<string, unknown>> = {
  VERSION: 'WebGL 2.0',
  SCISSOR_BOX: [0, 0, 300, 150],
  VIEWPORT: [0, 0, 300, 150],
};
const LIMIT = 4096;
const EXTENSIONS = new Set(['EXT_clip_control', 'EXT_color_buffer_float']);
const SAMPLER = /uniform (?:highp |lowp )?sampler2D (\w+);/g;
const SAMPLER_2D = 0x8b5e;

interface Program {
  source?: string;
}

export interface CountedCanvas {
  readonly canvas: HTMLCanvasElement;
  /** Objects that the context holds, by kind: created and not deleted. */
  readonly held: Record<string, number>;
  /** Whether all commands so far are carried out. */
  readonly gpu: { isDone: boolean; isLost: boolean };
}

/** Constants by name: any that is not listed gets a new number. */
function constants() {
  const numbers = new Map<string, number>();
  const names: string[] = [];
  return {
    nameOf: (value: number) => names[value - 1],
    of(name: string) {
      const known = numbers.get(name) ?? names.push(name);
      numbers.set(name, known);
      return known;
    },
  };
}

/** The samplers that a program's sources declare: three binds their textures. All other uniforms are left out. */
function samplersOf({ source = '' }: Program) {
  return [...new Set([...source.matchAll(SAMPLER)].map((found) => found[1]!))];
}

export function createCountedCanvas(width = 300, height = 150): CountedCanvas {
  const held: Record<string, number> = {};
  const gpu = { isDone: false, isLost: false };
  const known = constants();
  const calls: Readonly<Record<string, (...given: never[]) => unknown>> = {
    getContextAttributes: () => ({ alpha: true }),
    getExtension: (name: string) => (EXTENSIONS.has(name) ? { clipControlEXT: () => undefined } : null),
    getParameter: (value: number) => PARAMETERS[known.nameOf(value) ?? ''] ?? LIMIT,
    getShaderPrecisionFormat: () => ({ precision: 23 }),
    getProgramInfoLog: () => '',
    getShaderInfoLog: () => '',
    shaderSource: (shader: Program, source: string) => (shader.source = source),
    attachShader: (program: Program, shader: Program) =>
      (program.source = `${program.source ?? ''}${shader.source ?? ''}`),
    getProgramParameter: (program: Program, value: number) => {
      const name = known.nameOf(value);
      return name === 'ACTIVE_UNIFORMS' ? samplersOf(program).length : name !== 'ACTIVE_ATTRIBUTES';
    },
    getActiveUniform: (program: Program, at: number) => ({
      name: samplersOf(program)[at],
      type: SAMPLER_2D,
      size: 1,
    }),
    getUniformLocation: (_program: Program, name: string) => name,
    checkFramebufferStatus: () => known.of('FRAMEBUFFER_COMPLETE'),
    isContextLost: () => gpu.isLost,
    fenceSync() {
      gpu.isDone = false;
      return count('Sync', 1);
    },
    getSyncParameter: () => known.of(gpu.isDone ? 'SIGNALED' : 'UNSIGNALED'),
  };
  const count = (kind: string, more: number) => {
    held[kind] = (held[kind] ?? 0) + more;
    return { kind };
  };
  const callOf = (name: string) => {
    const [, verb, kind] = /^(create|delete)([A-Z]\w*)$/.exec(name) ?? [];
    if (verb === 'create') return () => count(kind!, 1);
    if (verb === 'delete') return (given: unknown) => given && count(kind!, -1);
    return calls[name] ?? (() => undefined);
  };
  const context = new Proxy<Record<string, unknown>>(
    {},
    {
      get(made, name) {
        if (typeof name !== 'string') return undefined;
        return (made[name] ??= /^[A-Z][A-Z0-9_]*$/.test(name) ? known.of(name) : callOf(name));
      },
    },
  );
  const canvas = {
    ...{ width, height, style: {} },
    getContext: (kind: string) => (kind === 'webgl2' ? context : null),
    addEventListener: () => undefined,
    removeEventListener: () => undefined,
  } as unknown as HTMLCanvasElement;
  return { canvas, held, gpu };
}
