import { describe, expect, it } from 'vitest';
import { circlesOf } from './circles';
import { filesUnder } from '../source';

const ROOMS = [
  'scene',
  'wire',
  'readout',
  'hud',
  'scenarios',
  'game',
  'authority',
  'gateway',
  'playground',
  'dynamics',
  'prediction',
  'example',
];

describe('import cycles', () => {
  const files = filesUnder('src', /(?<!\.d)\.[jt]s$/);

  const inRooms = (rooms: readonly string[]) =>
    files.filter(({ path }) => rooms.some((room) => path.startsWith(`src/${room}/`)));

  it('do not exist among values', () => {
    expect(inRooms(ROOMS).length).toBeGreaterThan(100);
    expect(circlesOf(inRooms(ROOMS), 'values')).toEqual([]);
  });

  it.each(ROOMS)('do not exist among types in src/%s', (room) => {
    expect(inRooms([room]).length).toBeGreaterThan(3);
    expect(circlesOf(inRooms([room]), 'all')).toEqual([]);
  });

  const circlesIn = (texts: Readonly<Record<string, string>>, kinds: 'values' | 'all' = 'all') =>
    circlesOf(
      Object.entries(texts).map(([path, text]) => ({ path, text })),
      kinds,
    );

  it('are found through types and an index too', () => {
    expect(
      circlesIn({
        'src/a.ts': "import type { B } from './b';",
        'src/b/index.ts': "export { c } from './c';",
        'src/b/c.ts': "import '../a';",
      }),
    ).toEqual(['src/a.ts → src/b/index.ts → src/b/c.ts → src/a.ts']);
    const byType = { 'src/a.ts': "import type { B } from './b';", 'src/b.ts': "import './a';" };
    expect(circlesIn(byType, 'values')).toEqual([]);
    expect(circlesIn(byType)).toHaveLength(1);
    expect(circlesIn({ 'src/a.ts': "import './b';", 'src/b.ts': "import './c';", 'src/c.ts': '' })).toEqual(
      [],
    );
  });
});
