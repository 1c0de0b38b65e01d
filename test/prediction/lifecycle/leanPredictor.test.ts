import { describe, expect, it } from 'vitest';
import {
  createLeanPredictor,
  createPredictor,
  learnedGround,
  type LeanOptions,
  type LeanPredictor,
  type PredictorEntry,
  roundTripPings,
  serverHello,
  touchdownRecord,
} from '../../../src/prediction';
import { recordFlight } from '../recordFlight';

/** Each view and message of a flight as text; without what `hidden` names. */
function shown(
  predictor: LeanPredictor,
  entries: readonly PredictorEntry[],
  hidden: readonly string[],
): string[] {
  const lines: string[] = [];
  const hide = (key: string, value: unknown) => (hidden.includes(key) ? undefined : value);
  predictor.onEvent((notice) => lines.push(JSON.stringify(notice)));
  for (const entry of entries) {
    if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
    if (entry.kind !== 'advanced') continue;
    predictor.advance(entry.controls, entry.at);
    const sent = predictor.takeOutgoing().filter((message) => !hidden.includes(message.kind));
    lines.push(JSON.stringify([sent, predictor.view(entry.at)], hide));
  }
  return lines;
}

describe('a lean predictor', () => {
  const { entries, options } = recordFlight({ scenario: 'right-itself', others: 2 });
  const full = (hidden: readonly string[]) => shown(createPredictor(options), entries, hidden);
  const lean = (features: LeanOptions['features'], hidden: readonly string[]) =>
    shown(createLeanPredictor({ ...options, features: features ?? [] }), entries, hidden);

  const ofGame = entries.filter((entry) => entry.kind !== 'received' || entry.message.kind === 'frame');

  it('shows and sends the same, bit for bit, from the states of the game’s server', () => {
    const hidden = ['touchdown', 'ping'];
    const expected = shown(createPredictor(options), ofGame, hidden);
    expect(expected.some((line) => line.includes('"shownState":"landed"'))).toBe(true);
    expect(shown(createLeanPredictor(options), ofGame, hidden)).toEqual(expected);
  });

  it('takes a hello and pongs only with their features', () => {
    const whole = [serverHello, roundTripPings];
    expect(lean(whole, ['touchdown'])).toEqual(full(['touchdown']));
    expect(lean([serverHello], ['touchdown'])).not.toEqual(full(['touchdown']));
    const lacking = createLeanPredictor(options);
    for (const kind of ['hello', 'pong'] as const) {
      lacking.receive({ kind } as never, 0);
      expect(lacking.view(0).diagnosis.lastRefusal).toBe(
        `message.kind: a lean predictor takes a ${kind} only with its feature`,
      );
    }
    expect(lacking.view(0).diagnosis.framesRefused).toBe(2);
  });

  it('knows a touchdown only with that feature', () => {
    const fly = (features: LeanOptions['features']) =>
      shown(createLeanPredictor({ ...options, features: features ?? [] }), ofGame, ['ping']);
    expect(fly([touchdownRecord])).toEqual(shown(createPredictor(options), ofGame, ['ping']));
    expect(fly([]).join()).not.toContain('"known":true');
  });

  it('follows ground that the client does not know only with that feature', () => {
    const lower = { ...options, terrains: { ...options.terrains, low: () => -3 } };
    const given = { ...lower, defaults: { ...lower.defaults, terrain: 'low' } };
    const offsets = (features: LeanOptions['features']) =>
      shown(createLeanPredictor({ ...given, features: features ?? [] }), ofGame, []).join();
    expect(offsets([])).not.toMatch(/"groundOffset":[^0]/);
    expect(offsets([learnedGround])).toMatch(/"groundOffset":[^0]/);
  });

  it('names an invalid feature', () => {
    const wrong = { features: learnedGround } as unknown as LeanOptions;
    expect(() => createLeanPredictor(wrong)).toThrow(/^options\.features: expected a list of features/);
    const inner = { features: [() => 1] } as unknown as LeanOptions;
    expect(() => createLeanPredictor(inner)).toThrow(/^options\.features/);
  });
});
