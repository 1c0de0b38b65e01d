import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import type { Browser, Page } from 'playwright-core';
import { createClient } from 'redis';
import { expect, it } from 'vitest';
import { readRecording, type RecordingEntry } from '../../src/scenarios';
import { valueOf } from '../authority/moon';
import { findChromium, launchChromium } from '../browser/chromium';
import { startDelayProxy } from './delayProxy';
import { type Bounce, errorsOf, looksAt, looksOf } from './looks';
import { readServiceStates } from './serviceStates';

/** One way, s. */
const DELAY = 0.05;
const PATIENCE = { timeout: 120_000, interval: 100 };
/**
 * Drawn in software instead of on a graphics card, the HUDs alone take both cores for up to a second, during which the service
 * stops too.
 */
const WITHOUT_GPU = '--disable-gpu';
const SHIPS = ['ship-pilot-one', 'ship-pilot-two'];
const SITE = [0.6, 0.48, 0.64] as const;

const program = await findChromium();
if (program === null && process.env['TOUCHDOWN_NO_SKIP'] === '1') throw new Error('no Chromium found');

/** `npm run live` as a user starts it, and what it printed. */
async function startLive() {
  const live = spawn(process.execPath, ['.ci/live.mjs'], { stdio: ['ignore', 'pipe', 'pipe'] });
  let output = '';
  for (const stream of [live.stdout, live.stderr])
    stream.on('data', (data: Buffer) => (output += data.toString()));
  const exited = new Promise<number | null>((resolve) => live.once('exit', resolve));
  await Promise.race([
    expect.poll(() => output, PATIENCE).toContain('Ctrl-C stops everything'),
    exited.then((code) => {
      throw new Error(`live ended with ${code}: ${output}`);
    }),
  ]);
  const found = (pattern: RegExp) => pattern.exec(output)![1]!;
  return {
    redisUrl: found(/Redis (redis:\S+),/),
    gatewayPort: Number(found(/gateway http:\/\/127\.0\.0\.1:(\d+)/)),
    addresses: [found(/pilot one: (\S+)/), found(/pilot two: (\S+)/)] as const,
    async end() {
      live.kill('SIGINT');
      return exited;
    },
  };
}

/** A pilot's page at a printed address, with its gateway on another port and path. */
async function openPilot(browser: Browser, printed: string, port: number, path: string): Promise<Page> {
  const address = new URL(printed);
  const server = new URL(address.searchParams.get('server')!);
  server.port = String(port);
  server.pathname = path;
  address.searchParams.set('server', server.href);
  const viewport = { width: 1280, height: 720 };
  const context = await browser.newContext({
    viewport,
    locale: 'en-US',
    timezoneId: 'UTC',
    acceptDownloads: true,
  });
  const page = await context.newPage();
  // Without pictures: drawn in software, they would take the CPU time of the stack.
  await page.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null));
  await page.goto(address.href, { waitUntil: 'domcontentloaded', timeout: PATIENCE.timeout });
  return page;
}

async function untilShown(page: Page, status: string): Promise<void> {
  await expect
    .poll(
      () =>
        page.evaluate(
          () =>
            `${document.documentElement.dataset['provenance']} ${document.documentElement.dataset['status']}`,
        ),
      PATIENCE,
    )
    .toBe(`confirmed ${status}`);
}

/** The page's own recording of everything that went into its predictor. */
async function saveRecording(page: Page): Promise<readonly RecordingEntry[]> {
  const { timeout } = PATIENCE;
  for (const part of ['Workshop', 'Recording'])
    await page.locator('summary', { hasText: part }).first().click({ timeout });
  const download = page.waitForEvent('download', { timeout });
  await page.getByRole('button', { name: 'Save', exact: true }).click({ timeout });
  return valueOf(readRecording(readFileSync(await (await download).path(), 'utf8'))).entries;
}

type Redis = ReturnType<typeof createClient>;
type Frame = { tick: number; ships: { ship_id: string; surface_contact_state: string; touched: boolean }[] };

async function newestFrame(redis: Redis): Promise<Frame> {
  const entries = await redis.xRevRange('touchdown:frames', '+', '-', { COUNT: 1 });
  return JSON.parse(entries![0]!.message['frame']!) as Frame;
}

/** Both ships are respawned 40 m up, fall, bounce and settle. */
async function dropBoth(redis: Redis, rate: number): Promise<Bounce> {
  const { tick: first } = await newestFrame(redis);
  for (const [i, shipId] of SHIPS.entries()) {
    const data = {
      ship_id: shipId,
      player_id: shipId.replace('ship-', ''),
      name: shipId,
      ship_class: 'planetary_lander',
      body: 'Luna',
      direction: [SITE[0] + i * 2e-5, SITE[1], SITE[2]],
      height: 40,
      velocity: [0, 0, -8],
    };
    await redis.xAdd('touchdown:inbox', '*', { type: 'respawn', data: JSON.stringify(data) });
  }
  const until = async (isMet: (frame: Frame) => boolean) => {
    await expect
      .poll(async () => {
        const frame = await newestFrame(redis);
        return frame.tick > first && frame.ships.length === 2 && isMet(frame);
      }, PATIENCE)
      .toBe(true);
  };
  await until(({ ships }) => ships.every(({ touched }) => touched));
  await until(({ ships }) => ships.every((ship) => ship.surface_contact_state === 'landed'));
  return { rate, first, last: (await newestFrame(redis)).tick };
}

it.skipIf(program === null)(
  'shows two pilots in Chromium both ships’ coasting bounces at the service’s positions, at 1 and 10 Hz through a delaying proxy',
  async () => {
    const [live, browser] = [await startLive(), await launchChromium(program!, [WITHOUT_GPU])];
    const proxy = await startDelayProxy(live.gatewayPort, DELAY);
    const states = await readServiceStates(live.redisUrl);
    const redis: Redis = createClient({ url: live.redisUrl });
    await redis.connect();
    try {
      const pages = [
        await openPilot(browser, live.addresses[0], proxy.port, '/stream'),
        await openPilot(browser, live.addresses[1], proxy.port, '/ws'),
      ] as const;
      const bounces: Bounce[] = [];
      for (const page of pages) await untilShown(page, 'landed');
      for (const rate of [1, 10]) {
        await redis.set('game:tick_rate', String(rate));
        bounces.push(await dropBoth(redis, rate));
        for (const page of pages) await untilShown(page, 'landed');
      }
      for (const [i, page] of pages.entries()) {
        const looks = looksOf(await saveRecording(page), SHIPS[i]!);
        for (const bounce of bounces) {
          const seen = looksAt(looks, bounce);
          const errors = errorsOf(seen, states);
          const p95 = errors[Math.floor(errors.length * 0.95)]!;
          const corrections = seen.at(-1)!.corrections - seen[0]!.corrections;
          const path = i === 0 ? '/stream' : '/ws';
          console.log(
            `page on ${path}, ${bounce.rate} Hz: ${corrections} corrections; p95 ${(p95 * 1000).toFixed(3)} mm, worst ${(errors.at(-1)! * 1000).toFixed(3)} mm of ${errors.length} looks`,
          );
          // Without relative fields the states are rounded.
          if (path === '/stream') expect(corrections).toBe(0);
          expect(p95, `${path} at ${bounce.rate} Hz`).toBeLessThan(0.02);
        }
      }
    } finally {
      states.stop();
      redis.destroy();
      await proxy.close();
      await browser.close();
      expect(await live.end()).toBe(0);
    }
  },
);
