/** The instruments of flying in a real browser: what they print and draw for given numbers. */
import type { Page } from 'playwright-core';
import { beforeAll, expect, it } from 'vitest';
import type { FlightPanels } from '../../../src/hud';
import {
  createFlightReadout,
  createLandingAids,
  createTargetReadout,
  type FlightReadout,
  type LandingAids,
  type TargetReadout,
} from '../../../src/readout';
import { describeInBrowser, openTestPage, problemsOf } from '../pages';

interface Numbers extends Partial<Pick<FlightPanels, 'autopilot' | 'aidsOn'>> {
  readonly flight?: Partial<FlightReadout>;
  readonly aids?: Partial<LandingAids>;
  readonly target?: Partial<TargetReadout>;
}

let page: Page;

/** Shows the numbers; what is not given is as in a new readout. */
async function show({ flight, aids, target, autopilot = false, aidsOn = true }: Numbers): Promise<void> {
  const panels = {
    flight: { ...createFlightReadout(), ...flight, memory: null },
    aids: { ...createLandingAids(), ...aids, memory: null },
    target: { ...createTargetReadout(), ...target },
    ...{ autopilot, aidsOn },
  };
  await page.evaluate((shown) => {
    const { hud } = window as unknown as { hud: { showFlight: (shown: object) => void } };
    hud.showFlight(shown);
  }, panels);
}

const text = (part: string) => page.locator(`.td-flight ${part}`).innerText();
const attribute = (part: string, name: string) => page.locator(`.td-flight ${part}`).getAttribute(name);
const attributes = (part: string, ...names: string[]) =>
  Promise.all(names.map((name) => attribute(part, name)));

const FLYING = { known: true, throttle: 0.5, hover: 0.25, fuel: 2000, fuelShare: 0.25 };

describeInBrowser('the instruments of flying', () => {
  beforeAll(async () => {
    page = await openTestPage('hud.html', { reducedMotion: 'reduce' });
    await page.waitForSelector('html[data-ready=true]');
  });

  it('show dashes for what is unknown', async () => {
    await show({ aidsOn: false });
    expect(await attributes('.td-lever', 'role', 'aria-label', 'aria-valuemin', 'aria-valuemax')).toEqual([
      ...['meter', 'Throttle', '0', '100'],
    ]);
    expect(await attributes('.td-lever', 'aria-valuenow', 'aria-valuetext')).toEqual(['0', '--']);
    expect(await attribute('.td-lever-fill', 'd')).toBe('M0 100H18V100H0Z');
    expect(await attributes('.td-lever-hover', 'data-shown', 'transform')).toEqual([
      'false',
      'translate(0 100)',
    ]);
    expect(await attribute('.td-ball', 'data-known')).toBe('false');
    expect(await text('.td-attitude-words')).not.toContain('WHEELS');
    expect(
      await page.locator('.td-flight :is(.td-aids, .td-approach)').filter({ visible: true }).count(),
    ).toBe(0);
  });

  it('show throttle, the throttle that hovers, and fuel', async () => {
    await show({ flight: { ...FLYING, burnSeconds: 83, deltaV: 1500 } });
    expect(await attribute('.td-lever-fill', 'd')).toBe('M0 50H18V100H0Z');
    expect(await attributes('.td-lever-hover', 'data-shown', 'transform')).toEqual([
      'true',
      'translate(0 75)',
    ]);
    expect(await attributes('.td-lever', 'aria-valuenow', 'aria-valuetext')).toEqual(['50', '50 %']);
    expect(await text('.td-lever-words')).toBe('ENGINE\n50 %\nHOVER\n25 %');
    const fuel = await Promise.all(
      ['fuel', 'tank', 'burn', 'deltav'].map((name) => text(`.td-reading-${name}`)),
    );
    expect(fuel.map((line) => line.replaceAll('\n', ' '))).toEqual([
      ...['FUEL 2\u202f000 kg', 'OF TANK 25 %', 'LASTS 83.0 s', 'Δv 1\u202f500 m/s'],
    ]);
    const lows: (string | null)[] = [];
    for (const fuelShare of [0.05, 0.049]) {
      await show({ flight: { ...FLYING, hover: 1, fuelShare } });
      lows.push(await attribute('.td-fuel', 'data-low'));
    }
    expect(lows).toEqual(['false', 'true']);
    expect(await attributes('.td-lever-hover', 'data-shown', 'transform')).toEqual([
      'true',
      'translate(0 0)',
    ]);
    await show({ flight: { ...FLYING, throttle: 0.503, hover: 1.01 } });
    expect(await attribute('.td-lever-fill', 'd')).toBe('M0 50H18V100H0Z');
    expect(await attribute('.td-lever-hover', 'data-shown')).toBe('false');
  });

  it('show attitude: the zenith away from the lean, heading, pitch and the fullest wheel', async () => {
    const wheels = Float64Array.of(-0.5, 0.25, -0.75);
    await show({ flight: { ...FLYING, leanX: 9.7, leanY: 18.4, heading: 47, pitch: 60, wheels } });
    expect(await attributes('.td-zenith', 'transform')).toEqual(['translate(-4.5 8)']);
    expect(await attribute('.td-ball', 'data-known')).toBe('true');
    expect(await text('.td-attitude-words')).toBe('HDG\n047°\nPITCH\n60.0°\nWHEELS\n75 %');
    const rings = page.locator('.td-flight .td-ring');
    expect(await rings.evaluateAll((all) => all.map((ring) => Number(ring.getAttribute('r'))))).toEqual([
      expect.closeTo(20 / 3, 9),
      20,
    ]);
  });

  it('show the modes with their keys, on or off in a word', async () => {
    const rows = page.locator('.td-flight .td-mode');
    const on = async () =>
      (await rows.allInnerTexts()).filter((row) => row.endsWith('on')).map((row) => row.split('\n').at(-2));
    const damped = { ...FLYING, damping: true };
    await show({ flight: { ...damped, mode: 'radial' } });
    expect(await attribute('.td-modes', 'aria-label')).toBe('Attitude modes');
    expect((await rows.allInnerTexts()).map((row) => row.replaceAll('\n', ' '))).toEqual([
      ...['rateD Damping on', 'Hold off', 'modeU Upright on', 'modeR Retrograde off', 'autop Autopilot off'],
    ]);
    expect(await rows.evaluateAll((all) => all.map((row) => row.dataset['on']))).toEqual([
      ...['true', 'false', 'true', 'false', 'false'],
    ]);
    const seen: unknown[] = [];
    for (const mode of ['hold', 'retrograde', 'surface_retrograde', 'prograde'] as const) {
      await show({ flight: { ...FLYING, damping: false, mode } });
      seen.push(await on());
    }
    expect(seen).toEqual([['Hold'], ['Retrograde'], ['Retrograde'], []]);
    await show({ flight: { ...damped, mode: 'radial' }, autopilot: true });
    expect(await on()).toEqual(['Damping', 'Autopilot']);
    await show({ flight: { ...damped, mode: 'radial', known: false }, autopilot: true });
    expect(await on()).toEqual([]);
  });

  it('show the landing aids, late braking marked', async () => {
    const aids = {
      aimSpeed: 5,
      corridor: 'fast',
      touchSeconds: 12,
      touchVertical: 3,
      touchHorizontal: 1,
    } as const;
    const late: (string | null)[] = [];
    for (const burnSeconds of [1, 0.9]) {
      await show({ aids: { ...aids, burnSeconds } });
      late.push(await attribute('.td-reading-brake .td-value', 'data-late'));
    }
    expect(late).toEqual(['false', 'true']);
    expect((await text('.td-aids')).replaceAll('\n', ' ')).toBe(
      'AIM ↓ 5.0 m/sTOO FAST BRAKE IN 0.9 s TOUCH IN 12.0 s AT ↓ 3.0 m/s · 1.0 m/s',
    );
    expect(await attribute('.td-corridor', 'data-corridor')).toBe('fast');
    await show({ aids, aidsOn: false });
    expect(await page.locator('.td-flight .td-aids').isVisible()).toBe(false);
  });

  it('show the beacon, the drift of five seconds and the predicted touch', async () => {
    const beacon = { shown: true, x: 31, y: -40, distance: 50.6, radius: 20, scale: 100 };
    const moving = { driftX: 2, driftY: -1, missX: 5, missY: 10 };
    await show({ target: { ...beacon, ...moving } });
    expect(await attributes('.td-pad', 'cx', 'cy', 'r')).toEqual(['12.5', '16', '8']);
    expect(await attribute('.td-drift-way', 'd')).toBe('M0 0L4 2');
    expect(await attributes('.td-touch-cross', 'data-shown', 'transform')).toEqual([
      'true',
      'translate(14.5 12)',
    ]);
    expect(await attributes('.td-approach', 'role', 'aria-label', 'aria-valuemin', 'aria-valuemax')).toEqual([
      ...['meter', 'Distance to the beacon', '0', '100'],
    ]);
    expect(await attributes('.td-approach', 'aria-valuenow', 'aria-valuetext')).toEqual([
      '51',
      '50.6 m, behind right',
    ]);
    await show({ target: { ...beacon, ...moving, missX: NaN } });
    expect(await attribute('.td-touch-cross', 'data-shown')).toBe('false');
    await show({ target: { ...beacon, ...moving }, aidsOn: false });
    expect(await attribute('.td-touch-cross', 'data-shown')).toBe('false');
    await show({
      target: { ...beacon, x: -900, y: 900, distance: 1273, radius: 900, driftX: 99, driftY: 99 },
    });
    expect(await attributes('.td-pad', 'cx', 'cy', 'r')).toEqual(['-40', '-40', '40']);
    expect(await attribute('.td-drift-way', 'd')).toBe('M0 0L40 -40');
    expect(await attribute('.td-approach', 'aria-valuemax')).toBe('1273');
  });

  it('give the way to the beacon in words', async () => {
    const ways: string[] = [];
    for (const [x, y, radius] of [
      [0, 50, 3],
      [0, -50, 3],
      [50, 20, 3],
      [-50, 21, 3],
      [-20, 50, 3],
      [50, 0, 50],
      [50, 0, 49],
    ] as const) {
      await show({ target: { shown: true, x, y, distance: 50, radius, scale: 100, driftX: 0, driftY: 0 } });
      ways.push(await text('.td-way'));
    }
    expect(ways).toEqual(['ahead', 'behind', 'right', 'ahead left', 'ahead', 'below you', 'right']);
    expect(await attribute('.td-pad', 'r')).toBe('19.5');
    expect(problemsOf(page)).toEqual([]);
  });
});
