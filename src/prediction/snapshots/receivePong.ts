import type { Pong } from '../../wire';
import type { Session } from '../session';
import type { Simulation } from '../simulation/simulation';
import { type Answer, samplePong } from '../time/clock';
import { answeredPing } from '../time/pings';
import { spanOf, wallOfTick } from '../time/timeline';
import { refuse } from './receiveSnapshot';

/** The answer to a ping bounds the server's clock from both sides; one with invalid numbers is refused. */
export function receivePong({ sim, clock, pings }: Session, pong: Pong, now: number): void {
  if (![pong.id, pong.tick, pong.sinceTick].every(Number.isFinite)) {
    refuse(
      sim,
      `pong: expected finite numbers, got id ${pong.id}, tick ${pong.tick}, sinceTick ${pong.sinceTick}`,
    );
    return;
  }
  const sent = answeredPing(pings, pong.id);
  if (Number.isNaN(sent) || sim.newestTick < 0) return;
  pings.answeredAt = now;
  samplePong(clock, sent, answerTime(sim, pong), now);
}

/** A tick this late is overdue, s. */
const OVERDUE = 0.01;

/**
 * When a pong was sent, or null if its stamp is unusable. If a tick is overdue, the server has stopped: its time is at the next
 * tick's boundary.
 */
function answerTime(
  { timeline, newestTick, ringLength }: Simulation,
  { tick, sinceTick }: Pong,
): Answer | null {
  if (Math.abs(tick - newestTick) >= ringLength || !(sinceTick >= 0)) return null;
  const { paused, tickRate } = spanOf(timeline, tick);
  if (paused) return null;
  const interval = 1 / tickRate;
  const at = wallOfTick(timeline, tick) + Math.min(sinceTick, interval);
  return { at, hasStopped: sinceTick > interval + OVERDUE };
}
