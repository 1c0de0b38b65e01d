import { describe, expect, it } from 'vitest';
import { SHIP_STRIDE } from '../../../../src/dynamics';
import { keep } from '../../../../src/prediction/simulation/rings/history';
import type { Track } from '../../../../src/prediction/simulation/track';
import { reconcileStates } from '../../../../src/prediction/snapshots/reconcile/reconcileStates';
import { frameAt } from '../../faults/restingShip';
import { RATE, sessionAt, shipAt } from '../../decisions/sessionAt';

const TICK = 100;

/** Where the replay of a ship begins, and its row, after a frame without that ship; null if none does. */
function replayOf(change: (track: Track) => void) {
  const { sim, receiver } = sessionAt(TICK);
  const track = shipAt(sim, 'other', '', 7);
  Object.assign(track, { mode: 'waiting', serverTick: TICK - 3 });
  change(track);
  reconcileStates(sim, receiver, frameAt(TICK, RATE, { ships: [] }), 0);
  if (!track.replaying) return null;
  return { tick: track.replayTick, row: [...sim.fleet.replayed.subarray(track.at, track.at + SHIP_STRIDE)] };
}

describe('a ship out of step that a frame lacks', () => {
  const predicted = new Float64Array(SHIP_STRIDE).map((_, i) => 1 + i);

  it('is replayed from its last server state, or from its prediction for the frame', () => {
    let server: number[] = [];
    expect(replayOf(({ serverRow }) => (server = [...serverRow]))).toEqual({ tick: TICK - 3, row: server });
    expect(replayOf(({ history }) => keep(history, TICK, predicted, 0))).toEqual({
      tick: TICK,
      row: [...predicted],
    });
  });

  it.each<Partial<Track>>([{ mode: 'stepping' }, { mode: 'held' }, { off: true }, { serverTick: -1 }])(
    'is not replayed with %o',
    (state) => expect(replayOf((track) => Object.assign(track, state))).toBeNull(),
  );
});
