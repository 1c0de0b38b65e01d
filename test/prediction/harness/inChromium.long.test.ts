import { join } from 'node:path';
import { type Browser, type Page } from 'playwright-core';
import { rolldown } from 'rolldown';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { BODIES, SHIP_CLASSES } from '../../../src/index';
import { findChromium, launchChromium } from '../../browser/chromium';
import { createDesignServer, timeOf, truthAt } from './design/server';
import type { Drawn } from './pageClient';
import { createDice } from './random';
import { designBody, OTHER, OWN, placeShip } from './setup';
import { listenAsDesign, type SocketOfDesign } from './design/socket';
import { length, minus, unit, type Vec } from './design/vectors';

/** A page in a real browser on a server of the design: its thread is blocked with a key held, its server restarts, and its player takes another ship. */

const SEND_RATE = 5;
/** s after things go on; after that all is right. */
const ALLOWED = 1;
const WATCHED = 3;
/** s: the time, and what a display frame and two timers of a busy machine add. */
const RIGHT = 0.05;
const UNSURE = 0.05;
/** s of a contact in which a status may be wrong: on a foreign server the next state corrects it. */
const WRONG_STATUS = 0.3;
/** m from the server's place: 95 % of what is drawn, and all of it. A server of 50 Hz notices a touch up to a tick late and falls on. */
const NEAR = 0.1;
const NEAR_A_TOUCH = 0.2;
const program = await findChromium();
if (program === null && process.env['TOUCHDOWN_NO_SKIP'] === '1') throw new Error('no Chromium found');

function landers(): SocketOfDesign['server'] {
  const told = BODIES.find(({ name }) => name === 'Luna')!;
  const body = designBody(told);
  const shipClass = SHIP_CLASSES.find(({ name }) => name === 'planetary_lander')!;
  const place = { shipClass, site: unit([0.6, 0.48, 0.64]), body, terrainHeight: () => 0 };
  const dice = createDice(4);
  const ships = [OWN, OTHER].map((id, k) => placeShip(dice, { ...place, id, aside: 100 * k }));
  return createDesignServer(body, ships, {
    terrainHeight: () => 0,
    tickRate: 50,
    timeScale: 1,
    sendRate: SEND_RATE,
    drift: 0,
    sendsBodies: 'all',
    sendsScale: true,
  });
}

const wait = (seconds: number) => new Promise((resolve) => setTimeout(resolve, seconds * 1000));

describe.skipIf(program === null)('a page in Chromium', () => {
  let browser: Browser;
  let page: Page;
  let socket: SocketOfDesign;
  /** Lead of what was drawn before anything happened, s. */
  let usual = 0;

  beforeAll(async () => {
    socket = await listenAsDesign(landers(), OWN);
    const built = await rolldown({
      input: join(import.meta.dirname, 'pageClient.ts'),
      platform: 'browser',
    });
    const { output } = await built.generate({ format: 'iife' });
    browser = await launchChromium(program!);
    page = await browser.newPage();
    await page.addScriptTag({ content: output[0].code });
    await page.evaluate(([address, id]) => window.startClient(address!, id!), [socket.address, OWN]);
    await wait(15);
    usual = median((await drawnSince(0)).slice(-120).map(leadOf));
  });

  afterAll(async () => {
    await browser.close();
    await socket.close();
  });

  async function drawnSince(t: number): Promise<Drawn[]> {
    const all = await page.evaluate(() => window.client.drawn.splice(0));
    return all.filter(({ at }) => at - socket.beganAt > t);
  }

  const eraOf = ({ tick }: Drawn) =>
    socket.server.eras.findLast(
      ({ firstTick, ticks }) => tick >= firstTick && tick < firstTick + ticks.length + 500,
    )!;

  const leadOf = (drawn: Drawn) =>
    timeOf(eraOf(drawn), drawn.tick, drawn.sinceTick, 0) - (drawn.at - socket.beganAt);

  /** What is drawn from `ALLOWED` s on is right: time and place, and status but for `WRONG_STATUS` s. */
  async function expectRight(): Promise<void> {
    await wait(ALLOWED);
    await drawnSince(0);
    await wait(WATCHED);
    const drawn = await drawnSince(0);
    await wait(0.5);
    expect(drawn.length, 'display frames').toBeGreaterThan(WATCHED * 5);
    const off = Math.max(...drawn.map((one) => Math.abs(leadOf(one) - usual)));
    expect(off, `${off.toFixed(3)} s off the instant that is due`).toBeLessThan(RIGHT + UNSURE);
    const wrong: string[] = [];
    const away: number[] = [];
    for (const one of drawn) {
      const truth = truthAt(eraOf(one), one.shipId, one.tick, one.sinceTick);
      if (truth === null) continue;
      away.push(length(minus([...one.position] as Vec, truth.position)));
      if (one.shown !== truth.state) wrong.push(`${one.shown} for ${truth.state} at tick ${one.tick}`);
    }
    away.sort((a, b) => a - b);
    expect(away[Math.floor(0.95 * away.length)], 'm from where the server has it, p95').toBeLessThan(NEAR);
    expect(away.at(-1), 'm from where the server has it, worst').toBeLessThan(NEAR_A_TOUCH);
    const seconds = (wrong.length / drawn.length) * WATCHED;
    expect(seconds, `s of a wrong status, from ${wrong[0] ?? ''}`).toBeLessThan(WRONG_STATUS);
    expect(await page.evaluate(() => window.client.troubles)).toEqual([]);
  }

  /** The key that acts on a ship at the server. */
  const heldOf = (id: string) => socket.server.ships.get(id)!.controls.translationInput[0];

  async function hold(sideways: number): Promise<void> {
    await page.evaluate((key) => {
      window.client.hold(key);
    }, sideways);
    await wait(0.5);
  }

  /** Holds a key; then what `happen` does; then the key, held over an absence, counts as let go. */
  async function withKeyHeld(happen: () => Promise<unknown>): Promise<void> {
    await hold(1);
    expect(heldOf(socket.flown)).toBe(1);
    try {
      await happen();
      await expectRight();
      expect(heldOf(socket.flown), 'the key after the absence').toBe(0);
    } finally {
      await hold(0);
    }
  }

  // A blocked thread, not Page.setWebLifecycleState: without a window no page is hidden, and none freezes.
  it.each([5, 60])('recovers after its thread was blocked for %i s with a key held', async (seconds) => {
    await withKeyHeld(() =>
      page.evaluate((length) => {
        const until = performance.now() + length * 1000;
        while (performance.now() < until);
      }, seconds),
    );
  });

  it('recovers after the server was down for 3 s and counts from 0', async () => {
    socket.server.stand(socket.now(), 3);
    await wait(3);
    socket.server.restart(socket.now(), 0);
    await expectRight();
  });

  it('flies another ship, and no longer controls the previous one', async () => {
    await hold(1);
    await page.evaluate((id) => {
      window.client.predictor.setOwnShip(id);
    }, OTHER);
    socket.flown = OTHER;
    await wait(1);
    expect(heldOf(OTHER)).toBe(1);
    await hold(0);
    // Let go on the other: what the one before was last sent stays.
    expect([OWN, OTHER].map(heldOf)).toEqual([1, 0]);
    await expectRight();
  });
});

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]!;
}
