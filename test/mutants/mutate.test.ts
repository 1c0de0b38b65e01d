import { describe, expect, it } from 'vitest';
import { changesOf, sampleOf } from './mutate.mjs';

const changed = (text: string) =>
  changesOf('a.ts', text).map(
    ({ start, end, text: instead }) => text.slice(0, start) + instead + text.slice(end),
  );

describe('mutants', () => {
  it.each([
    ['const a = b + c;', ['const a = b - c;']],
    ['const a = b < 3;', ['const a = b <= 3;', 'const a = b < 4;']],
    ['const a = !b && true;', ['const a = b && true;', 'const a = !b || true;', 'const a = !b && false;']],
    ['f(x);', [';']],
    ['const a = b ? c : d;', ['const a = !(b) ? c : d;']],
    ['const a = new Float64Array(3);', ['const a = new Float64Array(2);']],
    ['const a = 2 ** 1e18;', ['const a = 3 ** 1e18;', 'const a = 2 ** 2000000000000000000;']],
    ['const a = Math.min(b, c);', ['const a = Math.max(b, c);']],
  ])('of %s', (text, all) => expect(changed(text).sort()).toEqual(all.sort()));

  it.each([
    "import { a } from './a';",
    'type A = 1 | 2;',
    'throw new Error(`${a + 1}`);',
    'interface A { b: true }',
  ])('are none in %s', (text) => expect(changed(text)).toEqual([]));

  it('name their line and what they do', () => {
    expect(changesOf('a.ts', 'const a = 1;\nconst b = a - c;')[1]).toMatchObject({
      line: 2,
      says: 'const b = a - c;  →  const b = a + c;',
    });
  });

  it('are drawn by the seed, each once', () => {
    const items = Array.from({ length: 50 }, (_, i) => i);
    const drawn = sampleOf(items, 20, 7);
    expect(sampleOf(items, 20, 7)).toEqual(drawn);
    expect(sampleOf(items, 20, 8)).not.toEqual(drawn);
    expect(new Set(drawn).size).toBe(20);
    expect(sampleOf(items, 80, 7).sort((a, b) => a - b)).toEqual(items);
  });
});
