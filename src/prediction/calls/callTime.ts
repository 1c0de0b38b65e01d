import type { Session } from '../session';
import { noteSetBack } from '../time/clock';
import { forgetPings } from '../time/pings';

/** s. A message stamped on arrival may be handled after a later `advance`; a clock that is set back goes back further. */
const HANDLED_LATE = 0.25;

/**
 * Converts the caller's `now` to client wall s, the predictor's own time. If the caller's clock is set back, it continues from the last
 * `advance`. NaN, with a warning, if `now` is not finite.
 */
export function wallAt(session: Session, now: number): number {
  const { clock, pings, warn } = session;
  if (!Number.isFinite(now)) {
    warn(
      'now-not-finite',
      'now must be finite wall seconds, e.g. performance.now() / 1000. The call was ignored.',
      { now },
    );
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
