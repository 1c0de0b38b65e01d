import { describe, expect, it } from 'vitest';
import { unusedExports } from './exports';
import { filesUnder } from '../source';

/** Entries that others import: the package's, and the gateway, which a host starts. */
const DOORS = ['index', 'protobuf', 'hud/index', 'scene/index', 'game/index', 'gateway/index'].map(
  (name) => `src/${name}.ts`,
);
/** Files used by people and tools, each on its own. */
const EXAMPLE = /^src\/example\//;
/** The columns and small integers of a row are declared together, including unused ones. */
const TOGETHER = /^src\/dynamics\/state\/layout\.ts: /;

describe('exported values', () => {
  it('are imported somewhere', () => {
    const files = ['src', 'test', '.ci']
      .flatMap((folder) => filesUnder(folder, /(?<!\.d)\.(ts|mjs|js)$/))
      .filter(({ path }) => !EXAMPLE.test(path));
    expect(files.length).toBeGreaterThan(100);
    const unused = unusedExports(files, DOORS);
    expect(unused.filter((name) => !TOGETHER.test(name))).toEqual([]);
  });

  const unusedIn = (texts: Readonly<Record<string, string>>) =>
    unusedExports(
      Object.entries(texts).map(([path, text]) => ({ path, text })),
      ['src/index.ts'],
    );

  it('that nothing imports are found, also through an index', () => {
    const room = {
      'src/a/index.ts': "export { b, c } from './b';",
      'src/a/b.ts': 'export const b = 1, c = 2;',
    };
    expect(unusedIn({ ...room, 'src/index.ts': "export { b } from './a';" })).toEqual([
      'src/a/index.ts: c',
      'src/a/b.ts: c',
    ]);
    expect(unusedIn({ ...room, 'src/index.ts': "export * from './a';" })).toEqual([]);
    expect(unusedIn({ ...room, 'src/index.ts': "import * as a from './a'; export const d = a.b;" })).toEqual(
      [],
    );
    expect(unusedIn({ ...room, 'src/index.ts': "void import('./a');" })).toEqual([]);
  });

  it('do not include types', () => {
    expect(
      unusedIn({ 'src/index.ts': '', 'src/a.ts': 'export interface A { b: 1 }\nexport type B = A;' }),
    ).toEqual([]);
  });
});
