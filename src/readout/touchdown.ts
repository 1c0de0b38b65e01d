import type { SurfaceState } from '../dynamics';
import type { ShipView } from '../prediction';
import type { Surface } from './surface';

/** One touchdown, from the first touch to rest (HUD, touchdown card). Speeds relative to the turning ground. */
export interface Touchdown {
  /** A touch was seen: a ship met already on the ground has no card. */
  known: boolean;
  /** 'open' until the ship has landed, tipped or crashed. */
  outcome: 'open' | 'landed' | 'tipped' | 'crashed';
  /** The law's impact speed at the first touch, m/s. */
  verticalSpeed: number;
  /** Just before the first touch, m/s. */
  horizontalSpeed: number;
  /** Times it left the ground again. */
  bounces: number;
  /** Way along the ground while on it, hops not counted, m. */
  slideMetres: number;
  /** Game s from the first touch to rest, or so far. */
  settleSeconds: number;
  /** Degrees, since the first touch; the tilt it came with counts. */
  largestTilt: number;
}

/** What carries on from view to view. */
export interface TouchdownMemory {
  previous: SurfaceState | null;
  previousTangentialSpeed: number;
  /** rad */
  previousTilt: number;
  /** Game s */
  touchedAt: number;
  leftAt: number;
  /** Game s in the air that still count as a bounce. */
  hopAllowance: number;
}

/** Game s between two views, beyond which the speeds at both ends say little of the way between them. */
const LONGEST_STRIDE = 1;
/** A ballistic hop lasts 2 v / g; one held up by the engine for longer than twice that is a new approach. */
const HOP_PATIENCE = 2;

export function createTouchdown(): Touchdown {
  return {
    known: false,
    outcome: 'open',
    verticalSpeed: 0,
    horizontalSpeed: 0,
    bounces: 0,
    slideMetres: 0,
    settleSeconds: 0,
    largestTilt: 0,
  };
}

export function createTouchdownMemory(): TouchdownMemory {
  return {
    previous: null,
    previousTangentialSpeed: 0,
    previousTilt: 0,
    touchedAt: 0,
    leftAt: 0,
    hopAllowance: 0,
  };
}

/** Another ship, or the same one put elsewhere. */
export function forgetTouchdown(out: Touchdown, memory: TouchdownMemory): void {
  out.known = false;
  memory.previous = null;
}

/** Follows the predicted truth from view to view; `now` in game s, `elapsed` since the last view. */
export function followTouchdown(
  out: Touchdown,
  memory: TouchdownMemory,
  ship: ShipView,
  surface: Surface,
  { now, elapsed }: { now: number; elapsed: number },
): void {
  const { previous } = memory;
  const state = ship.surfaceState;
  if (previous === '' && state !== '') touch(out, memory, ship, now);
  else if (previous !== null && previous !== '' && state === '') leave(memory, surface, now);
  if (ship.crashed && previous !== null) crash(out, memory, surface, now);
  if (out.known && state !== '') slide(out, memory, surface, elapsed);
  if (out.known && out.outcome === 'open') out.settleSeconds = now - memory.touchedAt;
  if (out.known && (state === 'landed' || state === 'tipped')) out.outcome = state;
  else if (state === 'contact') out.outcome = 'open';
  memory.previous = state;
  memory.previousTangentialSpeed = surface.tangentialSpeed;
  memory.previousTilt = surface.tilt;
}

function touch(out: Touchdown, memory: TouchdownMemory, ship: ShipView, now: number): void {
  const bounced = out.known && out.outcome === 'open' && now - memory.leftAt <= memory.hopAllowance;
  if (bounced) {
    out.bounces++;
    return;
  }
  begin(out, memory, now);
  out.verticalSpeed = ship.impactSpeed;
}

function begin(out: Touchdown, memory: TouchdownMemory, now: number): void {
  out.known = true;
  out.outcome = 'open';
  out.horizontalSpeed = memory.previousTangentialSpeed;
  out.bounces = 0;
  out.slideMetres = 0;
  out.settleSeconds = 0;
  out.largestTilt = (memory.previousTilt * 180) / Math.PI;
  memory.touchedAt = now;
}

/** A ship that leaves the ground downwards was never on it, its touch was predicted and taken back: no time for a hop. */
function leave(memory: TouchdownMemory, surface: Surface, now: number): void {
  memory.leftAt = now;
  memory.hopAllowance = (HOP_PATIENCE * 2 * surface.radialSpeed) / surface.gravity;
}

/** A crash leaves the ship's state as it was, so its velocity still tells the impact. */
function crash(out: Touchdown, memory: TouchdownMemory, surface: Surface, now: number): void {
  if (out.outcome === 'crashed' && out.known) return;
  if (!out.known || out.outcome !== 'open') {
    begin(out, memory, now);
    out.verticalSpeed = Math.max(0, -surface.radialSpeed);
    out.horizontalSpeed = surface.tangentialSpeed;
  }
  out.outcome = 'crashed';
}

function slide(out: Touchdown, memory: TouchdownMemory, surface: Surface, elapsed: number): void {
  const tilt = (surface.tilt * 180) / Math.PI;
  if (tilt > out.largestTilt) out.largestTilt = tilt;
  if (memory.previous === '' || memory.previous === null || elapsed > LONGEST_STRIDE) return;
  out.slideMetres += 0.5 * (memory.previousTangentialSpeed + surface.tangentialSpeed) * elapsed;
}
