import { describe, expect, it } from 'vitest';
import {
  createLeanPredictor,
  createPredictor,
  learnedGround,
  type LeanOptions,
  type LeanPredictor,
  type PredictorEntry,
  type PredictorOptions,
  recordPredictor,
  touchdownRecord,
} from '../../../src/prediction';
import { createRig, type RigOptions } from '../rig';

/** s: until every scenario used here stands. */
const SECONDS = 14;

function record(options: RigOptions): { entries: readonly PredictorEntry[]; options: PredictorOptions } {
  const entries: PredictorEntry[] = [];
  const rig = createRig(options);
  rig.predictor = recordPredictor(rig.predictor, (entry) => entries.push(entry));
  rig.fly(SECONDS);
  const { scenario, terrainHeight, body, shipClass } = rig.loaded;
  const defaults = { bodies: [body], shipClasses: [shipClass], terrain: scenario.terrain };
  return {
    entries,
    options: { ownShipId: 'ship-1', terrains: { [scenario.terrain]: terrainHeight }, defaults },
  };
}

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
    lines.push(JSON.stringify([predictor.takeOutgoing(), predictor.view(entry.at)], hide));
  }
  return lines;
}

describe('a lean predictor', () => {
  const { entries, options } = record({ scenario: 'right-itself', others: 2 });
  const full = (hidden: readonly string[]) => shown(createPredictor(options), entries, hidden);
  const lean = (features: LeanOptions['features'], hidden: readonly string[]) =>
    shown(createLeanPredictor({ ...options, features: features ?? [] }), entries, hidden);

  it('shows and sends the same, bit for bit, where the server says what it simulates', () => {
    const expected = full(['touchdown']);
    expect(expected.some((line) => line.includes('"shownState":"landed"'))).toBe(true);
    expect(lean([], ['touchdown'])).toEqual(expected);
  });

  it('knows a touchdown only with that feature', () => {
    expect(lean([touchdownRecord], [])).toEqual(full([]));
    expect(lean([], []).join()).not.toContain('"known":true');
  });

  it('follows ground that the client does not know only with that feature', () => {
    const lower = { ...options, terrains: { ...options.terrains, low: () => -3 } };
    const given = { ...lower, defaults: { ...lower.defaults, terrain: 'low' } };
    const withoutHello = entries.filter(
      (entry) => entry.kind !== 'received' || entry.message.kind !== 'hello',
    );
    const offsets = (features: LeanOptions['features']) =>
      shown(createLeanPredictor({ ...given, features: features ?? [] }), withoutHello, []).join();
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
