import { type ChildProcess, spawn } from 'node:child_process';
import { randomUUID } from 'node:crypto';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createClient } from 'redis';
import { afterEach, expect, it } from 'vitest';
import { freePort } from '../../.ci/ports.mjs';

/** ms; for hangs alone. */
const PATIENCE = { timeout: 120_000, interval: 50 };

const hasProc = existsSync('/proc/self/environ');
const started: ChildProcess[] = [];
const folders: string[] = [];

afterEach(() => {
  for (const child of started.splice(0)) child.kill('SIGTERM');
  for (const folder of folders.splice(0)) rmSync(folder, { recursive: true, force: true });
});

/** `npm run live`, after its set-up. `path`: where it looks for programs. */
function live(args: readonly string[] = [], path = process.env['PATH']) {
  const mark = randomUUID();
  const child = spawn(process.execPath, ['.ci/live.mjs', ...args], {
    env: { ...process.env, PATH: path, TOUCHDOWN_TEST: mark },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  started.push(child);
  let output = '';
  for (const stream of [child.stdout, child.stderr])
    stream.on('data', (data: Buffer) => (output += data.toString()));
  const ended = new Promise<number | null>((resolve) => child.once('exit', resolve));
  return {
    ended,
    output: () => output,
    processes: (redisPort: number) => processesOf(mark, redisPort),
    signal: (name: NodeJS.Signals) => child.kill(name),
    found: (pattern: RegExp) => pattern.exec(output)?.[1] ?? '',
    isUp: () =>
      Promise.race([expect.poll(() => output, PATIENCE).toContain('Ctrl-C stops everything'), ended]),
  };
}

function newFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-start-'));
  folders.push(folder);
  return folder;
}

const REDIS = /Redis (redis:\S+),/;
const DATA = /data in (\S+) \(/;
const PAGE = /pilot one: (http:\/\/[^/]+\/)/;

/**
 * Processes of this machine that `live` started, itself included, where there is a /proc: found by a mark in their environment, and Redis,
 * which overwrites its own, by its port.
 */
function processesOf(mark: string, redisPort: number): string[] {
  if (!hasProc) return [];
  const read = (pid: string, file: string) => {
    try {
      return readFileSync(`/proc/${pid}/${file}`, 'utf8');
    } catch {
      // It has just ended, or is another user's.
      return '';
    }
  };
  return readdirSync('/proc')
    .filter((name) => /^\d+$/.test(name))
    .filter(
      (pid) =>
        read(pid, 'environ').includes(mark) ||
        read(pid, 'cmdline').includes(`redis-server 127.0.0.1:${redisPort}`),
    );
}

const answers = (url: string) =>
  fetch(url).then(
    () => true,
    () => false,
  );

it('prints the line that installs Redis if it is missing, and starts nothing', async () => {
  const { ended, output } = live([], newFolder());
  expect(await ended).toBe(1);
  expect(output()).toMatch(
    /^live: Redis is needed: (sudo apt-get install -y redis-server|brew install redis)\n$/,
  );
});

it.each(['redis', 'gateway', 'page'])(
  'says that the port asked for %s is taken, and which option chooses another',
  async (whose) => {
    const holder = createServer();
    await new Promise<void>((resolve) => holder.listen(0, '127.0.0.1', resolve));
    const { port } = holder.address() as { port: number };
    const { ended, output } = live([`--${whose}-port`, String(port)]);
    expect(await ended).toBe(1);
    holder.close();
    expect(output()).toContain(`port ${port} for `);
    expect(output()).toContain(`is taken: choose another with --${whose}-port`);
  },
);

it.each([
  [['--rate', '1000'], '--rate: expected 0.1 to 100 Hz, got 1000'],
  [['--page-port', '0'], '--page-port: expected 1 to 65535, got 0'],
  [['--speed', '2'], '--speed'],
])('refuses %j by name, and says what there is', async (args, words) => {
  const { ended, output } = live(args);
  expect(await ended).toBe(1);
  expect(output()).toContain(words);
  expect(output()).toContain('npm run live -- [options]');
});

it.each(['SIGINT', 'SIGHUP'] as const)(
  'ends every process at %s, and removes Redis’s data',
  async (signal) => {
    const port = await freePort();
    const one = live(['--redis-port', String(port)]);
    await one.isUp();
    const folder = one.found(DATA);
    if (hasProc) expect(one.processes(port).length).toBeGreaterThanOrEqual(4);
    const addresses = [one.found(PAGE), `${one.found(/gateway (http:\S+),/)}/healthz`];
    for (const address of addresses) expect(await answers(address), address).toBe(true);
    one.signal(signal);
    // A terminal and npm both pass it on.
    one.signal(signal);
    expect(await one.ended).toBe(0);
    expect(one.processes(port)).toEqual([]);
    for (const address of addresses) expect(await answers(address), address).toBe(false);
    expect(existsSync(folder)).toBe(false);
    expect(one.output()).toContain('data is removed');
  },
);

it('leaves no process behind when it is ended while it starts', async () => {
  for (const wait of [100, 300, 500, 700, 1000, 1400, 2000]) {
    const port = await freePort();
    const one = live(['--redis-port', String(port)]);
    await new Promise((resolve) => setTimeout(resolve, wait));
    one.signal('SIGTERM');
    await one.ended;
    // Its first calls of Python may take a moment to end.
    await expect.poll(() => one.processes(port), { ...PATIENCE, message: `after ${wait} ms` }).toEqual([]);
  }
});

it('continues from the data that it kept, and refuses to run twice on it', async () => {
  const folder = newFolder();
  const first = live(['--data', folder, '--rate', '10']);
  await first.isUp();
  const tick = async (url: string) => {
    const redis = createClient({ url });
    await redis.connect();
    const at = Number(await redis.get('game:tick'));
    redis.destroy();
    return at;
  };
  await expect.poll(() => tick(first.found(REDIS)), PATIENCE).toBeGreaterThan(5);
  const second = live(['--data', folder]);
  expect(await second.ended).toBe(1);
  expect(second.output()).toContain(`${folder} is in use by the Redis of process `);
  const before = await tick(first.found(REDIS));
  first.signal('SIGINT');
  expect(await first.ended).toBe(0);
  expect(first.output()).toContain(`data is in ${folder}`);
  const third = live(['--data', folder, '--rate', '10']);
  await third.isUp();
  expect(await tick(third.found(REDIS))).toBeGreaterThanOrEqual(before);
  third.signal('SIGINT');
  expect(await third.ended).toBe(0);
});

it('runs twice at once, each on its own ports', async () => {
  const both = [live(), live()];
  for (const one of both) await one.isUp();
  const addresses = both.map((one) => one.found(PAGE));
  expect(new Set(addresses).size).toBe(2);
  for (const address of addresses) expect(await answers(address), address).toBe(true);
  for (const one of both) one.signal('SIGINT');
  for (const one of both) expect(await one.ended).toBe(0);
});
