import { err, loadTiming, ok, type Result } from '../../dynamics';
import type { BodyState, PartialFrame, ServerFrame } from '../../wire';
import type { Diagnosis } from '../drawn/view';
import type { Simulation } from '../simulation/simulation';
import { spanOf, type Tempo } from '../time/timeline';
import { isTimed, type Receiver } from './receiver';

/**
 * Completes a frame that arrived at client wall second `now`: absent members keep their last values or are measured, invalid ones are
 * dropped and counted.
 * @returns the frame, or the reason, naming the field, why it is refused
 */
export function completeFrame(
  sim: Simulation,
  receiver: Receiver,
  given: PartialFrame,
  now: number,
): Result<ServerFrame> {
  const { tick } = given;
  const { records } = sim.features;
  const fault = records?.tickFault(tick) ?? null;
  if (fault !== null) return err(fault);
  const listOf = records?.recordsOf ?? asSent;
  const known = {
    ...given,
    ships: listOf(sim.counters, 'ships', given.ships),
    bodies: listOf(sim.counters, 'bodies', given.bodies),
  };
  const { tickRate, timeScale } = tempoOf(sim, receiver, known, now);
  const timing = loadTiming(tickRate, timeScale, sim.world.settings);
  if (!timing.ok) return err(`frame.${timing.reason}`);
  if (tick >= sim.newestTick) keepSentTempo(receiver, given);
  // Member by member: the hidden class of a spread record dies with the next garbage collection, and so does the code compiled for it.
  return ok({
    kind: 'frame',
    tick,
    tickRate,
    timeScale,
    ships: known.ships,
    bodies: known.bodies,
    paused: given.paused ?? false,
    events: listOf(sim.counters, 'events', given.events),
    lastInput: sim.features.acknowledgements?.acknowledgementOf(sim, given) ?? null,
  });
}

/** A frame whose lists have been checked. */
type Known = PartialFrame & { readonly bodies: readonly BodyState[] };

/** A frame's tempo, sent, measured or assumed. The time scale is the measured one if the one sent contradicts the motions. */
export function tempoOf(
  sim: Simulation,
  receiver: Receiver,
  frame: Known,
  now: number,
): Omit<Tempo, 'paused'> {
  const { features, timeline } = sim;
  const unsent = features.tickRates?.measureUnsentRate(sim, receiver, frame, now) ?? null;
  const held = timeline.spans.length === 0 ? null : spanOf(timeline, sim.newestTick).tickRate;
  const { sentTempo } = receiver;
  const tickRate =
    frame.tickRate ?? sentTempo.tickRate ?? unsent ?? held ?? assumed(sim, receiver, 'tickRate');
  const sent = frame.timeScale ?? sentTempo.timeScale;
  const measured = features.gameTimeScale?.(receiver, { ...frame, tickRate }, sent) ?? null;
  // Of ticks of unknown length no scale can be measured.
  const known = (isTimed(receiver) ? measured : null) ?? sent;
  return { tickRate, timeScale: known ?? assumed(sim, receiver, 'timeScale') };
}

/** Keeps the frame's tick rate and time scale for later frames that lack them. */
function keepSentTempo({ sentTempo }: Receiver, { tickRate, timeScale }: PartialFrame): void {
  sentTempo.tickRate = tickRate ?? sentTempo.tickRate;
  sentTempo.timeScale = timeScale ?? sentTempo.timeScale;
}

function assumed(
  { warn }: Simulation,
  { defaultTempo }: Receiver,
  name: keyof Receiver['defaultTempo'],
): number {
  const value = defaultTempo[name];
  warn('tempo-missing', `No frame has had ${name} yet: ${value} is used. Pass it with each frame.`, {
    name,
    value,
  });
  return value;
}

/** A list of a decoder. */
function asSent<T>(
  _counters: Diagnosis,
  _name: string,
  value: readonly T[] | undefined | null,
): readonly T[] {
  return value ?? [];
}
