import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { writeRecording } from '../../src/scenarios';
import { listen, moonExchange, recordingOf } from '../scenarios/recordedSession';

const ROOT = join(import.meta.dirname, '../..');
const FIXTURES = join(import.meta.dirname, 'fixtures');
const folder = mkdtempSync(join(tmpdir(), 'parity-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** Runs the command as npm does. */
function parity(...files: string[]) {
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    ['test/run.mjs', 'test/parity/main.ts', ...files],
    { cwd: ROOT, encoding: 'utf8' },
  );
  return { status, lines: (stdout + stderr).trim().split('\n') };
}

function written(name: string, text: string): string {
  const path = join(folder, name);
  writeFileSync(path, text);
  return path;
}

describe('npm run parity', () => {
  it('checks the fixtures of the repository when no file is named, and exits 0', () => {
    const { status, lines } = parity();
    expect(lines.at(-1)).toMatch(/^(\d+) of \1 files agree$/);
    expect(lines.filter((line) => line.includes('states and events agree')).length).toBeGreaterThanOrEqual(
      28,
    );
    expect(status).toBe(0);
  }, 30_000);

  it('checks every file even when some fail, names the faults, and exits 1', () => {
    const good = readFileSync(join(FIXTURES, 'crash.json'), 'utf8');
    const { status, lines } = parity(
      written('broken.json', '{"tick_seconds": '),
      written('other.json', good.replace(/(.*)"fuel":4800\.0/, '$1"fuel":4800.1')),
      written('field.json', good.replace('"radius":1737400.0', '"radius":"big"')),
      join(folder, 'absent.json'),
      join(FIXTURES, 'crash.json'),
    );
    expect(status).toBe(1);
    const all = lines.join('\n');
    expect(all).toMatch(/broken\.json: not JSON/);
    expect(all).toMatch(/field\.json: body\.radius: expected a finite number, got 'big'/);
    expect(all).toMatch(/other\.json .*OUT OF TOLERANCE: fuel from tick 10/);
    expect(all).toMatch(/absent\.json: cannot be read: ENOENT/);
    expect(all).toMatch(/crash\.json .*states and events agree/);
    expect(all).toMatch(/1 of 5 files agree/);
  }, 30_000);

  it('accepts recordings of a server', () => {
    const client = listen(moonExchange('topple', 'broadband'));
    for (let now = 101; now <= 112; now++) client.runTo(now + 0.5);
    const { status, lines } = parity(written('server.jsonl', writeRecording(recordingOf(client))));
    expect(lines[0]).toMatch(/server\.jsonl .*states and events agree {2}\(12 states over 13 ticks\)/);
    expect(status).toBe(0);
  }, 30_000);
});
