import type { PartialFrame, ServerFrame } from '../../../wire';
import { forgetRecords } from '../../inputs/inputs';
import type { Simulation } from '../../simulation/simulation';
import { sentAt } from '../../time/clock';
import { createTickRateMeter, isTickRate, measureTickRate } from '../../time/tickRateMeter';
import { spanOf } from '../../time/timeline';
import type { Receiver } from '../receiver';

/**
 * Measures the tick rate of a server that has not sent it before a frame that arrived at `now`.
 * @returns the rate, Hz, or null if it is sent or not known yet
 */
export function measureUnsentRate(
  sim: Simulation,
  receiver: Receiver,
  { tick, tickRate }: PartialFrame,
  now: number,
): number | null {
  const isSent = isTickRate(tickRate) || receiver.sentTempo.tickRate !== null;
  if (!isSent) receiver.tickRate ??= createTickRateMeter();
  const meter = receiver.tickRate;
  if (meter === null) return null;
  const measured = isSent ? null : measureTickRate(meter, tick, now);
  meter.isKnown = isSent || measured !== null;
  if (measured !== null) {
    const message = `No frame has had tickRate yet: ${measured} Hz were measured. Pass it with each frame.`;
    sim.warn('tick-rate-measured', message, { measured });
  }
  return measured;
}

/**
 * The server wall second at which a newer frame was sent, if the ticks since the newest one do not give it: their rate is assumed,
 * or another one was measured since. Otherwise null.
 */
export function sentUntimed(
  { timeline, inputs }: Simulation,
  { tickRate: meter, clock, sentTempo }: Receiver,
  { tick, tickRate }: ServerFrame,
  now: number,
): number | null {
  if (meter === null) return null;
  const { isKnown, wasKnown, late } = meter;
  meter.wasKnown = isKnown;
  const isMeasuredAnew = sentTempo.tickRate === null && tickRate !== spanOf(timeline, tick).tickRate;
  if (isKnown && wasKnown && !isMeasuredAnew) return null;
  // Inputs were stamped by an assumed rate, perhaps for seconds later.
  if (isKnown && !wasKnown) forgetRecords(inputs);
  return sentAt(clock, now) - late;
}
