import { moveBodies, settleBodies, turnBodies } from './constants/body';
import { ok, type Result, notFinite, err } from './result';
import { SHIP_STRIDE } from './state/layout';
import { chooseReferenceBody } from './referenceBody';
import type { Settings } from './constants/settings';
import { substep } from './substep';
import type { World } from './constants/world';

/** Division of a tick into substeps (DYNAMICS, Time). */
export interface Timing {
  /** Game seconds per tick: time scale / tick rate. */
  readonly tickSeconds: number;
  readonly substeps: number;
  /** Game seconds per substep, at most the settings' contactLongestSubstep. */
  readonly dt: number;
}

/** The game's bounds of the tick rate, Hz, and of the time scale, game seconds per second. */
export const MIN_RATE = 0.1;
export const MAX_RATE = 100;

/** Timing for a server's `tickRate` (0.1–100 Hz) and `timeScale` (0.1–100), or an error that names the one out of range. */
export function loadTiming(
  tickRate: number,
  timeScale: number,
  { contactLongestSubstep }: Pick<Settings, 'contactLongestSubstep'>,
): Result<Timing> {
  const reason = notFinite('tickRate', tickRate) ?? notFinite('timeScale', timeScale);
  if (reason !== null) return err(reason);
  const range = `expected ${MIN_RATE} to ${MAX_RATE}`;
  if (tickRate < MIN_RATE || tickRate > MAX_RATE)
    return err(`tickRate: ${range} Hz, got ${String(tickRate)}`);
  if (timeScale < MIN_RATE || timeScale > MAX_RATE)
    return err(`timeScale: ${range}, got ${String(timeScale)}`);
  return ok(timingOfTick(timeScale / tickRate, contactLongestSubstep));
}

/** Tolerance in the number of substeps per tick, substeps: a smaller excess is rounding error, as in 0.1 + 0.2. */
const ROUNDING = 1e-9;

/** Timing for ticks of `tickSeconds` > 0 game seconds, divided into equal substeps of at most `longestSubstep` game seconds. */
export function timingOfTick(tickSeconds: number, longestSubstep: number): Timing {
  const whole = Math.ceil(tickSeconds / longestSubstep - ROUNDING);
  const substeps = whole > 1 ? whole : 1;
  return { tickSeconds, substeps, dt: tickSeconds / substeps };
}

/** At a tick's start: chooses the reference body of each flying ship. `ships` holds whole rows. */
export function beginTick(ships: Float64Array, bodies: Float64Array, world: World): void {
  for (let at = 0; at < ships.length; at += SHIP_STRIDE) chooseReferenceBody(ships, at, bodies, world);
}

/**
 * One substep of all ships and bodies. `events[i]` receives the event of ship i (index into EVENT_NAMES).
 * Ships do not interact, so any subset of them gives the same bits.
 */
export function stepWorld(
  ships: Float64Array,
  bodies: Float64Array,
  events: Uint8Array,
  world: World,
  dt: number,
): void {
  const count = world.bodies.length;
  turnBodies(bodies, count, dt);
  for (let i = 0, at = 0; at < ships.length; i++, at += SHIP_STRIDE)
    events[i] = substep(ships, at, bodies, world, dt);
  settleBodies(bodies, count);
}

/** At a tick's end: moves the bodies by one tick. */
export function endTick(bodies: Float64Array, world: World, timing: Timing): void {
  moveBodies(bodies, world.bodies.length, timing.tickSeconds);
}
