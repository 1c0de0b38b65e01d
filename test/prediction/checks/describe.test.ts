import { expect, it } from 'vitest';
import { describe } from '../../../src/prediction/checks/describe';

it('describes a list by its entries, and lists in it by their length', () => {
  expect(describe([1, 'a', [2, [3]], {}])).toBe('[1, "a", a list of 2, {  }]');
  expect(describe([1, 2, 3, 4, 5])).toBe('a list of 5');
});

it('describes a list that is nested deeper than the stack', () => {
  let nested: unknown[] = [];
  for (let depth = 0; depth < 100_000; depth++) nested = [nested];
  expect(describe(nested)).toBe('[a list of 1]');
});
