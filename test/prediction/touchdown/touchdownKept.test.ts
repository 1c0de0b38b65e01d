import { expect, it } from 'vitest';
import { FLYING, LANDED, SURFACE_STATE } from '../../../src/dynamics';
import { stepFront } from '../../../src/prediction/simulation/front';
import { offsetOf } from '../../../src/prediction/simulation/rings/history';
import { runReplays, startReplay } from '../../../src/prediction/simulation/replay';
import { sleepIfAtRest, wake } from '../../../src/prediction/simulation/sleep';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { beginLog, createTouchdownView, fillTouchdown } from '../../../src/prediction/touchdown/touchdownLog';
import { logAt } from '../../../src/prediction/touchdown/touchdownRing';
import { FALL, falling, TICK } from './rewinding';

/** At each boundary from TICK + 1 on: whether the log kept there has a touch (null: none kept), and whether there was one by then. */
function touches({ ring, track }: ReturnType<typeof falling>) {
  const card = createTouchdownView();
  let hasTouched = false;
  return Array.from({ length: FALL }, (_, n) => {
    const tick = TICK + 1 + n;
    const log = logAt(ring, tick);
    if (log !== null) fillTouchdown(card, log, true);
    hasTouched ||= track.history.rows[offsetOf(track.history, tick) + SURFACE_STATE] !== FLYING;
    return { known: log === null ? null : card.known, hasTouched };
  });
}

function expectTouchKept(all: ReturnType<typeof falling>): void {
  const found = touches(all);
  expect(found.map(({ known }) => known)).toEqual(found.map(({ hasTouched }) => hasTouched));
  expect([found[0]!.known, found.at(-1)!.known]).toEqual([false, true]);
}

it('the front keeps a log with each boundary that it steps over', () => {
  const all = falling();
  beginLog(all.ring.front, FLYING);
  stepFront(all.sim, { tick: TICK + FALL, substep: 0 });
  expectTouchKept(all);
});

it('a replay keeps the log of each boundary anew', () => {
  const all = falling();
  const { sim, track } = all;
  sim.front.tick = TICK + FALL;
  startReplay(track, sim, TICK, track.serverRow, 0);
  beginLog(all.ring.replayed, FLYING);
  runReplays(sim, 100_000);
  expectTouchKept(all);
});

it('a ship that wakes has its log at each boundary since its server state', () => {
  const { sim, track, ring } = falling();
  beginLog(ring.front, LANDED);
  sleepIfAtRest(sim, track, boundaryAt(sim.bodies, sim.timeline, TICK));
  sim.front.tick = TICK + 3;
  track.mode = 'sleeping';
  wake(sim, track);
  const kept = [0, 1, 2, 3, 4].map((n) => logAt(ring, TICK + n));
  expect(kept).toEqual([...Array.from({ length: 4 }, () => ring.front), null]);
});
