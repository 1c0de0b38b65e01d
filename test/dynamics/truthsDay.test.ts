import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { LANDED } from '../../src/dynamics';
import type { LandedDay } from './landedDay';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

// Target 0 m and 0 rad. Today 1.7, 2.4, 0.01 µm, and 520 µm on the Moon, whose turn of 13 nrad a substep rounds the same way
// every time; 1.1e-11, 8e-12, 2e-12, 8e-11 rad.
const TOLERANCES: readonly (readonly [string, number, number])[] = [
  ['Earth', 2e-6, 1.3e-11],
  ['Mars', 3e-6, 1e-11],
  ['Phobos', 2e-8, 3e-12],
  ['Luna', 6e-4, 1e-10],
];

describe('a landed ship over a day', () => {
  it('stands still in the axes of its body', { timeout: 120_000 }, () => {
    const printed = execFileSync(process.execPath, ['test/run.mjs', 'test/dynamics/landedDay.ts'], {
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
      // The body itself has turned by Ω t: without that, nothing above would mean anything.
      expect(day.bodyMissed).toBeLessThan(1e-11);
    }
  });
});
