import type { InputAcknowledgement, PartialFrame, StateControls } from '../../wire';
import { acknowledge, type InputOutcome } from './inputs';
import type { Simulation } from '../simulation/simulation';
import { steerByMargin } from '../time/clock';
import type { Receiver } from '../snapshots/receiver';

/** The acknowledgement, or null if it is absent or invalid: an input cannot be applied after the frame that acknowledges it. */
export function acknowledgementOf(
  sim: Simulation,
  { tick, lastInput }: PartialFrame,
): InputAcknowledgement | null {
  if (lastInput === undefined || lastInput === null) return null;
  const { seq, tick: applied, substep, margin } = lastInput;
  const isWhole = [seq, applied, substep].every(Number.isSafeInteger) && Number.isFinite(margin);
  if (isWhole && (applied < tick || (applied === tick && substep === 0))) return lastInput;
  sim.counters.acknowledgementsRefused += 1;
  sim.counters.lastRefusal = `frame.lastInput.tick: expected at most the frame's tick, ${tick}, got ${String(applied)}`;
  sim.warn('acknowledgement-refused', sim.counters.lastRefusal, { lastInput, tick });
  return null;
}

/** Takes the frame's acknowledgement of own inputs, also for steering the lead. `inForce`: the ship's controls in that frame. */
export function applyAcknowledgement(
  { inputs, counters }: Simulation,
  { clock, context }: Receiver,
  inForce: StateControls,
): InputOutcome {
  const { tick, now, lastInput } = context;
  const before = inputs.applied;
  const outcome = acknowledge(inputs, tick, lastInput, inForce, now);
  if (lastInput !== null && lastInput.seq > before) {
    const stored = inputs.records.find((candidate) => candidate.record.seq === lastInput.seq);
    if (stored !== undefined) steerByMargin(clock, lastInput.margin, stored.steer, now);
    counters.margin = lastInput.margin;
  }
  return outcome;
}
