import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS, SHIP_STRIDE } from '../../../src/dynamics';
import { store } from '../../../src/prediction/inputs/inputs';
import { changeOwnShip, dropShip, expectTeleport, resetSession } from '../../../src/prediction/ownership';
import { has, keep } from '../../../src/prediction/simulation/rings/history';
import { createServerStates } from '../../../src/prediction/simulation/rings/serverStates';
import type { Mode } from '../../../src/prediction/simulation/track';
import { createTouchdownRing } from '../../../src/prediction/touchdown/touchdownRing';
import { sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;

/** A pilot's ship with an input and keys held, beside another one. */
function flown(mode: Mode = 'stepping') {
  const session = sessionAt(TICK);
  const { sim, pilot } = session;
  const track = shipAt(sim, 'own', 'landed');
  const other = shipAt(sim, 'other', 'landed', 10);
  Object.assign(track, { own: true, mode, log: createTouchdownRing(track.history.length) });
  sim.fleet.own = track;
  store(sim.inputs, NEUTRAL_CONTROLS, { tick: TICK, substep: 0 }, 0, 0);
  Object.assign(pilot, { last: NEUTRAL_CONTROLS, released: NEUTRAL_CONTROLS });
  // What was predicted differs from what the server sent.
  sim.fleet.front.fill(7, track.at, track.at + SHIP_STRIDE);
  sim.fleet.previous.fill(7, track.at, track.at + SHIP_STRIDE);
  return { ...session, session, track, other };
}

describe('a change of the player’s ship', () => {
  it('drops the inputs of the previous ship', () => {
    const { session, sim, pilot, receiver, track, other } = flown();
    changeOwnShip(session, 'other');
    expect([sim.inputs.records.length, pilot.last, pilot.released]).toEqual([0, null, null]);
    expect(receiver.ownShipId).toBe('other');
    expect(sim.fleet.own).toBe(other);
    expect([track.own, track.log, other.own]).toEqual([false, null, true]);
  });

  it('to the same ship changes nothing', () => {
    const { session, sim, pilot, track } = flown();
    changeOwnShip(session, 'own');
    expect([sim.inputs.records.length, pilot.last, track.own]).toEqual([1, NEUTRAL_CONTROLS, true]);
  });

  it('to a ship that is not present, or to none, is accepted', () => {
    for (const shipId of ['unseen', '']) {
      const { session, sim, track } = flown();
      changeOwnShip(session, shipId);
      expect([sim.fleet.own, track.own]).toEqual([null, false]);
    }
  });

  it.each<[Mode, number, boolean, boolean]>([
    ['stepping', TICK, true, false],
    ['waiting', TICK, true, false],
    ['sleeping', TICK, false, true],
    ['held', TICK, false, false],
    ['stepping', -1, false, false],
  ])(
    'returns the one before, %s since tick %i, to the server’s state',
    (mode, serverTick, replays, rests) => {
      const { session, sim, track } = flown(mode);
      track.serverTick = serverTick;
      changeOwnShip(session, '');
      expect([track.replaying, track.mode]).toEqual([replays, mode]);
      for (const rows of [sim.fleet.front, sim.fleet.previous])
        expect([...rows.subarray(track.at, track.at + SHIP_STRIDE)]).toEqual(
          rests ? [...track.serverRow] : Array<number>(SHIP_STRIDE).fill(7),
        );
      if (replays)
        expect([...sim.fleet.replayed.subarray(track.at, track.at + SHIP_STRIDE)]).toEqual([
          ...track.serverRow,
        ]);
    },
  );
});

describe('a removed ship', () => {
  it('disappears at once, with its inputs', () => {
    const { session, sim, receiver } = flown();
    dropShip(session, 'own', 'gone');
    expect([sim.fleet.byId.has('own'), sim.fleet.own, sim.inputs.records.length]).toEqual([false, null, 0]);
    expect(receiver.removed.get('own')).toBe(TICK);
  });

  it('of another player does not affect the inputs', () => {
    const { session, sim } = flown();
    dropShip(session, 'other', 'docked');
    expect([sim.fleet.tracks.length, sim.inputs.records.length]).toEqual([1, 1]);
  });

  it('stays removed if it was not present', () => {
    const { session, sim, receiver } = flown();
    dropShip(session, 'unseen', 'gone');
    expect([sim.fleet.tracks.length, receiver.removed.get('unseen')]).toEqual([2, TICK]);
  });

  it.each([
    ['destroyed', 1],
    ['docked', 0],
    ['gone', 0],
  ] as const)('as %s causes %i events', (reason, count) => {
    const { session, sim } = flown();
    dropShip(session, 'own', reason);
    expect(sim.notices.filter(({ type }) => type === 'ship.destroyed')).toHaveLength(count);
  });
});

describe('a teleported ship', () => {
  it('loses its history and shows its next state at once', () => {
    const { session, sim, track } = flown();
    keep(track.history, TICK, sim.fleet.front, track.at);
    track.states = createServerStates();
    expectTeleport(session, 'own');
    expect([has(track.history, TICK), track.states, track.replaySnaps]).toEqual([false, null, true]);
  });

  it('wakes up', () => {
    const { session, track } = flown('sleeping');
    expectTeleport(session, 'own');
    expect([track.mode, track.picture.hasHeld]).toEqual(['waiting', true]);
  });

  it('need not be present', () => {
    const { session, track } = flown();
    expectTeleport(session, 'unseen');
    expect(track.replaySnaps).toBe(false);
  });
});

it('a reset clears ships, time, inputs, pings and undecoded frames, and keeps the player’s ship', () => {
  const { session, pilot, pings, receiver } = flown();
  session.pending = { queue: [] } as never;
  session.advancedAt = 5;
  pings.sentAt[1] = 5;
  resetSession(session);
  expect(session.sim.fleet.tracks).toEqual([]);
  expect([session.sim.newestTick, session.sim.inputs.records.length]).toEqual([-1, 0]);
  expect([session.pending, pilot.last, pilot.released, receiver.ownShipId]).toEqual([
    null,
    null,
    null,
    'own',
  ]);
  expect([session.advancedAt, pings.sentAt[1]]).toEqual([Number.NaN, Number.NaN]);
});
