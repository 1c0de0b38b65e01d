import { Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import {
  createBestRuns,
  raceQuery,
  readRace,
  verifyRun,
} from '../../../../src/playground/game/mission/bestRuns';
import { createGhostFlight } from '../../../../src/playground/game/mission/ghost';
import { createMissionTracker, gameSeconds } from '../../../../src/playground/game/mission/missionTracker';
import { createSession } from '../../../../src/playground/server/session';
import { createPredictor } from '../../../../src/prediction';
import {
  LESSONS,
  type Mission,
  MISSIONS,
  NETWORK_PRESETS,
  type RunInput,
  TRACK_RATE,
  TRACK_STRIDE,
} from '../../../../src/scenarios';
import { decodeServerMessage, encodeClientMessage } from '../../../../src/wire';
import { makeView } from '../../../readout/views';
import { pilot } from './missionPilot';

/** Frames a second, and frames between two inputs of the pilot. */
const FPS = 10;
const EVERY = 2;

/** Flies a mission through server, network and predictor until it is done or `limit` seconds have passed. */
function fly(mission: Mission, limit: number, flies = true) {
  const session = createSession();
  const predictor = createPredictor({ ownShipId: 'own' });
  const tracker = createMissionTracker();
  tracker.begin(mission);
  const { name } = mission.scenario;
  const load = {
    scenario: name,
    body: '',
    shipClass: '',
    terrain: '',
    legacy: false,
    tickRate: 1,
    timeScale: 1,
  };
  const reason = session.operate(
    { kind: 'load', ...load, network: NETWORK_PRESETS.broadband, seed: 1, others: 0 },
    0,
  );
  expect(reason).toBeNull();
  let controls = NEUTRAL_CONTROLS;
  const phases: string[] = [];
  let highest = 0;
  for (let n = 0; n < limit * FPS && !['done', 'crashed'].includes(tracker.phase()); n++) {
    const at = n / FPS;
    for (const { bytes } of session.run(at)) {
      const decoded = decodeServerMessage(bytes);
      if (decoded.ok) predictor.receive(decoded.value, at);
    }
    predictor.advance(flies ? controls : null, at);
    const view = predictor.view(at);
    tracker.watch(view);
    highest = Math.max(highest, view.own?.feetHeight ?? 0);
    if (phases.at(-1) !== tracker.phase()) phases.push(tracker.phase());
    const target = tracker.target();
    if (target !== null && n % EVERY === 0) controls = pilot(view, target, mission);
    for (const message of predictor.takeOutgoing()) session.send(encodeClientMessage(message), at);
  }
  return { phase: tracker.phase(), phases, inputs: session.applied(), off: tracker.off(), highest };
}

const flown = new Map<Mission, ReturnType<typeof fly>>();
function flight(mission: Mission) {
  const known = flown.get(mission) ?? fly(mission, 500);
  flown.set(mission, known);
  return known;
}

/** Every score is the sum of its lines, each with its rule, and a link carries the same flight. */
function expectProof(mission: Mission, inputs: readonly RunInput[], off: number): void {
  const run = verifyRun(mission, inputs)!;
  expect(run.outcome).toMatchObject({ outcome: 'landed', padsReached: mission.pads.length });
  if (mission.pads.length === 1) expect(run.outcome.distance).toBeCloseTo(off, 2);
  expect(run.score.total).toBeGreaterThan(300);
  expect(run.score.total).toBe(run.score.lines.reduce((sum, { points }) => sum + points, 0));
  for (const { rule, measured } of run.score.lines)
    expect([rule, measured].every((text) => text !== '')).toBe(true);
  expect(run.outcome.track.length).toBeGreaterThan(100);
  const raced = readRace(new URLSearchParams(raceQuery(run, 'Ann')));
  if (raced === null || typeof raced === 'string') throw new Error(raced ?? 'no race');
  expect(raced.by).toBe('Ann');
  expect(raced.outcome).toEqual(run.outcome);
  expect(raced.score).toEqual(run.score);
}

describe('a mission flown by a pilot who sees only the displays', () => {
  it.each(MISSIONS.map((mission) => [mission.scenario.name, mission] as const))(
    '%s is won, its score is explained, and its race link proves it',
    { timeout: 120_000 },
    (_, mission) => {
      const { phase, inputs, off } = flight(mission);
      expect(phase).toBe('done');
      expectProof(mission, inputs, off);
    },
  );

  it('is kept while it is the best, and raced by a ship that flies it again', () => {
    const mission = MISSIONS[0]!;
    const run = verifyRun(mission, flight(mission).inputs)!;
    const scored = (more: number, outcome = run.outcome.outcome) => ({
      ...run,
      outcome: { ...run.outcome, outcome },
      score: { ...run.score, total: run.score.total + more },
    });
    const kept = new Map<string, string>();
    const store = {
      getItem: (name: string) => kept.get(name) ?? null,
      setItem: (name: string, text: string) => void kept.set(name, text),
    } as Storage;
    const best = createBestRuns(store);
    expect(best.of(mission)).toBeNull();
    expect([scored(1, 'crashed'), scored(-1), scored(-1), run].map(best.keep)).toEqual([
      ...[false, true, false, true],
    ]);
    expect(best.of(mission)).toBe(run);
    expect(createBestRuns(store).of(mission)).toEqual(run);
    expect(createBestRuns(store).keep(run)).toBe(false);
    const forbidden = new Proxy({} as Storage, {
      get: () => () => {
        throw new Error('forbidden');
      },
    });
    const unkept = createBestRuns(forbidden);
    expect([unkept.of(mission), unkept.keep(run), unkept.of(mission)]).toEqual([null, true, run]);

    const view = makeView({ body: 'Luna' });
    const turned = new Quaternion(0.1, -0.2, 0.3, 0.9).normalize();
    Object.assign(view.bodies[view.own.body]!, { attitude: turned.toArray() });
    const racer = createGhostFlight();
    expect(racer.join(view)).toBe(view);
    racer.race(run);
    const at = 3.25 / TRACK_RATE - gameSeconds({ ...view, tick: 0, sinceTick: 0 });
    const ship = racer.join({ ...view, tick: 0, sinceTick: at }).ships.at(-1)!;
    const [from, to] = [3, 4].map((row) =>
      run.outcome.track.slice(row * TRACK_STRIDE, (row + 1) * TRACK_STRIDE),
    );
    const between = Array.from(from!, (value, k) => value * 0.75 + to![k]! * 0.25);
    const place = new Vector3(...between.slice(0, 3)).applyQuaternion(turned);
    expect(place.distanceTo(new Vector3(...ship.meshPosition))).toBeLessThan(1e-6);
    const attitude = turned.clone().multiply(new Quaternion(...between.slice(3, 7)).normalize());
    expect(attitude.angleTo(new Quaternion(...ship.meshAttitude))).toBeLessThan(1e-6);
    expect(Math.hypot(...ship.meshAttitude)).toBeCloseTo(1, 12);
    expect([ship.name, ship.own, ship.body]).toEqual(['Your best', false, view.own.body]);
    // A server may list its bodies in another order.
    const [first, second] = view.bodies;
    const swapped = { ...view, bodies: [second!, first!], own: { ...view.own, body: 1 - view.own.body } };
    expect(racer.join(swapped).ships.at(-1)!.body).toBe(swapped.own.body);
    racer.race(null);
    expect(racer.join(view)).toBe(view);
  });

  it.each(LESSONS.map((mission) => [mission.scenario.name, mission] as const))(
    'lesson %s can be completed',
    { timeout: 120_000 },
    (_, mission) => {
      expect(fly(mission, 300).phase).toBe('done');
    },
  );

  it.each(LESSONS.map((mission) => [mission.scenario.name, mission] as const))(
    'lesson %s neither ends nor climbs away in half a minute from a pilot who does nothing',
    (_, mission) => {
      const { phase, highest } = fly(mission, 30, false);
      expect(phase).not.toBe('done');
      expect(highest).toBeLessThan(mission.scenario.initial.height + 3);
    },
  );
});
