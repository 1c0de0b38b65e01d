import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { LANDED } from '../../../src/dynamics';
import type { LandedDay } from './landedDay';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

// Target 0 m and 0 rad. Today 21, 3.6, 0.017 and 458 µm, most on the Moon, whose turn of 13 nrad per substep rounds the same way
// every time; 6.8e-11, 1.6e-11, 1.0e-11, 1.8e-10 rad.
const TOLERANCES: readonly (readonly [string, number, number])[] = [
  ['Earth', 3e-5, 8e-11],
  ['Mars', 5e-6, 2e-11],
  ['Phobos', 3e-8, 1.2e-11],
  ['Luna', 6e-4, 2e-10],
];

describe('a landed ship over one day', () => {
  it('keeps its body-fixed pose', () => {
    const printed = execFileSync(process.execPath, ['test/run.mjs', 'test/dynamics/bodies/landedDay.ts'], {
      cwd: ROOT,
      encoding: 'utf8',
    });
    const days = JSON.parse(printed) as LandedDay[];
    expect(days.length).toBe(TOLERANCES.length);
    for (const [name, metres, radians] of TOLERANCES) {
      const day = days.find((candidate) => candidate.body === name)!;
      expect(day.state).toBe(LANDED);
      expect(day.moved).toBeLessThan(metres);
      expect(day.turned).toBeLessThan(radians);
      expect(day.burnt).toBe(0);
      // The body has turned by Ω t; otherwise the test proves nothing.
      expect(day.bodyMissed).toBeLessThan(5e-11);
    }
  });
});
