import { describe, expect, it } from 'vitest';
import { POSITION, SHIP_STRIDE } from '../../../src/dynamics';
import { createShipView } from '../../../src/prediction/drawn/shipView';
import { changePolicy } from '../../../src/prediction/lifecycle/policy';
import { createServerStates } from '../../../src/prediction/simulation/rings/serverStates';
import type { Policy, Track } from '../../../src/prediction/simulation/track';
import { sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;

/** A ship in step, elsewhere than the server has it. */
function stepped(policy: Policy = 'predict', more: Partial<Track> = {}) {
  const session = sessionAt(TICK);
  const { sim } = session;
  const track = shipAt(sim, 'own', 'landed');
  Object.assign(track, { policy, replaying: true, states: createServerStates(), ...more });
  sim.fleet.front[track.at + POSITION]! += 5;
  const rowOf = (rows: Float64Array) => [...rows.subarray(track.at, track.at + SHIP_STRIDE)];
  return { session, sim, track, rowOf, change: (to: unknown) => changePolicy(session, 'own', to as Policy) };
}

describe('a ship that is no longer predicted', () => {
  it('holds its drawn pose, without a replay', () => {
    const { session, track, change } = stepped('predict', { off: true });
    change('interpolate');
    expect(track).toMatchObject({ policy: 'interpolate', mode: 'held', replaying: false, off: false });
    expect([track.states, track.picture.hasHeld]).toEqual([null, true]);
    expect(session.receiver.policies.get('own')).toBe('interpolate');
  });

  it('holds the pose in which it sleeps', () => {
    const { track, change } = stepped('predict', { mode: 'sleeping' });
    track.sleepPlace.set([1, 2, 3]);
    change('hold');
    expect([track.mode, track.picture.hasHeld, [...track.picture.heldPlace]]).toEqual([
      'held',
      true,
      [1, 2, 3],
    ]);
  });

  it('holds no pose if it was not drawn', () => {
    const { track, change } = stepped('predict', { mode: 'waiting' });
    change('hold');
    expect([track.mode, track.picture.hasHeld]).toEqual(['held', false]);
  });
});

describe('a ship that is predicted again', () => {
  it.each([true, false])('is replayed from its server state, and eased if it was drawn: %s', (isSeen) => {
    const { session, sim, track, rowOf, change } = stepped('interpolate', { mode: 'held', replaying: false });
    session.receiver.policies.set('own', 'interpolate');
    if (isSeen) track.picture.view = createShipView(track, sim.world);
    change('predict');
    expect(session.receiver.policies.has('own')).toBe(false);
    expect(track).toMatchObject({ policy: 'predict', replaying: true, replayTick: TICK, mode: 'waiting' });
    expect([track.picture.hasHeld, track.picture.skipped, track.states]).toEqual([isSeen, 2, null]);
    for (const rows of [sim.fleet.front, sim.fleet.previous, sim.fleet.replayed])
      expect(rowOf(rows)).toEqual([...track.serverRow]);
  });

  it.each([{ unpredictable: true }, { serverTick: -1 }])(
    'stays as it is if it cannot be predicted: %o',
    (more) => {
      const { track, change } = stepped('hold', { mode: 'held', replaying: false, ...more });
      change('predict');
      expect([track.policy, track.replaying]).toEqual(['predict', false]);
    },
  );

  it('is predicted from the first tick too', () => {
    const { track, change } = stepped('hold', { mode: 'held', replaying: false, serverTick: 0 });
    change('predict');
    expect(track.replaying).toBe(true);
  });
});

describe('a policy', () => {
  it('changes between interpolated and held', () => {
    const { track, change } = stepped('interpolate', { mode: 'held' });
    change('hold');
    expect([track.policy, track.states, track.replaying]).toEqual(['hold', null, true]);
  });

  it('changes nothing if it is the same', () => {
    const { track, change } = stepped();
    change('predict');
    expect([track.states === null, track.replaying]).toEqual([false, true]);
  });

  it('is ignored if it does not exist', () => {
    const { session, track, change } = stepped();
    change('fade');
    expect([track.policy, session.receiver.policies.size]).toEqual(['predict', 0]);
  });

  it('is kept for a ship that is not present yet', () => {
    const { session } = stepped();
    changePolicy(session, 'unseen', 'hold');
    expect(session.receiver.policies.get('unseen')).toBe('hold');
  });
});
