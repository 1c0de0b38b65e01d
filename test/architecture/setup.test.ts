/** The set-up of `npm start` and `npm test`, run as a program with a fake npm. */
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { verdictOf } from '../../.ci/count.mjs';
import { causeOf, missingPackages, nodeComplaint } from '../../.ci/setup.mjs';
import { ROOT } from './source';

const LOCK = {
  packages: {
    '': {},
    'node_modules/shown': { version: '1.0.0' },
    'node_modules/vitest': { version: '2.0.0', dev: true },
  },
};

/** Does what `npm ci` does: empties node_modules, then installs the packages of the lock file. */
const OWN_NPM = `
const { mkdirSync, rmSync, writeFileSync, readFileSync } = require('node:fs');
if (process.env.FAIL) { console.error(process.env.FAIL); process.exit(1); }
rmSync('node_modules', { recursive: true, force: true });
const { packages } = JSON.parse(readFileSync('package-lock.json', 'utf8'));
for (const [path, { version, dev }] of Object.entries(packages)) {
  if (path === '' || (dev && process.argv.includes('--omit=dev'))) continue;
  mkdirSync(path, { recursive: true });
  writeFileSync(path + '/package.json', JSON.stringify({ version }));
}`;

describe('the set-up', () => {
  let folder = '';
  beforeEach(() => {
    folder = mkdtempSync(join(tmpdir(), 'touchdown-set-up-'));
    mkdirSync(join(folder, '.ci'));
    cpSync(join(ROOT, '.ci/setup.mjs'), join(folder, '.ci/setup.mjs'));
    writeFileSync(join(folder, 'package-lock.json'), JSON.stringify(LOCK));
    writeFileSync(join(folder, 'npm-cli.js'), OWN_NPM);
  });
  afterEach(() => rmSync(folder, { recursive: true }));

  function setUp(purpose: string, failure = ''): { status: number | null; out: string; err: string } {
    const env = { ...process.env, npm_execpath: join(folder, 'npm-cli.js'), FAIL: failure };
    const run = spawnSync(process.execPath, [join(folder, '.ci/setup.mjs'), purpose], {
      env,
      encoding: 'utf8',
    });
    return { status: run.status, out: run.stdout, err: run.stderr };
  }
  const has = (name: string) => existsSync(join(folder, 'node_modules', name));

  it('installs what is missing, once, and reports it', () => {
    const first = setUp('start');
    expect(first).toMatchObject({ status: 0, err: '' });
    expect(first.out).toMatch(/1 package is missing/);
    expect([has('shown'), has('vitest')]).toEqual([true, false]);
    expect(setUp('start')).toEqual({ status: 0, out: '', err: '' });
  });

  it('adds the test packages for a test, and a later start keeps them', () => {
    setUp('start');
    expect(setUp('test').status).toBe(0);
    expect([has('shown'), has('vitest')]).toEqual([true, true]);
    expect(setUp('start')).toEqual({ status: 0, out: '', err: '' });
    rmSync(join(folder, 'node_modules/shown'), { recursive: true });
    expect(setUp('start').status).toBe(0);
    expect([has('shown'), has('vitest')]).toEqual([true, true]);
  });

  it('replaces a package of another version', () => {
    setUp('test');
    writeFileSync(join(folder, 'node_modules/shown/package.json'), '{"version":"0.9.0"}');
    expect(setUp('start').out).toMatch(/1 package is missing/);
    expect(setUp('start').out).toBe('');
  });

  it('reports the cause when npm fails', () => {
    const run = setUp('start', 'npm error code ENOTFOUND');
    expect(run.status).toBe(1);
    expect(run.err).toMatch(/ENOTFOUND[^]*registry cannot be reached/);
    expect(setUp('banquet').err).toMatch(/expected a purpose/);
  });
});

describe('what the set-up decides', () => {
  it.each(['18.20.0', '20.18.9', '21.7.0', '22.11.0'])('refuses node %s', (version) => {
    expect(nodeComplaint(version)).toContain(version);
  });
  it.each(['20.19.0', '22.12.0', '23.0.0', '24.1.0', '26.0.0'])('accepts node %s', (version) => {
    expect(nodeComplaint(version)).toBeNull();
  });

  it('requests the native package of this machine only', () => {
    const native = { version: '1.0.0', optional: true, cpu: ['x64'] };
    const packages = {
      'node_modules/for-glibc': { ...native, os: ['linux'], libc: ['glibc'] },
      'node_modules/for-musl': { ...native, os: ['linux'], libc: ['musl'] },
      'node_modules/for-mac': { ...native, os: ['darwin'] },
      'node_modules/at-will': { version: '1.0.0', optional: true },
    };
    const onMachine = (machine: { os: string; cpu: string; libc?: string }) =>
      missingPackages(packages, 'start', machine, () => undefined);
    expect(onMachine({ os: 'linux', cpu: 'x64', libc: 'glibc' })).toEqual(['node_modules/for-glibc']);
    expect(onMachine({ os: 'linux', cpu: 'x64', libc: 'musl' })).toEqual(['node_modules/for-musl']);
    expect(onMachine({ os: 'darwin', cpu: 'x64' })).toEqual(['node_modules/for-mac']);
    expect(onMachine({ os: 'linux', cpu: 'arm64', libc: 'glibc' })).toEqual([]);
  });

  it('names common causes', () => {
    expect(causeOf('npm error code ENOSPC')).toMatch(/disk is full/);
    expect(causeOf('npm error Missing: a@1.0.0 from lock file')).toMatch(/disagree/);
    expect(causeOf('npm error code EODD')).toMatch(/npm’s output above/);
  });
});

describe('the final count', () => {
  const good = { numPassedTests: 5, numFailedTests: 0, numPendingTests: 0, numTodoTests: 0, success: true };
  it('succeeds when every test ran and passed', () => {
    expect(verdictOf([good])).toEqual({ line: '5 passed, 0 failed', complaint: null });
    expect(verdictOf([good, good])).toEqual({ line: '10 passed, 0 failed', complaint: null });
  });
  it.each([
    [{ numPassedTests: 0 }, '0 passed, 0 failed'],
    [{ numFailedTests: 1 }, '5 passed, 1 failed'],
    [{ numPendingTests: 2 }, '5 passed, 0 failed, 2 skipped'],
    [{ numTodoTests: 1 }, '5 passed, 0 failed, 1 skipped'],
    [{ success: false }, '5 passed, 0 failed'],
  ])('fails with %j', (change, line) => {
    const verdict = verdictOf([{ ...good, ...change }]);
    expect(verdict.line).toBe(line);
    expect(verdict.complaint).not.toBeNull();
    expect(verdictOf([good, { ...good, ...change }]).complaint).not.toBeNull();
  });
});
