import { describe, expect, it } from 'vitest';
import { blockAt, blocksOf, withProbes } from './probes.mjs';

const SOURCE = [
  'const TWICE = 2;',
  'export function half(x) { if (x > 0) { return x / TWICE; } return 0; }',
  'export const object = (x) => ({ x });',
].join('\n');

/** The blocks that a call reaches, by their indices. */
async function reached(call: string): Promise<number[]> {
  const blocks: number[] = [];
  const report = (path: string, block: number) => {
    expect(path).toBe('a.ts');
    blocks.push(block);
  };
  const ours = globalThis as { touchdownReport?: unknown };
  const others = ours.touchdownReport;
  ours.touchdownReport = report;
  try {
    const code = `${withProbes('a.ts', SOURCE)}\n${call};`;
    await import(`data:text/javascript,${encodeURIComponent(code)}`);
  } finally {
    ours.touchdownReport = others;
  }
  return blocks;
}

describe('the probes of mutants', () => {
  it.each([
    ['half(0); half(0)', [0]],
    ['half(1)', [0, 1]],
    ['if (object(3).x !== 3) throw new Error()', [2]],
    ['TWICE', []],
  ])('report each block once: %s', async (call, blocks) => expect(await reached(call)).toEqual(blocks));

  it('find the innermost block around a place', () => {
    const blocks = blocksOf('a.ts', SOURCE);
    expect(
      ['= 2', 'x > 0', 'x / TWICE', 'return 0', '{ x }'].map((place) =>
        blockAt(blocks, SOURCE.indexOf(place)),
      ),
    ).toEqual([-1, 0, 1, 0, 2]);
  });

  it('keep the lines of the source', () => {
    expect(
      withProbes('a.ts', SOURCE)
        .split('\n')
        .map((line) => line.length > 0),
    ).toHaveLength(3);
  });
});
