import { expect, it } from 'vitest';
import { decodeFrameJson } from '../../../src/wire';

it.each([
  ['x', '"x"'],
  [true, 'boolean'],
  [Number.NaN, 'NaN'],
  [{ high: 0, low: 5 }, 'object'],
] as const)('refuses the tick %j, named as it was sent', (tick, got) => {
  expect(decodeFrameJson({ tick, ships: [] })).toEqual({
    ok: false,
    reason: `tick: expected a whole number from 0 to 4503599627370496, got ${got}`,
  });
});
