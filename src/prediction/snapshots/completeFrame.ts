import { err, loadTiming, ok, type Result } from '../../dynamics';
import type { PartialFrame, ServerFrame } from '../../wire';
import type { Simulation } from '../simulation/simulation';
import { spanOf } from '../time/timeline';
import type { GameTimeMeter } from './gameTimeMeter';

/** Highest tick that the wire accepts: sums of two are still exact. */
const MAX_TICK = 2 ** 52;

/**
 * Completes a frame: absent members keep their last values, invalid ones are dropped and counted. The time scale is the measured one if
 * the one sent contradicts the motions.
 * @returns the frame, or the reason, naming the field, why it is refused
 */
export function completeFrame(
  sim: Simulation,
  meter: GameTimeMeter,
  given: PartialFrame,
): Result<ServerFrame> {
  const { tick } = given;
  if (!Number.isSafeInteger(tick) || tick < 0 || tick > MAX_TICK)
    return err(`frame.tick: expected a whole number from 0 to 2⁵², got ${String(tick)}`);
  const held = sim.timeline.spans.length === 0 ? null : spanOf(sim.timeline, sim.newestTick);
  const tickRate = given.tickRate ?? held?.tickRate ?? warnDefault(sim, 'tickRate', 1);
  const sentScale = given.timeScale ?? null;
  const known = {
    ...given,
    tickRate,
    ships: recordsOf(sim, 'ships', given.ships),
    bodies: recordsOf(sim, 'bodies', given.bodies),
  };
  const measured = sim.features.measureGameTime?.(meter, known, sentScale) ?? null;
  const timeScale = measured ?? sentScale ?? warnDefault(sim, 'timeScale', 1);
  const timing = loadTiming(tickRate, timeScale, sim.world.settings);
  if (!timing.ok) return err(`frame.${timing.reason}`);
  // Member by member: the hidden class of a spread record dies with the next garbage collection, and so does the code compiled for it.
  return ok({
    kind: 'frame',
    tick,
    tickRate,
    timeScale,
    ships: known.ships,
    bodies: known.bodies,
    paused: given.paused ?? false,
    events: recordsOf(sim, 'events', given.events),
    lastInput: sim.features.acknowledgements?.acknowledgementOf(sim, given) ?? null,
  });
}

function warnDefault({ warn }: Simulation, name: string, value: number): number {
  warn('tempo-missing', `No frame has had ${name} yet: ${value} is used. Pass it with each frame.`, {
    name,
    value,
  });
  return value;
}

/** A list of records; anything else is dropped and counted. */
function recordsOf<T>(sim: Simulation, name: string, value: readonly T[] | undefined | null): readonly T[] {
  if (!Array.isArray(value)) return [];
  const list = value as readonly T[];
  if (list.every(isRecord)) return list;
  sim.counters.shipsRefused += 1;
  sim.counters.lastRefusal = `frame.${name}: expected records`;
  return list.filter(isRecord);
}

function isRecord(value: unknown): boolean {
  return typeof value === 'object' && value !== null;
}
