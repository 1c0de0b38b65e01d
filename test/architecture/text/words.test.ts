import { describe, expect, it } from 'vitest';
import { isEmptyName, wordFaults } from './forbiddenWords';
import { filesUnder } from '../source';

describe('forbidden words', () => {
  it('are in no file of src', () => {
    const files = filesUnder('src', /(?<!\.d)\.[jt]s$/);
    expect(files.filter((file) => file.path.startsWith('src/dynamics/')).length).toBeGreaterThan(10);
    expect(files.flatMap(wordFaults)).toEqual([]);
  });

  it.each([
    'const y = Math.sin(x)',
    'const y = Math.hypot(x, z)',
    'const y = Math.random()',
    "const y = Math['sin'](x)",
    'const { sin } = Math',
    'const M = Math',
    'const y = x ** 2',
    'x **= 2',
    'const now = Date.now()',
    'const now = new Date()',
    'const now = globalThis.performance.now()',
    'const bits = crypto.getRandomValues(row)',
    'setTimeout(step, 1)',
    "const y = x['toFixed'](3)",
    'const row = new Float32Array(3)',
    'quat.slerp(out, a, b, 0.5)',
    'glMatrix.setMatrixArrayType(Array)',
  ])('in dynamics: %s is a fault', (text) => {
    expect(wordFaults({ path: 'src/dynamics/a.ts', text })).not.toEqual([]);
  });

  it.each([
    'const y = Math.sqrt(Math.abs(x))',
    'const y = Math.max(0, Math.min(1, x))',
    '// Math.sin(x) would differ, as would x ** 2',
    "const said = 'performance of Math.sin'",
    'const tick = count % 10',
  ])('in dynamics: %s is allowed', (text) => {
    expect(wordFaults({ path: 'src/dynamics/a.ts', text })).toEqual([]);
  });

  it.each([
    ['src/hud/a.ts', 'row.innerHTML = name'],
    ['src/hud/a.ts', "row['outerHTML'] = name"],
    ['src/hud/a.ts', "row.insertAdjacentHTML('beforeend', name)"],
    ['src/playground/a.ts', "eval('1')"],
    ['src/playground/a.ts', "new Function('return 1')"],
    ['src/prediction/a.ts', 'const now = performance.now()'],
    ['src/authority/a.ts', 'const seed = Math.random()'],
  ])('%s: %s is a fault', (path, text) => {
    expect(wordFaults({ path, text })).not.toEqual([]);
  });

  it.each([
    ['src/playground/a.ts', 'const now = performance.now()'],
    ['src/readout/a.ts', 'const y = Math.atan2(a, b)'],
    ['src/hud/a.ts', 'row.textContent = name'],
  ])('%s: %s is allowed', (path, text) => {
    expect(wordFaults({ path, text })).toEqual([]);
  });
});

describe('file and folder names', () => {
  it('say what is inside', () => {
    const files = [...filesUnder('src', /./), ...filesUnder('test', /./), ...filesUnder('proto', /./)];
    expect(files.length).toBeGreaterThan(20);
    expect(files.map((file) => file.path).filter(isEmptyName)).toEqual([]);
  });

  it.each([
    'src/hud/util.ts',
    'src/wire/decodeHelpers.ts',
    'src/utils/row.ts',
    'test/ship-manager.ts',
    'src/Misc.ts',
  ])('%s is refused', (path) => expect(isEmptyName(path)).toBe(true));

  it.each(['src/dynamics/state/layout.ts', 'src/hud/utilisation.ts'])('%s is accepted', (path) => {
    expect(isEmptyName(path)).toBe(false);
  });
});
