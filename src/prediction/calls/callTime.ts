import type { Session } from '../session';
import { noteSetBack } from '../time/clock';
import { forgetPings } from '../time/pings';

/** s: a message stamped when it came may be handled after a later `advance`; a clock that was set back goes back by more. */
const HANDLED_LATE = 0.25;

/**
 * Client wall s at the caller's `now`, in which everything is kept. If the caller's clock is set back, they go on from the last
 * `advance`. NaN, with a warning, if `now` is no time.
 */
export function wallAt(session: Session, now: number): number {
  const { clock, pings, warn } = session;
  if (!Number.isFinite(now)) {
    const advice = 'now must be finite wall seconds, e.g. performance.now() / 1000. The call was ignored.';
    warn('now-not-finite', advice, { now });
    return Number.NaN;
  }
  const back = clock.updatedAt - (now + session.setBack);
  if (back > HANDLED_LATE) {
    session.setBack += back;
    noteSetBack(clock);
    forgetPings(pings);
  }
  return now + session.setBack;
}
