import { describe, expect, it } from 'vitest';
import { BODY_ATTITUDE, CRASHED, IMPACT_SPEED, POSITION } from '../../../../src/dynamics';
import { has } from '../../../../src/prediction/simulation/rings/history';
import { sleepIfAtRest } from '../../../../src/prediction/simulation/sleep';
import { boundaryAt } from '../../../../src/prediction/snapshots/bodies/bodyTrack';

import { corrected, NONE, predicted, type Predicted, TICK } from './predicted';

describe('a state that agrees with the prediction', () => {
  it('is stored, and nothing is replayed', () => {
    const of = predicted();
    expect(of.take()).toBeNull();
    const { track, sim, counters } = of;
    expect(track).toMatchObject({
      ...{ name: 'Eagle', playerId: 'neil', serverTick: TICK, agreedTick: TICK },
      ...{ seenAt: 5, silence: 2, exact: true, replaying: false, unpredictable: false },
    });
    expect(corrected(of)).toEqual(NONE);
    expect([counters.errorPosition, counters.errorAngle]).toEqual([0, 0]);
    expect([...track.serverRow]).toEqual([...of.kept]);
    const attitude = boundaryAt(sim.bodies, sim.timeline, TICK).subarray(BODY_ATTITUDE, BODY_ATTITUDE + 4);
    expect([...track.serverBodyAttitude]).toEqual([...attitude]);
    expect(track.evidence.tick).toBe(TICK);
  });

  it('of another ship does not change the reported error', () => {
    const of = predicted('', { own: false });
    of.counters.errorPosition = 7;
    of.take({ relativePosition: [1, 2, 3] });
    expect(of.counters.errorPosition).toBe(7);
  });

  it('ends an earlier replay and a pending snap', () => {
    for (const [tick, left] of [
      [TICK - 1, false],
      [TICK, true],
      [TICK + 1, true],
    ] as const) {
      const { track, take } = predicted();
      Object.assign(track, { replaying: true, replayTick: tick, replaySubstep: 0, replaySnaps: true });
      take();
      expect([track.replaying, track.replaySnaps], `from tick ${tick}`).toEqual([left, left]);
    }
  });

  it('is simulated again where its body has turned', () => {
    const of = predicted();
    of.context.turned = 1.1e-12;
    of.take();
    expect([of.track.replaying, of.track.agreedTick]).toEqual([true, TICK]);
    expect(corrected(of)).toEqual(NONE);
    const unturned = predicted();
    unturned.context.turned = 0.9e-12;
    unturned.take();
    expect(unturned.track.replaying).toBe(false);
  });

  it('at rest puts the ship to sleep, and leaves it asleep', () => {
    const { sim, track, take } = predicted('landed');
    take();
    expect(track.mode).toBe('sleeping');
    track.serverTick = TICK - 1;
    sim.fleet.front[track.at + IMPACT_SPEED] = 9;
    take();
    expect(track.mode).toBe('sleeping');
  });
});

describe('a state that differs from the prediction', () => {
  const away = (metres: number) => (of: Predicted) =>
    of.sent.relativePosition!.map((x, k) => (k === 1 ? x + metres : x)) as [number, number, number];

  it('is adopted, replayed, and described', () => {
    const of = predicted();
    const { track, counters, sim } = of;
    of.take({ relativePosition: away(4)(of) });
    expect(corrected(of)).toEqual({ ...NONE, mismatch: 1 });
    expect([counters.errorPosition, counters.errorAngle]).toEqual([expect.closeTo(4, 6), 0]);
    expect(counters.lastMismatch).toContain(`own at tick ${TICK}: position: server`);
    expect(track).toMatchObject({ replaying: true, replayTick: TICK, agreedTick: -1 });
    expect(sim.fleet.replayed[track.at + POSITION + 1]).toBe(of.sent.relativePosition![1] + 4);
  });

  it.each([
    ['late', 'late', true],
    ['lost', 'lost', true],
    ['late', 'mismatch', false],
    ['lost', 'mismatch', false],
  ] as const)('counts as an input %s, as %s: by its own pilot %s', (inputs, cause, own) => {
    const of = predicted('', { own });
    of.context.inputs = inputs;
    of.take({ relativePosition: away(4)(of) });
    expect(corrected(of)).toEqual({ ...NONE, [cause]: 1 });
  });

  it('in its command counts as a correction of another pilot', () => {
    const of = predicted('', { own: false });
    of.take({ thrustLevel: 0.7 });
    expect(corrected(of)).toEqual({ ...NONE, other: 1 });
    expect(of.track.replaying).toBe(true);
  });

  it('only in its inputs is corrected too, except asleep', () => {
    for (const inputs of ['late', 'lost'] as const) {
      const of = predicted();
      of.context.inputs = inputs;
      of.take();
      expect(corrected(of)).toEqual({ ...NONE, [inputs]: 1 });
      const asleep = predicted('landed');
      sleepIfAtRest(asleep.sim, asleep.track, asleep.context.bodies);
      asleep.context.inputs = inputs;
      asleep.take();
      expect([corrected(asleep), asleep.track.mode]).toEqual([NONE, 'sleeping']);
    }
    const other = predicted('', { own: false });
    other.context.inputs = 'late';
    other.take();
    expect(corrected(other)).toEqual(NONE);
  });

  it('wakes the ship where it rests elsewhere', () => {
    const of = predicted('landed');
    sleepIfAtRest(of.sim, of.track, of.context.bodies);
    of.take({ relativePosition: away(4)(of) });
    expect([of.track.mode, of.track.replaying, of.track.picture.hasHeld]).toEqual(['waiting', true, true]);
  });

  it('of a wreck that flies again is shown at once', () => {
    for (const [before, after, snaps] of [
      [1, false, true],
      [0, false, false],
      [1, true, false],
    ] as const) {
      const of = predicted();
      of.track.serverRow[CRASHED] = before;
      of.take({ crashed: after, relativePosition: away(4)(of) });
      expect(of.track.replaySnaps).toBe(snaps);
    }
    const unseen = predicted();
    Object.assign(unseen.track, { serverTick: -1 });
    unseen.track.serverRow[CRASHED] = 1;
    unseen.take({ relativePosition: away(4)(unseen) });
    expect([unseen.track.replaySnaps, unseen.track.silence]).toEqual([false, 0]);
  });
});

describe('a state without a prediction', () => {
  it.each<[string, (of: Predicted) => void]>([
    ['no history', ({ track }) => track.history.ticks.fill(-1)],
    ['held', ({ track }) => (track.mode = 'held')],
  ])('%s: is replayed, and no correction', (_, prepare) => {
    const of = predicted();
    prepare(of);
    of.take();
    expect([of.track.replaying, of.track.agreedTick]).toEqual([true, -1]);
    expect(corrected(of)).toEqual(NONE);
    expect(of.counters.errorPosition).toBeNaN();
    expect(has(of.track.history, TICK)).toBe(true);
  });

  it('of a ship first seen at rest puts it to sleep', () => {
    const { track, take } = predicted('landed');
    track.mode = 'waiting';
    track.history.ticks.fill(-1);
    take();
    expect([track.mode, track.replaying]).toEqual(['sleeping', false]);
  });

  it('of a ship that is switched off is not replayed; at rest it sleeps', () => {
    const flying = predicted();
    Object.assign(flying.track, { off: true, mode: 'held' });
    flying.take();
    expect([flying.track.replaying, flying.track.serverTick]).toEqual([false, TICK]);
    const resting = predicted('landed');
    Object.assign(resting.track, { off: true, mode: 'held' });
    resting.take();
    expect([resting.track.mode, resting.track.off]).toEqual(['sleeping', false]);
  });
});
