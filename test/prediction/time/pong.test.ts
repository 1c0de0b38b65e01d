import { describe, expect, it } from 'vitest';
import { receivePong } from '../../../src/prediction/snapshots/receivePong';
import { pingIfDue } from '../../../src/prediction/time/pings';
import { setTempo } from '../../../src/prediction/time/timeline';
import { RATE, sessionAt } from '../decisions/sessionAt';

const TICK = 100;
/** The server's clock reads 0 at TICK. */
const WALL = 0;

/** The clock after the answer to a ping of second 5, which arrives at second 5.1. */
function answered(pong: { id?: number; tick?: number; sinceTick?: number }, prepare = (_: Session) => {}) {
  const session = sessionAt(TICK);
  setTempo(session.sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: false }, WALL);
  pingIfDue(session.pings, 5);
  prepare(session);
  receivePong(session, { kind: 'pong', id: 1, tick: TICK, sinceTick: 0, ...pong }, 5.1);
  return session;
}
type Session = ReturnType<typeof sessionAt>;

describe('a pong', () => {
  it('bounds the server’s clock by its send time', () => {
    const { clock, pings } = answered({ tick: TICK + 3, sinceTick: 0.04 });
    // Sent at 0.34 s of the server, between the client's seconds 5 and 5.1.
    expect(clock.bounds.lower).toBeCloseTo(5 - 0.34, 9);
    expect(clock.bounds.upper).toBeCloseTo(5.1 - 0.34, 9);
    expect([pings.answeredAt, clock.pongAt, clock.timedPongAt]).toEqual([5.1, 5.1, 5.1]);
    expect(clock.stoppedAt).toBe(Number.POSITIVE_INFINITY);
  });

  it('after its tick should have ended shows that the server stopped there', () => {
    expect(answered({ sinceTick: 0.109 }).clock.stoppedAt).toBe(Number.POSITIVE_INFINITY);
    const { clock } = answered({ sinceTick: 0.111 });
    expect(clock.stoppedAt).toBeCloseTo(0.1, 9);
    // It may have stopped there long ago: only the ping's sending bounds it.
    expect(clock.bounds.upper).toBe(Number.POSITIVE_INFINITY);
  });

  it.each<[string, Parameters<typeof answered>[0], ((session: Session) => void)?]>([
    ['of a tick beyond the history', { tick: TICK + 200 }, ({ sim }) => (sim.ringLength = 200)],
    ['of a tick before it', { tick: TICK - 50 }, ({ sim }) => (sim.ringLength = 50)],
    ['of a negative time since its tick', { sinceTick: -0.01 }],
    [
      'in a pause',
      {},
      ({ sim }) => setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: true }, WALL),
    ],
  ])('%s gives only the round trip', (_, pong, prepare) => {
    const { clock } = answered(pong, prepare);
    expect([clock.pongAt, clock.timedPongAt]).toEqual([5.1, Number.NEGATIVE_INFINITY]);
    expect(clock.roundTrip).toBeCloseTo(0.1, 9);
  });

  it.each<[string, Parameters<typeof answered>[0], ((session: Session) => void)?]>([
    ['that answers no ping', { id: 2 }],
    ['before the first frame', {}, ({ sim }) => (sim.newestTick = -1)],
  ])('%s is ignored', (_, pong, prepare) => {
    const { clock, pings, counters } = answered(pong, prepare);
    expect([clock.pongAt, pings.answeredAt]).toEqual([Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY]);
    expect(counters.framesRefused).toBe(0);
  });

  it('of the first frame, tick 0, counts', () => {
    expect(answered({ tick: 0 }, ({ sim }) => (sim.newestTick = 0)).clock.pongAt).toBe(5.1);
  });

  it.each(['id', 'tick', 'sinceTick'])('whose %s is not finite is refused', (field) => {
    const { clock, counters } = answered({ [field]: Number.NaN });
    expect([clock.pongAt, counters.framesRefused]).toEqual([Number.NEGATIVE_INFINITY, 1]);
    expect(counters.lastRefusal).toContain(`${field} NaN`);
  });
});
