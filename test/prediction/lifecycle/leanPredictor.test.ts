import { describe, expect, it } from 'vitest';
import { BODIES } from '../../../src/dynamics';
import {
  checkedRecords,
  completedBodies,
  createLeanPredictor,
  createPredictor,
  type Feature,
  gameCatalogue,
  groundedGhost,
  inputAcknowledgements,
  learnedGround,
  type LeanOptions,
  type LeanPredictor,
  measuredGameTime,
  measuredTickRate,
  mismatchValues,
  type PredictorEntry,
  roundTripPings,
  serverHello,
  sleepingShips,
  snapshotParts,
  surfaceEvents,
  touchdownRecord,
} from '../../../src/prediction';
import * as everyFeature from '../../../src/prediction/features';
import type { ServerFrame } from '../../../src/wire';
import { LUNA, ship, ticks } from '../checks/mistakes/given';
import { recordFlight } from '../recordFlight';

/** The record without what `hidden` names, at any depth. */
function without(hidden: readonly string[], value: unknown): unknown {
  if (Array.isArray(value)) return value.map((each) => without(hidden, each));
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value)) return value;
  const kept = Object.entries(value).filter(([key]) => !hidden.includes(key));
  return Object.fromEntries(kept.map(([key, each]) => [key, without(hidden, each)]));
}

/** Each view and message of a flight as text; without what `hidden` names. */
function shown(
  predictor: LeanPredictor,
  entries: readonly PredictorEntry[],
  hidden: readonly string[],
): string[] {
  const lines: string[] = [];
  const show = (line: unknown) => JSON.stringify(hidden.length > 0 ? without(hidden, line) : line);
  predictor.onEvent((notice) => lines.push(JSON.stringify(notice)));
  for (const entry of entries) {
    if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
    if (entry.kind !== 'advanced') continue;
    predictor.advance(entry.controls, entry.at);
    const sent = predictor.takeOutgoing().filter((message) => !hidden.includes(message.kind));
    lines.push(show([sent, predictor.view(entry.at)]));
  }
  return lines;
}

const EARTH = BODIES.find(({ name }) => name === 'Earth')!;

const ALL = Object.values(everyFeature).filter((each): each is Feature => 'feature' in each);

/** Not an event. */
const isView = (line: string): boolean => line.startsWith('[');

describe('a lean predictor', () => {
  const { entries, options } = recordFlight({ scenario: 'right-itself', others: 2 });
  const full = (hidden: readonly string[]) => shown(createPredictor(options), entries, hidden);
  const lean = (features: LeanOptions['features'], hidden: readonly string[]) =>
    shown(createLeanPredictor({ ...options, features: features ?? [] }), entries, hidden);

  /** States alone, without events and acknowledgements. */
  const ofGame = entries.flatMap((entry): PredictorEntry[] => {
    if (entry.kind !== 'received') return [entry];
    const { message } = entry;
    return message.kind === 'frame'
      ? [{ ...entry, message: { ...message, events: [], lastInput: null } }]
      : [];
  });

  it('shows and sends the same, bit for bit, from the states of the game’s server', () => {
    const hidden = ['touchdown', 'ping', 'withdrawn', 'lastMismatch'];
    const expected = shown(createPredictor(options), ofGame, hidden).filter(isView);
    expect(expected.some((line) => line.includes('"shownState":"landed"'))).toBe(true);
    const features = [sleepingShips, groundedGhost];
    expect(shown(createLeanPredictor({ ...options, features }), ofGame, hidden)).toEqual(expected);
  });

  it('shows, sends and announces the same with all features from a server that sends everything', () => {
    const expected = full([]);
    expect(lean(ALL, [])).toEqual(expected);
    expect(expected.some((line) => !isView(line))).toBe(true);
    for (const missing of [surfaceEvents, inputAcknowledgements, serverHello, roundTripPings])
      expect(
        lean(
          ALL.filter((feature) => feature !== missing),
          [],
        ),
        missing.feature,
      ).not.toEqual(expected);
  });

  it('predicts the same ships, bit for bit, without features that only save time or place the ghost', () => {
    const counted = ['steppedSubsteps', 'replayedSubsteps', 'ghostPosition', 'ghostAttitude'];
    const hidden = ['touchdown', 'ping', 'withdrawn', 'lastMismatch', ...counted];
    expect(shown(createLeanPredictor(options), ofGame, hidden)).toEqual(
      shown(createPredictor(options), ofGame, hidden).filter(isView),
    );
  });

  it('takes a hello and pongs only with their features', () => {
    const lacking = createLeanPredictor(options);
    for (const kind of ['hello', 'pong'] as const) {
      lacking.receive({ kind } as never, 0);
      expect(lacking.view(0).diagnosis.lastRefusal).toBe(
        `message.kind: expected one that this predictor takes, got ${kind}`,
      );
    }
    expect(lacking.view(0).diagnosis.framesRefused).toBe(2);
  });

  it('knows a touchdown only with that feature', () => {
    const fly = (features: LeanOptions['features']) =>
      shown(createLeanPredictor({ ...options, features: features ?? [] }), ofGame, ['ping']);
    const whole = shown(createPredictor(options), ofGame, ['ping']);
    expect(fly([touchdownRecord, surfaceEvents, mismatchValues, sleepingShips, groundedGhost])).toEqual(
      whole,
    );
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

describe('a lean predictor without a feature', () => {
  const received = (messages: readonly object[], features: readonly Feature[] = []) => {
    const found: string[] = [];
    const onWarning: LeanOptions['onWarning'] = (code, message) => {
      if (code === 'feature-missing') found.push(message);
    };
    const predictor = createLeanPredictor({
      ownShipId: 'a',
      onWarning,
      features: [gameCatalogue, ...features],
    });
    for (const [i, message] of messages.entries()) {
      predictor.receive(message as ServerFrame, i);
      predictor.advance(null, i);
    }
    return { found, predictor };
  };
  const [first, second] = ticks(2) as [ServerFrame, ServerFrame];
  const lastInput = { seq: 1, tick: 0, substep: 0, margin: 0 };
  const event = { type: 'ship.landed', tick: 1, substep: 3, shipId: 'a' };
  const [untimed, rateless] = [
    { ...first, timeScale: undefined },
    { ...first, tickRate: undefined },
  ];

  it.each([
    [surfaceEvents, 'frame.events', [{ ...first, events: [event] }]],
    [inputAcknowledgements, 'frame.lastInput', [{ ...first, lastInput }]],
    [measuredGameTime, 'frame.timeScale', [untimed]],
    [measuredTickRate, 'frame.tickRate', [rateless]],
    [
      completedBodies,
      'frame.bodies',
      [
        { ...first, bodies: [LUNA, EARTH] },
        { ...second, bodies: [EARTH, LUNA] },
      ],
    ],
    [snapshotParts, 'frame.ships', [first, { ...first, ships: [{ ...ship, shipId: 'b' }] }]],
  ])('warns of what the server sends that needs it: %j', (feature, of, messages) => {
    const { found } = received([...messages, ...messages]);
    expect(found).toHaveLength(1);
    expect(found[0]).toContain(of);
    expect(found[0]).toContain(`needs the feature ${feature.feature} of`);
    expect(received(messages, [feature]).found).toEqual([]);
  });

  it('warns of a listener that is never called', () => {
    const { found, predictor } = received([first]);
    expect(found).toEqual([]);
    predictor.onEvent(() => undefined);
    predictor.receive(second, 1);
    expect(found.join()).toMatch(/^onEvent needs the feature surfaceEvents/);
  });

  it('extrapolates bodies in another order, and takes ships of other messages only with the feature', () => {
    const [a, b] = [
      { ...first, bodies: [LUNA, EARTH] },
      { ...second, bodies: [EARTH, LUNA] },
    ];
    const places = ({ predictor }: ReturnType<typeof received>) =>
      predictor.view(2).bodies.map(({ name }) => name);
    expect(places(received([a, b]))).toEqual(['Luna', 'Earth']);
    const part = { ...first, ships: [{ ...ship, shipId: 'b' }] };
    const ids = ({ predictor }: ReturnType<typeof received>) =>
      predictor.view(2).ships.map(({ shipId }) => shipId);
    expect(ids(received([first, part]))).toEqual(['a']);
    expect(ids(received([first, part], [snapshotParts]))).toEqual(['a', 'b']);
  });

  it('names the field of a mismatch, with both values only with the feature', () => {
    const moved = { ...second, ships: [{ ...ship, velocity: [0, 0, 0] }] };
    const mismatch = (features: readonly Feature[]) =>
      received([first, moved], [...features, sleepingShips]).predictor.view(2).diagnosis.lastMismatch;
    expect(mismatch([])).toBe('a at tick 2: velocity');
    expect(mismatch([mismatchValues])).toMatch(/^a at tick 2: velocity: server \[.*\], predicted \[/);
  });

  it('refuses a ship that no decoder made only with the feature', () => {
    const broken = { ...first, ships: [ship, { ...ship, shipId: 'b', position: [1] }] };
    const { predictor } = received([broken], [checkedRecords]);
    expect(predictor.view(1).diagnosis.lastRefusal).toMatch(
      /^frame\.ships \(b\): position: expected a list of 3/,
    );
  });
});
