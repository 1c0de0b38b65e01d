import type { WorldView } from './drawn/view';
import { fillView } from './drawn/worldView';
import { place } from './advance';
import type { Session } from './session';
import { jitterOf, sentAt, serverTime } from './time/clock';
import { connectionOf } from './time/connection';
import { spanOf } from './time/timeline';

/** The view at client wall second `now`, with connection and gauges; before the first `advance`, a view without server state. */
export function viewAt(session: Session, now: number): WorldView {
  const { sim, viewBuilder, clock, advancedAt } = session;
  fillConnection(session, now);
  if (Number.isNaN(advancedAt) || sim.newestTick < 0 || sim.frontIsStale) return viewBuilder.view;
  const present = clock.present + Math.max(0, now - clock.updatedAt) * clock.rate;
  place(sim, present);
  const { instant } = viewBuilder;
  instant.now = now;
  instant.present = present;
  instant.lead = clock.present - serverTime(clock, clock.updatedAt);
  instant.heard = sentAt(clock, now) - jitterOf(clock);
  fillView(viewBuilder, sim);
  fillDiagnosis(session);
  return viewBuilder.view;
}

function fillConnection({ viewBuilder, receiver, pings, sim }: Session, now: number): void {
  const { view } = viewBuilder;
  view.silence = Math.max(0, now - receiver.acceptedAt);
  if (sim.timeline.spans.length === 0) {
    view.connection = 'waiting';
    return;
  }
  const since = { frame: view.silence, pong: Math.max(0, now - pings.answeredAt) };
  view.connection = connectionOf(since, sim.cadence, spanOf(sim.timeline, sim.newestTick));
}

function fillDiagnosis({ counters, clock, setBack }: Session): void {
  counters.clockOffset = clock.offset - setBack;
  counters.clockRate = clock.rate;
  counters.roundTrip = clock.roundTrip;
  counters.jitter = jitterOf(clock);
  counters.lead = clock.present - serverTime(clock, clock.updatedAt);
}
