/** The shaders of the built page are without branches that the page never takes: what is compiled stays the same. */
import { describe, expect, it } from 'vitest';
import { leanShader } from '../../.ci/page/leanShaders.mjs';

const lines = (...all: readonly string[]) => all.join('\n');

describe('a lean shader', () => {
  it.each([
    ['#ifdef USE_FOG', [], ['b;']],
    ['#ifndef USE_FOG', ['a;'], []],
    ['#ifdef USE_CLEARCOATMAP // of a coat', [], ['b;']],
    ['#if defined( USE_FOG ) || defined( USE_ENVMAP )', [], ['b;']],
    ['#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )', [], ['b;']],
  ])('leaves out the branch of %s, and keeps the other', (condition, first, second) => {
    expect(leanShader(lines('x;', condition, 'a;', '#else', 'b;', '#endif', 'y;'))).toBe(
      lines('x;', ...first, ...second, 'y;'),
    );
  });

  it.each([
    '#ifdef USE_MAP',
    '#ifdef USE_FOGGY',
    '#ifndef FLAT_SHADED',
    '#if defined( USE_FOG ) || defined( USE_MAP )',
    '#if defined( USE_MAP ) && defined( USE_FOG )',
    '#if ! defined( USE_FOG )',
    '#if NUM_DIR_LIGHTS > 0',
    '#if ( defined( A ) && ( NUM_SPOT_LIGHTS > 0 || B ) ) || ( NUM_SPOT_LIGHTS > 0 )',
  ])('keeps %s, which may hold', (condition) => {
    const shader = lines(condition, 'a;', '#elif defined( C )', 'b;', '#else', 'c;', '#endif');
    expect(leanShader(shader)).toBe(shader);
  });

  it('begins with the next condition where the first never holds', () => {
    expect(
      leanShader(lines('#ifdef USE_FOG', 'a;', '#elif defined( B )', 'b;', '#else', 'c;', '#endif')),
    ).toBe(lines('#if defined( B )', 'b;', '#else', 'c;', '#endif'));
  });

  it('leaves out the branches inside, and no others', () => {
    const inside = ['#ifdef USE_MAP', 'a;', '#elif B', 'b;', '#else', 'c;', '#endif'];
    expect(leanShader(lines('#ifdef USE_FOG', ...inside, 'd;', '#endif', 'e;'))).toBe('e;');
    expect(leanShader(lines('#ifdef USE_MAP', '#ifdef USE_FOG', 'a;', '#endif', 'b;', '#endif'))).toBe(
      lines('#ifdef USE_MAP', 'b;', '#endif'),
    );
  });

  it.each(['#endif', '#ifdef USE_MAP', lines('#ifndef USE_FOG', '#elif B', '#endif')])(
    'refuses %j',
    (text) => {
      expect(() => leanShader(text)).toThrow('leanShader');
    },
  );
});
