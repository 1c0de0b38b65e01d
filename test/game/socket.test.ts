import { expect, it } from 'vitest';
import { isTooLarge } from '../../src/game/socket';

it.each([
  ['x', 65_536, '', false],
  ['x', 65_536, 'x', true],
  ['é', 32_768, '', false],
  ['é', 32_768, 'x', true],
  ['€', 21_845, 'x', false],
  ['€', 21_845, 'é', true],
])('counts bytes of UTF-8: %j × %i and %j', (letter, times, rest, isLarge) => {
  expect(isTooLarge(letter.repeat(times) + rest)).toBe(isLarge);
});
