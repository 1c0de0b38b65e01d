/** Typical first mistakes of callers: each is reported once, with its code and the value. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { createPredictor, type Predictor } from '../../../src/prediction';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { BOUNDS, reordered, takenForAnotherOrder } from './mistakes/bounds';
import { CALL_BOUNDS, measuredRates } from './mistakes/callBounds';
import { frame, LUNA, made, played, received, ticks, warningsOf } from './mistakes/given';
import { CALLS } from './mistakes/calls';
import { CONTROLS } from './mistakes/controls';
import { MESSAGES } from './mistakes/messages';
import { OPTIONS } from './mistakes/options';
import { SHIPS } from './mistakes/ships';

const MISTAKES = [...OPTIONS, ...MESSAGES, ...SHIPS, ...CALLS, ...CONTROLS];
const ROOM = join(import.meta.dirname, '../../../src/prediction');
describe('a caller’s mistake is reported once, by its code', () => {
  it.each(MISTAKES)('%s: %s', (_what, code, help, run) => {
    const found = run().filter((warning) => warning.code === code);
    expect(found).toHaveLength(1);
    expect(found[0]!.message).toMatch(help);
    expect(Object.keys(found[0]!.details).length).toBeGreaterThan(0);
  });

  it('no warning is given where nothing is wrong', () => {
    expect(played(30).filter(({ code }) => code !== 'bodies-old')).toEqual([]);
    expect(made({ defaults: { settings: { contactCrashSpeed: 60 } } })).toEqual([]);
  });
});

describe('a value is reported from its bound on', () => {
  it.each([...BOUNDS, ...CALL_BOUNDS])('%s: %s', (_what, code, within, beyond, run) => {
    const count = (value: number) => run(value).filter((warning) => warning.code === code).length;
    expect([count(within), count(beyond)]).toEqual([0, 1]);
  });

  it('a tempo is reported together with the measured one', () => {
    const [slow, fast] = measuredRates();
    expect(slow).toBeCloseTo(1 / 6, 6);
    expect(fast).toBeCloseTo(10, 6);
  });

  it('an attitude’s order is reported if it gives no rotation, or if another order makes a landed ship upright', () => {
    // [0, 0, 1, 0] is [0, 0, 0, 1] of JSON, which begins with w.
    expect(takenForAnotherOrder()).toEqual({ attitude: ['0010', '1000'], target: ['1000'] });
    const states = ['landed', '', 'contact', 'tipped'].map(
      (surfaceContactState) => reordered(0, { surfaceContactState }).length,
    );
    expect(states).toEqual([1, 1, 0, 0]);
  });
});

/** Warnings on frames of `tempo`, each a number of ticks at a rate, Hz, after a silence, s. */
const atTempo = (...tempo: readonly { ticks: number; tickRate: number; silence?: number }[]) =>
  warningsOf((p) => {
    let tick = 0;
    let at = 0;
    for (const { ticks, tickRate, silence = 0 } of tempo) {
      at += silence;
      for (let i = 0; i < ticks; i++) {
        p.receive({ ...frame, tick, tickRate, bodies: [] }, at);
        p.advance(null, at);
        tick += 1;
        at += 1 / tickRate;
      }
    }
  }).filter(({ code }) => code === 'tick-rate');

describe('a tempo is not reported', () => {
  it('when it changes', () => {
    const changes = [
      { ticks: 30, tickRate: 1 },
      { ticks: 200, tickRate: 50 },
      { ticks: 5, tickRate: 0.5 },
    ];
    expect(atTempo(...changes, { ticks: 300, tickRate: 10 })).toEqual([]);
  });

  it('when the server pauses without saying so', () => {
    const running = { ticks: 20, tickRate: 2 };
    expect(atTempo(running, { ...running, silence: 300 }, { ...running, silence: 60 })).toEqual([]);
  });
});

it('the id of a ship that was seen before is not reported', () => {
  const found = received(
    ...ticks(3),
    ...ticks(20, { ships: [] }).map((one) => ({ ...one, tick: one.tick + 3 })),
  );
  expect(found.filter(({ code }) => code === 'own-ship-never-seen')).toEqual([]);
});

const planned = (tick: number) => ({ tick, substep: 0, controls: NEUTRAL_CONTROLS });

it('a plan in order is not reported', () => {
  expect(() => createPredictor({ plan: [planned(4), planned(5), planned(5)] })).not.toThrow();
});

it('advance counts as missing at the tenth frame', () => {
  const after = (frames: number) =>
    warningsOf((p) => {
      for (const one of ticks(frames)) p.receive(one, one.tick);
    }).filter(({ code }) => code === 'advance-never').length;
  expect([after(9), after(10)]).toEqual([0, 1]);
});

/** The call at which a mistake is reported that begins with call `from`. */
function reportedAt(from: number, code: string, call: (p: Predictor, n: number, wrong: object) => void) {
  const reported: number[] = [];
  let n = 0;
  const onWarning = (found: string) => found === code && reported.push(n);
  warningsOf(
    (p) => {
      while (n < 150) call(p, ++n, n >= from ? { misspelt: 1 } : {});
    },
    { onWarning },
  );
  return reported[0];
}

describe.each([
  [
    'a frame',
    'unknown-field',
    (p: Predictor, n: number, wrong: object) =>
      p.receive({ ...frame, ...wrong, tick: n, tickRate: 50 }, n / 50),
  ],
  [
    'controls',
    'unknown-control',
    (p: Predictor, n: number, wrong: object) => p.advance({ ...NEUTRAL_CONTROLS, ...wrong }, n / 100),
  ],
] as const)('a mistake in %s', (_, code, call) => {
  it('is reported at once among the first 50, and later at the next multiple of 50', () => {
    const found = [1, 50, 51, 99, 100, 101].map((from) => reportedAt(from, code, call));
    expect(found).toEqual([1, 50, 100, 100, 100, 150]);
  });
});

describe('an invalid option', () => {
  const thrown = (options: object) => () => createPredictor(options);
  it.each([
    [{ ownShipId: 7 }, 'options.ownShipId: expected a string'],
    [{ terrains: { luna: [] } }, 'options.terrains: expected functions'],
    [{ maxSubstepsPerFrame: 0 }, 'options.maxSubstepsPerFrame: expected a whole number'],
    [{ smoothing: 0.3 }, 'options.smoothing: expected an object'],
    [{ smoothing: { alongGround: 0.09 } }, 'options.smoothing.alongGround: expected 0.1 to 2 s, got 0.09'],
    [{ smoothing: { alongNormal: 300 } }, 'options.smoothing.alongNormal: expected 0.05 to 2 s'],
    [{ smoothing: { angle: NaN } }, 'options.smoothing.angle: expected 0.1 to 2 s, got NaN'],
    [{ onWarning: 'console' }, 'options.onWarning: expected a function'],
    [{ forcedRollback: -1 }, 'options.forcedRollback'],
    [{ plan: {} }, 'options.plan: expected a list'],
    [
      { plan: [planned(5), planned(4)] },
      'options.plan: expected a list of { tick, substep, controls }, ascending',
    ],
    [{ plan: [{ ...planned(5), controls: { thrustLevel: 1 } }] }, 'options.plan'],
    [
      { defaults: { bodies: [{ ...LUNA, position: { x: 0, y: 0, z: 0 } }] } },
      'options.defaults.bodies: expected',
    ],
    [{ defaults: 'moon' }, 'options.defaults: expected an object'],
    [{ defaults: { terrain: 'mars' } }, 'defaults: terrain'],
    [{ defaults: { settings: { contactCrashSpeed: -1 } } }, 'defaults: settings.contactCrashSpeed'],
  ])('is named in the RangeError: %j', (options, words) => {
    expect(thrown(options)).toThrow(RangeError);
    expect(thrown(options)).toThrow(words);
  });
});

/** Codes in the sources: `warn('code'`, or a naming's `code: '…'`. */
function codesInSources(): string[] {
  const files = readdirSync(ROOM, { recursive: true, encoding: 'utf8' }).filter((file) =>
    file.endsWith('.ts'),
  );
  const sources = files.map((file) => readFileSync(join(ROOM, file), 'utf8')).join('\n');
  const found = [...sources.matchAll(/(?:\bwarn\(\s*|\bcode: )'([a-z-]+)'/g)].map((match) => match[1]!);
  return [...new Set(found)].sort();
}

it('ERRORS.md has each code of the sources, and no other', () => {
  const table = readFileSync(join(ROOM, 'ERRORS.md'), 'utf8');
  const rows = [...table.matchAll(/^\| `([a-z-]+)` +\|/gm)].map((match) => match[1]!);
  const isElsewhere = (code: string) => /^(hud|scene)-/.test(code);
  expect(rows.filter((code) => !isElsewhere(code)).toSorted()).toEqual(codesInSources());
  const checks = ['hud', 'scene'].map((room) => readFileSync(join(ROOM, '..', room, 'checks.ts'), 'utf8'));
  const told = [...checks.join('\n').matchAll(/'((?:hud|scene)-[a-z-]+)'/g)].map((match) => match[1]!);
  expect(rows.filter(isElsewhere).toSorted()).toEqual([...new Set(told)].toSorted());
  expect(rows.length).toBeGreaterThan(30);
});

it('each code has a mistake here that triggers it', () => {
  const tried = new Set(MISTAKES.map(([, code]) => code));
  expect(codesInSources().filter((code) => !tried.has(code))).toEqual([]);
});
