import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, describe, expect, it } from 'vitest';
import { firstDifference, hashCase } from './compare';
import { drawCase } from './cases/drawCase';
import type { ExactCase } from './cases/exactCase';
import { caseTerrain } from './cases/playCase';
import { HAS_PYTHON, MAY_SKIP, replayInPython, SERVER_HOME, surveyInPython } from './python';
import { heightsHere, surveyPoints } from './survey';

// The comparison must detect the same sum in another order.
const withPython = !HAS_PYTHON && MAY_SKIP ? it.skip : it;

// The shortest first: most cases reveal each change, and Python is slow.
const played = Array.from({ length: 60 }, (_, i) => drawCase(i + 1))
  .map((exact) => ({ exact, result: hashCase(exact) }))
  .sort((a, b) => a.result.substeps - b.result.substeps);
const cases = played.map(({ exact }) => exact);
const ours = played.map(({ result }) => result);

let home: string | null = null;
afterEach(() => {
  if (home !== null) rmSync(home, { recursive: true });
  home = null;
});

/** A copy of the Python server with one expression written differently. */
function brokenServer(file: string, expression: string, instead: string): string {
  home = mkdtempSync(join(tmpdir(), 'law-'));
  cpSync(join(SERVER_HOME, 'touchdown_service'), join(home, 'touchdown_service'), {
    recursive: true,
    filter: (path) => !/fixtures$|__pycache__/.test(path),
  });
  const path = join(home, 'touchdown_service', file);
  const source = readFileSync(path, 'utf8');
  expect(source.split(expression), `${expression} occurs once in ${file}`).toHaveLength(2);
  writeFileSync(path, source.replace(expression, instead));
  return home;
}

/** Cases per request to Python: most cases reveal each of these changes. */
const BATCH = 12;

/** The first case in which a broken server differs from the law, or null. */
async function firstDiffering(broken: string): Promise<ExactCase | null> {
  for (let from = 0; from < cases.length; from += BATCH) {
    const theirs = await replayInPython(cases.slice(from, from + BATCH), broken);
    const at = theirs.findIndex(({ hash }, i) => hash !== ours[from + i]!.hash);
    if (at >= 0) return cases[from + at]!;
  }
  return null;
}

const HEX = String.raw`typescript 0x[0-9a-f]{16} \(.+\), python 0x[0-9a-f]{16} \(.+\)`;
const REPORT = new RegExp(String.raw`^\S+: tick \d+ substep -?\d+: [a-z_ .]+: ${HEX}$`);

describe('a Python law with another order of operations', () => {
  withPython.each([
    ['law/surface.py', 'vx * sx + vy * sy + vz * sz', 'vx * sx + (vy * sy + vz * sz)'],
    [
      'law/surface.py',
      'x - rise_1 * first[0] - rise_2 * second[0]',
      'x - (rise_1 * first[0] + rise_2 * second[0])',
    ],
    ['law/pose.py', 'x + tx * twice + 2 * (ay * tz - az * ty)', 'x + (tx * twice + 2 * (ay * tz - az * ty))'],
    ['law/flight.py', 'x + (ux * dt + ax * half_squared)', '(x + ux * dt) + ax * half_squared'],
    [
      'law/actuators.py',
      'ship.fuel - (main * cls.main_flow + burn * cls.rcs_flow) * dt',
      'ship.fuel - main * cls.main_flow * dt - burn * cls.rcs_flow * dt',
    ],
    [
      'law/attitude_control.py',
      'tx * qw - tw * qx - ty * qz + tz * qy',
      'tx * qw + tz * qy - tw * qx - ty * qz',
    ],
    ['law/forces.py', 'dx * sx + dy * sy + dz * sz', 'dx * sx + (dy * sy + dz * sz)'],
    [
      'law/moments.py',
      'toppling * (ny * upz - nz * upy) + mx + kx',
      'toppling * (ny * upz - nz * upy) + (mx + kx)',
    ],
    ['law/vectors.py', 'ay * bw + aw * by + az * bx - ax * bz', 'aw * by + az * bx + ay * bw - ax * bz'],
    ['law/pose.py', 'hx * w + hy * z - hz * y', 'hx * w - hz * y + hy * z'],
    ['ship_class.py', '(c * h - b * i) / determinant', '(c * h - b * i) * (1 / determinant)'],
  ])('%s: %s', async (file, expression, instead) => {
    const broken = brokenServer(file, expression, instead);
    const differing = await firstDiffering(broken);
    expect(differing, `none of ${cases.length} cases differs`).not.toBeNull();
    expect(await firstDifference(differing!, { home: broken })).toMatch(REPORT);
  });

  withPython('noise.py: c0 + (c1 - c0) * tz', async () => {
    const broken = brokenServer('ground/noise.py', 'c0 + (c1 - c0) * tz', '(1 - tz) * c0 + c1 * tz');
    const points = surveyPoints();
    const theirs = await surveyInPython(points, broken);
    expect(heightsHere(points).filter((height, i) => height !== theirs[i]).length).toBeGreaterThan(100);
  });

  withPython('and so is a terrain of ours that does', async () => {
    const terrainOf: typeof caseTerrain = (terrain) => {
      if ('name' in terrain) return caseTerrain(terrain);
      const { base, amplitude, axis } = terrain;
      return (_body, nx, ny, nz) => {
        const along = nx * axis[0] + (ny * axis[1] + nz * axis[2]);
        return base + amplitude * (along * along);
      };
    };
    const differing = cases.filter(
      (exact, i) => hashCase(exact, undefined, terrainOf).hash !== ours[i]!.hash,
    );
    expect(differing.length).toBeGreaterThan(5);
    expect(await firstDifference(differing[0]!, { terrainOf })).toMatch(REPORT);
  });
});
