import { moveBodies, settleBodies, turnBodies } from './constants/body';
import { ok, type Result, notFinite, err } from './result';
import { SHIP_STRIDE } from './state/layout';
import { chooseReferenceBody } from './referenceBody';
import type { Settings } from './constants/settings';
import { substep } from './substep';
import type { World } from './constants/world';

/** The division of a tick into substeps (DYNAMICS, Time). */
export interface Timing {
  /** Game seconds per tick: time scale / tick rate. */
  readonly tickSeconds: number;
  readonly substeps: number;
  /** Game seconds per substep, at most the settings' contactLongestSubstep. */
  readonly dt: number;
}

/** The game's bounds, of ticks per second and of game seconds per second. */
const LEAST_TEMPO = 0.1;
const MOST_TEMPO = 100;

/** Timing of a server's `tickRate` (0.1–100 Hz) and `timeScale` (0.1–100), or a reason that names the one out of range. */
export function loadTiming(
  tickRate: number,
  timeScale: number,
  { contactLongestSubstep }: Pick<Settings, 'contactLongestSubstep'>,
): Result<Timing> {
  const reason = notFinite('tickRate', tickRate) ?? notFinite('timeScale', timeScale);
  if (reason !== null) return err(reason);
  const range = `expected ${LEAST_TEMPO} to ${MOST_TEMPO}`;
  if (tickRate < LEAST_TEMPO || tickRate > MOST_TEMPO)
    return err(`tickRate: ${range} Hz, got ${String(tickRate)}`);
  if (timeScale < LEAST_TEMPO || timeScale > MOST_TEMPO)
    return err(`timeScale: ${range}, got ${String(timeScale)}`);
  return ok(timingOfTick(timeScale / tickRate, contactLongestSubstep));
}

/** In substeps: a tick longer than a whole number of substeps by no more than this is rounding, as in 0.1 + 0.2. */
const ROUNDING = 1e-9;

/** Timing of a tick of `tickSeconds` > 0 of game time, divided into substeps of at most `longestSubstep` seconds. */
export function timingOfTick(tickSeconds: number, longestSubstep: number): Timing {
  const whole = Math.ceil(tickSeconds / longestSubstep - ROUNDING);
  const substeps = whole > 1 ? whole : 1;
  return { tickSeconds, substeps, dt: tickSeconds / substeps };
}

/** At a tick's start: flying ships choose their reference body. `ships` holds whole rows. */
export function beginTick(ships: Float64Array, bodies: Float64Array, world: World): void {
  for (let at = 0; at < ships.length; at += SHIP_STRIDE) chooseReferenceBody(ships, at, bodies, world);
}

/**
 * One substep of all ships and bodies: `events[i]` is the event of ship i (EVENT_NAMES).
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

/** At a tick's end: moves the bodies by the tick. */
export function endTick(bodies: Float64Array, world: World, timing: Timing): void {
  moveBodies(bodies, world.bodies.length, timing.tickSeconds);
}
