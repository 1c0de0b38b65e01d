import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { servicePython } from '../../.ci/python.mjs';
import { SERVER_HOME } from '../exact/python';

it('the service installs with pip from its folder, with redis alone, and runs from the installed package', () => {
  const { command } = servicePython();
  const folder = mkdtempSync(join(tmpdir(), 'service-'));
  const before = readdirSync(SERVER_HOME).sort();
  try {
    const options = ['--quiet', '--disable-pip-version-check', '--no-compile', '--target', folder];
    const install = spawnSync(command, ['-m', 'pip', 'install', ...options, SERVER_HOME], {
      encoding: 'utf8',
    });
    expect(install.status, install.stderr).toBe(0);
    const packages = readdirSync(folder).filter((name) => name.endsWith('.dist-info'));
    // On older Pythons, redis has dependencies.
    const foreign = packages.filter(
      (name) => !/^(touchdown_service|redis|async_timeout|typing_extensions)-/.test(name),
    );
    expect(foreign).toEqual([]);
    expect(existsSync(join(folder, 'bin/touchdown-service'))).toBe(true);
    const env = { ...process.env, PYTHONPATH: folder };
    const nobody = ['--redis', 'redis://127.0.0.1:1/0', '--world', join(folder, 'none.json')];
    const run = spawnSync(command, ['-B', '-m', 'touchdown_service', ...nobody], {
      cwd: folder,
      env,
      encoding: 'utf8',
    });
    expect(run.status).toBe(2);
    expect(run.stderr).toContain('none.json');
    expect(readdirSync(SERVER_HOME).sort(), 'nothing is left in the source folder').toEqual(before);
  } finally {
    rmSync(folder, { recursive: true });
  }
}, 120_000);
