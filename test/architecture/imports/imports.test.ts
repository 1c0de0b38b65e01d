import { describe, expect, it } from 'vitest';
import { importFaults, importsOf } from './importTable';
import { filesUnder } from '../source';

/** The faults of one line of code in a file. */
function faultsOf(path: string, text: string): string[] {
  return importFaults({ path, text });
}

describe('imports follow the table, through each folder’s index', () => {
  it('in every file of src', () => {
    const files = filesUnder('src', /(?<!\.d)\.[jt]s$/);
    expect(files.flatMap(importsOf).length).toBeGreaterThan(100);
    expect(files.flatMap(importFaults)).toEqual([]);
  });

  it.each([
    ['src/dynamics/a.ts', "import * as THREE from 'three'", 'imports three'],
    ['src/dynamics/a.ts', "import type { Frame } from '../wire'", 'imports wire'],
    ['src/dynamics/a.ts', "export { frame } from '../wire'", 'imports wire'],
    ['src/dynamics/a.ts', "export * from '../wire'", 'imports wire'],
    ['src/dynamics/a.ts', "const wire = await import('../wire')", 'imports wire'],
    ['src/dynamics/a.ts', "let frame: import('../wire').Frame", 'imports wire'],
    ['src/dynamics/a.ts', "import wire = require('../wire')", 'imports wire'],
    ['src/dynamics/a.ts', 'const any = await import(name)', 'not a plain string'],
    ['src/prediction/a.ts', "import { decode } from '../wire'", 'types alone'],
    ['src/prediction/a.ts', "import { type Frame } from '../wire'", 'types alone'],
    ['src/prediction/a.ts', "import type { Frame } from '../wire/frame'", 'past the index'],
    ['src/playground/a.ts', "import { stage } from '../scene/stage'", 'past the index'],
    [
      'src/playground/a.ts',
      "new Worker(new URL('../authority/worker.ts', import.meta.url))",
      'past the index',
    ],
    ['src/playground/deep/a.ts', "import { state } from '../../../test/state'", 'outside of src'],
    ['src/hud/a.ts', "import type { View } from '../prediction'", 'imports prediction'],
    ['src/index.ts', "export * from './wire/frame'", 'past the index'],
    ['src/dynamics/a.ts', "import { vec3 } from 'gl-matrix'", 'which dynamics may not'],
    ['src/cellar/a.ts', "import { substep } from '../dynamics'", 'does not know'],
  ])('%s: %s is a fault', (path, text, said) => {
    expect(faultsOf(path, text)).toEqual([expect.stringContaining(said)]);
  });

  it.each([
    ['src/scene/a.ts', "import { vec3 } from 'gl-matrix'; import { LAYOUT } from './layout'"],
    [
      'src/wire/a.ts',
      "import protobuf from 'protobufjs/minimal.js'; import { codec } from './generated/codec'",
    ],
    ['src/prediction/a.ts', "import type { Frame } from '../wire'; import { substep } from '../dynamics'"],
    ['src/playground/deep/a.ts', "import { World } from '../../authority'; import { b } from '../b'"],
    ['src/playground/a.ts', "new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })"],
    ['src/index.ts', "export { substep } from './dynamics'; export type { Frame } from './wire'"],
  ])('%s: %s is allowed', (path, text) => {
    expect(faultsOf(path, text)).toEqual([]);
  });
});
