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
import { differenceOfFlights, type Moment, momentsOf } from './sameFlight';

const EARTH = BODIES.find(({ name }) => name === 'Earth')!;

const ALL = Object.values(everyFeature).filter((each): each is Feature => 'feature' in each);

/** Fields and messages that features which a predictor may lack fill. */
const FILLED = ['touchdown', 'ping', 'withdrawn', 'lastMismatch'];

describe('a lean predictor', () => {
  const { entries, options } = recordFlight({ scenario: 'right-itself', others: 2 });

  /** States alone, without events and acknowledgements. */
  const ofGame = entries.flatMap((entry): PredictorEntry[] => {
    if (entry.kind !== 'received') return [entry];
    const { message } = entry;
    return message.kind === 'frame'
      ? [{ ...entry, message: { ...message, events: [], lastInput: null } }]
      : [];
  });

  const whole = (flown = entries) => momentsOf(createPredictor(options), flown);
  const lean = (features: LeanOptions['features'], flown = entries) =>
    momentsOf(createLeanPredictor({ ...options, features: features ?? [] }), flown);
  /** The whole predictor's from the states of the game's server; what it announces needs a feature. */
  function* silently(): Generator<Moment, void> {
    for (const moment of whole(ofGame)) yield { ...moment, notices: [] };
  }

  it('is compared over a flight that ends landed, with events', () => {
    let [frames, announced] = [0, 0];
    const states = new Set<string>();
    for (const { view, notices } of whole()) {
      frames += 1;
      announced += notices.length;
      states.add(view.own?.shownState ?? '');
    }
    expect(frames).toBeGreaterThan(800);
    expect(announced).toBeGreaterThan(1);
    expect([...states].at(-1)).toBe('landed');
  });

  it('shows and sends the same, bit for bit, from the states of the game’s server', () => {
    expect(differenceOfFlights(lean([sleepingShips, groundedGhost], ofGame), silently(), FILLED)).toBe('');
  });

  it('shows, sends and announces the same with all features from a server that sends everything', () => {
    expect(differenceOfFlights(lean(ALL), whole())).toBe('');
    for (const missing of [surfaceEvents, inputAcknowledgements, serverHello, roundTripPings]) {
      const others = ALL.filter((feature) => feature !== missing);
      expect(differenceOfFlights(lean(others), whole()), missing.feature).not.toBe('');
    }
  });

  it('predicts the same ships, bit for bit, without features that only save time or place the ghost', () => {
    const counted = ['steppedSubsteps', 'replayedSubsteps', 'ghostPosition', 'ghostAttitude'];
    expect(differenceOfFlights(lean([], ofGame), silently(), [...FILLED, ...counted])).toBe('');
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

  it('has a touchdown record only with that feature', () => {
    const features = [touchdownRecord, surfaceEvents, mismatchValues, sleepingShips, groundedGhost];
    expect(differenceOfFlights(lean(features, ofGame), whole(ofGame), ['ping'])).toBe('');
    const knowsOne = (flight: Iterable<Moment>) => {
      for (const { view } of flight) if (view.ships.some(({ touchdown }) => touchdown.known)) return true;
      return false;
    };
    expect(knowsOne(whole(ofGame))).toBe(true);
    expect(knowsOne(lean([], ofGame))).toBe(false);
  });

  it('follows ground that the client does not know only with that feature', () => {
    const lower = { ...options, terrains: { ...options.terrains, low: () => -3 } };
    const given = { ...lower, defaults: { ...lower.defaults, terrain: 'low' } };
    const learned = (features: readonly Feature[]) => {
      let most = 0;
      for (const { view } of momentsOf(createLeanPredictor({ ...given, features }), ofGame))
        for (const offset of [view.diagnosis.groundOffset, ...view.ships.map((one) => one.groundOffset)])
          most = Math.max(most, Math.abs(offset));
      return most;
    };
    expect(learned([])).toBe(0);
    expect(learned([learnedGround])).toBeGreaterThan(1);
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
