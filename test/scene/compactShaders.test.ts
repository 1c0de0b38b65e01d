/** The shaders of the built page are compacted: what the GPU's compiler reads stays the same. */
import { describe, expect, it } from 'vitest';
import { compactShader, compactShaders } from '../../.ci/page/compactShaders.mjs';

describe('a compacted shader', () => {
  it.each([
    ['float a = b * ( c + d );', 'float a=b*(c+d);'],
    ['  float a = 1.0; // metres\n\n\n  float b;', '  float a=1.0;\nfloat b;'],
    ['/* two\n lines */float a;', 'float a;'],
    ['if ( a < b && ! c ) return - d;', 'if(a<b&&!c)return-d;'],
    ['for ( int i = 0; i < 4; i ++ ) {}', 'for(int i=0;i<4;i ++){}'],
  ])('loses only what no compiler reads: %j', (shader, compact) => {
    expect(compactShader(shader)).toBe(compact);
  });

  it.each(['a - -b', 'a + +b', 'a - --b', 'a++ + b'])('keeps the operators of %j apart', (sum) => {
    const tokens = (text: string) => text.match(/\+\+|--|[-+]|\w+/g);
    expect(tokens(compactShader(sum))).toEqual(tokens(sum));
  });

  it.each(['#define A (b)', '#if NUM_LIGHTS > 0', '#include <common>'])('keeps the directive %j', (line) => {
    expect(compactShader(`\n${line}\n`)).toBe(`\n${line}\n`);
  });

  it('is a literal marked as GLSL, and nothing else', () => {
    const { transform } = compactShaders() as unknown as { transform: (code: string) => string };
    expect(transform('const a = /* glsl */ `x = 1.0;`, b = `y = //`, c = 2 - 1;')).toBe(
      'const a = /* glsl */ `x=1.0;`, b = `y = //`, c = 2 - 1;',
    );
  });
});
