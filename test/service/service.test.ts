import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { expectUnittest, HERE, isMissing } from './pythonTests';

const MINUTES = 60_000;

it.skipIf(isMissing('python')).each(['test_loading', 'test_shortcuts', 'test_simulation'])(
  '%s.py passes',
  expectUnittest,
  2 * MINUTES,
);

// These mostly wait, each for its own Redis and service.
const WITH_REDIS = [
  ...['Lease', 'Damage'].map((name) => `test_lease.${name}`),
  ...['Ships', 'Inputs', 'Clock'].map((name) => `test_redis.${name}`),
];
describe.skipIf(isMissing('redis')).concurrent('against a real Redis', () => {
  it.each([...WITH_REDIS, 'test_garbage', 'test_recorder'])('%s passes', expectUnittest, 6 * MINUTES);
});

it('every file is run, here or in service.long.test.ts', () => {
  const files = readdirSync(HERE).filter((name) => /^test_\w+\.py$/.test(name));
  const known = [
    'test_crash.py',
    'test_garbage.py',
    'test_lease.py',
    'test_loading.py',
    'test_recorder.py',
    'test_redis.py',
    'test_shortcuts.py',
    'test_simulation.py',
  ];
  expect(files.sort()).toEqual(known);
  const classes = ['test_lease', 'test_redis'].flatMap((name) => {
    const text = readFileSync(`${HERE}/${name}.py`, 'utf8');
    return [...text.matchAll(/^class (\w+)\(WithService\)/gm)].map(([, found]) => `${name}.${found!}`);
  });
  expect(classes).toEqual(WITH_REDIS);
});
