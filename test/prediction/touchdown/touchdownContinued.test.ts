import { describe, expect, it } from 'vitest';
import { CONTACT, FLYING, IMPACT_SPEED, LANDED, POSITION, SURFACE_STATE } from '../../../src/dynamics';
import { keep } from '../../../src/prediction/simulation/rings/history';
import { sleepIfAtRest } from '../../../src/prediction/simulation/sleep';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { beginLog, LOGGED_STATE } from '../../../src/prediction/touchdown/touchdownLog';
import { keepLog } from '../../../src/prediction/touchdown/touchdownRing';
import { rewindLog } from '../../../src/prediction/touchdown/touchdownRewind';

import { cardAfter, FALL, fallen, falling, logOf, TICK } from './rewinding';

describe('a state beyond the simulation', () => {
  it('continues the log of a ship in step from the front', () => {
    const { sim, track, ring } = falling();
    const row = fallen(sim, track, FALL);
    expect(row[SURFACE_STATE]).not.toBe(FLYING);
    const card = cardAfter(sim, track, row, TICK + FALL);
    expect(card.known).toBe(true);
    // v² = v₀² + 2 g h
    expect(card.verticalSpeed).toBeCloseTo(Math.sqrt(2.5 ** 2 + 2 * 1.62 * 6), 1);
    expect(ring.front[LOGGED_STATE]).toBe(FLYING);
  });

  it('continues the log of a ship in a replay from there', () => {
    const { sim, track, ring } = falling();
    const half = fallen(sim, track, 5);
    sim.fleet.replayed.set(half, track.at);
    // The front is a state on the ground, which must not be read.
    sim.fleet.front[track.at + SURFACE_STATE] = LANDED;
    Object.assign(track, { replaying: true, replayTick: TICK + 5, replaySubstep: 0 });
    beginLog(ring.replayed, FLYING);
    const row = fallen(sim, track, FALL);
    const replayed = cardAfter(sim, track, row, TICK + FALL);
    const other = falling();
    expect(replayed).toEqual(cardAfter(other.sim, other.track, row, TICK + FALL));
  });

  it.each<[string, (all: ReturnType<typeof falling>) => void]>([
    ['a front that is stale', ({ sim }) => (sim.frontIsStale = true)],
    ['a ship out of step', ({ track }) => (track.mode = 'waiting')],
    ['a state of the past', ({ sim }) => (sim.front.tick = TICK + FALL + 1)],
  ])('begins anew with %s', (_, prepare) => {
    const all = falling();
    const row = fallen(all.sim, all.track, FALL);
    prepare(all);
    expect(cardAfter(all.sim, all.track, row, TICK + FALL)).toMatchObject({
      known: false,
      state: row[SURFACE_STATE],
    });
  });

  it('is computed over at most 12,000 substeps', () => {
    for (const [ticks, known] of [
      [1200, true],
      [1201, false],
    ] as const) {
      const { sim, track } = falling();
      expect(cardAfter(sim, track, fallen(sim, track, ticks), TICK + ticks).known).toBe(known);
    }
  });
});

describe('a state of a tick that was predicted', () => {
  /** A touch in the tick that ends at `tick`; what was predicted for that tick had none. */
  function touchedWithin() {
    const all = falling();
    const { sim, track, ring } = all;
    let ticks = 1;
    while (fallen(sim, track, ticks)[SURFACE_STATE] === FLYING) ticks += 1;
    const tick = TICK + ticks;
    for (const back of [1, 0]) {
      keep(track.history, tick - back, fallen(sim, track, ticks - back), 0);
      keepLog(ring, tick - back, logOf(FLYING));
    }
    sim.front.tick = tick + 3;
    const row = fallen(sim, track, ticks);
    const speed = row[IMPACT_SPEED]!;
    // The server does not send it: only a replay gives it.
    row[IMPACT_SPEED] = 0;
    return { ...all, tick, row, speed };
  }

  it('is logged with the inputs as they are now known, from the tick before', () => {
    const { sim, track, tick, row, speed } = touchedWithin();
    const card = cardAfter(sim, track, row, tick);
    expect(card).toMatchObject({ known: true, outcome: 'open', verticalSpeed: speed, state: CONTACT });
  });

  it.each<[string, (all: ReturnType<typeof touchedWithin>) => void]>([
    ['no log of its tick', ({ ring, tick }) => keepLog(ring, tick + ring.kept.length, logOf(FLYING))],
    [
      'no log of the tick before',
      ({ ring, tick }) => keepLog(ring, tick - 1 + ring.kept.length, logOf(FLYING)),
    ],
    ['no state of its tick', ({ track, tick }) => (track.history.ticks[tick % track.history.length] = -1)],
    [
      'no state of the tick before',
      ({ track, tick }) => (track.history.ticks[(tick - 1) % track.history.length] = -1),
    ],
  ])('is not replayed with %s', (_, forget) => {
    const all = touchedWithin();
    forget(all);
    expect(cardAfter(all.sim, all.track, all.row, all.tick)).toMatchObject({ known: false, state: CONTACT });
  });

  it('at tick 0 has none before it', () => {
    const { sim, track, ring } = falling();
    keep(track.history, 0, track.serverRow, 0);
    keepLog(ring, 0, logOf(CONTACT, 3));
    const row = track.serverRow.slice();
    row[SURFACE_STATE] = CONTACT;
    expect(cardAfter(sim, track, row, 0)).toMatchObject({ known: true, verticalSpeed: 3 });
  });
});

describe('a ship without history', () => {
  const landedAt = (metres: number, front = LANDED, state = LANDED) => {
    const { sim, track, ring } = falling();
    for (const rows of [track.serverRow, sim.fleet.front]) rows[SURFACE_STATE] = LANDED;
    expect(sleepIfAtRest(sim, track, boundaryAt(sim.bodies, sim.timeline, TICK))).toBe(true);
    ring.front.set(logOf(front, 3));
    const row = track.serverRow.slice();
    row[SURFACE_STATE] = state;
    for (const [k, part] of [2, -3, 6].entries()) row[POSITION + k]! += (metres * part) / 7;
    return cardAfter(sim, track, row, TICK);
  };

  it('keeps its card if it still rests in the same place', () => {
    expect(landedAt(0)).toMatchObject({ known: true, verticalSpeed: 3, state: LANDED });
    expect([landedAt(99.9).known, landedAt(100.1).known]).toEqual([true, false]);
  });

  it('has no card if it did not rest, or no longer rests', () => {
    expect(landedAt(0, CONTACT)).toMatchObject({ known: false, state: LANDED });
    expect(landedAt(0, LANDED, CONTACT)).toMatchObject({ known: false, state: CONTACT });
  });

  it('has no log if it is another player’s', () => {
    const { sim, track } = falling();
    Object.assign(track, { own: false, log: null });
    rewindLog(track, sim, { tick: TICK, rows: track.serverRow, from: 0 });
    expect(track.log).toBeNull();
  });

  it('has a log as long as its history if it is the player’s', () => {
    const { sim, track } = falling();
    track.log = null;
    expect(cardAfter(sim, track, track.serverRow, TICK)).toMatchObject({ known: false, state: FLYING });
    expect(track.log!.kept).toHaveLength(track.history.length);
  });
});
