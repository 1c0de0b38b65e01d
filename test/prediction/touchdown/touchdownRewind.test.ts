import { describe, expect, it } from 'vitest';
import {
  CONTACT,
  CRASHED,
  FLYING,
  LANDED,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  VELOCITY,
} from '../../../src/dynamics';
import { keep } from '../../../src/prediction/simulation/rings/history';
import { setTempo } from '../../../src/prediction/time/timeline';
import { LOGGED_STATE, logLiftOff, logState } from '../../../src/prediction/touchdown/touchdownLog';
import { keepLog } from '../../../src/prediction/touchdown/touchdownRing';
import { rewindLog } from '../../../src/prediction/touchdown/touchdownRewind';
import { RATE } from '../decisions/sessionAt';

import { cardWhere, climbAt, falling, inState, logOf, TICK } from './rewinding';

describe('a state on the ground where flight was predicted', () => {
  it('is logged as a touch at the impact speed that the server sends', () => {
    const card = cardWhere(logOf(FLYING), inState(CONTACT, 2.5));
    expect(card).toMatchObject({ known: true, outcome: 'open', verticalSpeed: 2.5, state: CONTACT });
    expect(cardWhere(logOf(FLYING), inState(LANDED, 2.5))).toMatchObject({ known: true, outcome: 'landed' });
  });

  it('has the predicted speed along the ground', () => {
    const card = cardWhere(logOf(FLYING), (row, { track }) => {
      inState(CONTACT, 2.5)(row);
      const predicted = track.history.rows;
      const slot = (TICK % track.history.length) * SHIP_STRIDE;
      climbAt(predicted.subarray(slot, slot + SHIP_STRIDE), -2.5);
      climbAt(row, 0);
    });
    // The body turns below a ship that only falls: ω r at its latitude.
    expect(card.horizontalSpeed).toBeGreaterThan(0.5);
    expect(card.horizontalSpeed).toBeLessThan(10);
  });

  it('leaves no card if the server does not send the speed', () => {
    expect(cardWhere(logOf(FLYING), inState(CONTACT, 0))).toMatchObject({ known: false, state: CONTACT });
  });

  it('is logged as a bounce if a card is open', () => {
    const log = logOf(CONTACT, 3);
    log[LOGGED_STATE] = FLYING;
    expect(cardWhere(log, inState(CONTACT, 1))).toMatchObject({ known: true, verticalSpeed: 3, bounces: 1 });
  });
});

describe('a state in flight where the ground was predicted', () => {
  it.each([
    ['rising', 0.5],
    ['neither rising nor falling', 0],
  ])('%s: the touch stays, and the ship has left', (_, climb) => {
    const earlier = climb > 0 ? logOf(FLYING) : logOf(CONTACT, 3);
    const card = cardWhere(logOf(CONTACT, 3), inState(FLYING, 0, climb), earlier);
    expect(card).toMatchObject({ known: true, verticalSpeed: 3, bounces: 0, state: FLYING });
  });

  it('not rising, in flight a tick ago: it has not touched', () => {
    for (const climb of [-0.5, 0]) {
      const card = cardWhere(logOf(CONTACT, 3), inState(FLYING, 0, climb), logOf(FLYING));
      expect(card).toMatchObject({ known: false, state: FLYING });
    }
  });

  it('falling, on the ground a tick ago or of an unknown past: it has left', () => {
    for (const earlier of [logOf(CONTACT, 3), undefined]) {
      const card = cardWhere(logOf(CONTACT, 3), inState(FLYING, 0, -0.5), earlier);
      expect(card).toMatchObject({ known: true, verticalSpeed: 3, state: FLYING });
    }
  });

  it('begins a hop: the engine may burn twice the time of the parabola', () => {
    const { sim, track } = falling();
    const row = climbAt(track.serverRow.slice(), 0.5);
    const expected = logOf(CONTACT, 3);
    logLiftOff(expected, sim.world, row, 0);
    logState(expected, FLYING);
    keep(track.history, TICK, track.serverRow, 0);
    keepLog(track.log!, TICK, logOf(CONTACT, 3));
    rewindLog(track, sim, { tick: TICK, rows: row, from: 0 });
    expect([...track.log!.replayed]).toEqual([...expected]);
  });
});

it('a state that agrees, and a crash, leave the log unchanged', () => {
  expect(cardWhere(logOf(CONTACT, 3), inState(CONTACT, 9))).toMatchObject({ verticalSpeed: 3, bounces: 0 });
  const crashed = cardWhere(logOf(FLYING), (row) => {
    inState(CONTACT, 2.5)(row);
    row[CRASHED] = 1;
  });
  expect(crashed).toMatchObject({ known: false, state: FLYING });
});

describe('a ship that was moved', () => {
  const touched = () => logOf(CONTACT, 3);
  const moved = (metres: number, more: (all: ReturnType<typeof falling>) => void = () => undefined) =>
    cardWhere(touched(), (row, all) => {
      inState(CONTACT)(row);
      row.fill(0, VELOCITY, VELOCITY + 3);
      row[VELOCITY + 1] = -30;
      // 7 = |(2, −3, 6)|
      for (const [k, part] of [2, -3, 6].entries()) row[POSITION + k]! += (metres * part) / 7;
      more(all);
    }).known;

  it('by more than 100 m has no card', () => {
    expect([moved(99.9), moved(100.1)]).toEqual([true, false]);
  });

  it('may have moved during the server’s silence, at the time scale', () => {
    const silent = ({ track }: ReturnType<typeof falling>) => (track.silence = 2);
    expect([moved(159.9, silent), moved(160.1, silent)]).toEqual([true, false]);
    const fast = (all: ReturnType<typeof falling>) => {
      silent(all);
      setTempo(all.sim.timeline, TICK, { tickRate: RATE, timeScale: 5, paused: false }, null);
    };
    expect([moved(399.9, fast), moved(400.1, fast)]).toEqual([true, false]);
  });

  it('to another body, or anew by the server, has none', () => {
    const elsewhere = cardWhere(touched(), (row) => {
      inState(CONTACT)(row);
      row[REFERENCE_BODY] = 1;
    });
    expect(elsewhere).toMatchObject({ known: false, state: CONTACT });
    const anew = cardWhere(touched(), (row, { track }) => {
      inState(CONTACT)(row);
      track.replaySnaps = true;
    });
    expect(anew).toMatchObject({ known: false, state: CONTACT });
  });
});
