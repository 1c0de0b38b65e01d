import {
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  CONTACT,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  POSITION,
  REFERENCE_BODY,
  SHIP_CLASS,
  SURFACE_STATE,
  THRUST_LEVEL,
  TIPPED,
  VELOCITY,
  type World,
} from '../../dynamics';
import type { TouchdownView } from '../drawn/view';

/**
 * The touchdown of the player's ship so far (HUD, touchdown card): a row of doubles, written substep by substep with the ship's row and rewound
 * with it (touchdownRewind). So no touch is lost between two display frames, and a retracted touch leaves no trace.
 */

/** Columns of a log's row. 1 once a touch was simulated; 0 for a ship first seen on the ground. */
const KNOWN = 0;
/** Index into OUTCOMES. */
const OUTCOME = 1;
/** Impact speed of the dynamics at the first touch, m/s. */
const VERTICAL_SPEED = 2;
/** Along the turning ground just before the first touch, m/s. */
const HORIZONTAL_SPEED = 3;
const BOUNCES = 4;
/** Distance slid along the ground, m. */
const SLIDE = 5;
/** Game s since the first touch; stops at rest. */
const SINCE = 6;
/** SINCE when it last landed, tipped or crashed; equal to SINCE while open. */
const SETTLED = 7;
/** rad; and its cosine, which is cheaper to compare. */
const LARGEST_TILT = 8;
const LEAST_COS = 9;
/** Since it last left the ground: game s in the air, 1 if under thrust meanwhile, and game s up to which that is still a hop. */
const IN_AIR = 10;
const POWERED = 11;
const HOP_ALLOWANCE = 12;
/** The ship's SURFACE_STATE at the row's instant. */
export const LOGGED_STATE = 13;
export const LOG_STRIDE = 14;

const OUTCOMES = ['open', 'landed', 'tipped', 'crashed'] as const;
const OPEN = 0;
const CRASHED_THERE = 3;

/** A hop under thrust counts as a bounce up to this many times its duration without thrust; a longer one is a new approach. */
const HOP_PATIENCE = 2;

/** Begins a log for a ship without history, in surface state `surfaceState`. */
export function beginLog(log: Float64Array, surfaceState: number): void {
  log.fill(0);
  log[LOGGED_STATE] = surfaceState;
}

/** One substep of a row: before it at `beforeAt` in `before`, after it at `at` in `rows`. */
export interface LoggedSubstep {
  before: Float64Array;
  beforeAt: number;
  rows: Float64Array;
  at: number;
  bodies: Float64Array;
  /** Game s, as Span.step. */
  dt: readonly [dt: number, none: null];
}

export function logSubstep(log: Float64Array, world: World, step: LoggedSubstep): void {
  const { before, beforeAt, rows: after, at } = step;
  const [dt] = step.dt;
  if (before[beforeAt + CRASHED] === 1) return;
  const from = before[beforeAt + SURFACE_STATE]!;
  const to = after[at + SURFACE_STATE]!;
  if (from === FLYING) {
    log[IN_AIR]! += dt;
    if (after[at + THRUST_LEVEL]! > 0) log[POWERED] = 1;
  }
  if (log[KNOWN] === 1 && (log[OUTCOME] === OPEN || from === TIPPED)) log[SINCE]! += dt;
  if (from === FLYING && to !== FLYING) touch(log, step);
  if (after[at + CRASHED] === 1) crash(log, step);
  if (from !== FLYING && to !== FLYING) slide(log, step);
  if (from !== FLYING && to === FLYING) logLiftOff(log, world, after, at);
  if (to !== FLYING) lean(log, after, at);
  logState(log, to);
}

/** Logs the ship's surface state: at rest the card is closed; when a tipped ship is righted, it is opened again. */
export function logState(log: Float64Array, state: number): void {
  if (state === LANDED || state === TIPPED) log[OUTCOME] = state - CONTACT;
  else if (state === CONTACT && log[LOGGED_STATE] === TIPPED) log[OUTCOME] = OPEN;
  if (log[OUTCOME] === OPEN || state !== log[LOGGED_STATE]) log[SETTLED] = log[SINCE]!;
  log[LOGGED_STATE] = state;
}

/** Logs a lift-off, after which the row is at `at`: computes how long a hop from here may last, with a drop of the ship's own height. */
export function logLiftOff(log: Float64Array, world: World, rows: Float64Array, at: number): void {
  const body = world.bodies[rows[at + REFERENCE_BODY]!]!;
  const drop = world.shipClasses[rows[at + SHIP_CLASS]!]!.groundContactOffset;
  const distance = Math.sqrt(squared(rows, at + POSITION));
  const gravity = body.gravityParameter / (distance * distance);
  const rising = radialSpeed(rows, at, distance);
  log[IN_AIR] = 0;
  log[POWERED] = 0;
  log[HOP_ALLOWANCE] = (HOP_PATIENCE * (rising + Math.sqrt(rising * rising + 2 * gravity * drop))) / gravity;
}

/**
 * Logs a touch, before which the row is at `at`: a bounce, or the first touch of a new landing. A `verticalSpeed` below 0 is unknown: such
 * a first touch leaves no card.
 */
export function logTouch(
  log: Float64Array,
  verticalSpeed: number,
  rows: Float64Array,
  at: number,
  bodies: Float64Array,
): void {
  const hopped = log[POWERED] === 0 || log[IN_AIR]! <= log[HOP_ALLOWANCE]!;
  if (log[KNOWN] === 1 && log[OUTCOME] === OPEN && hopped) {
    log[BOUNCES]! += 1;
    return;
  }
  beginLog(log, FLYING);
  if (verticalSpeed < 0) return;
  log[KNOWN] = 1;
  log[VERTICAL_SPEED] = verticalSpeed;
  log[HORIZONTAL_SPEED] = alongGround(rows, at, bodies);
  log[LEAST_COS] = 1;
  lean(log, rows, at);
}

function touch(log: Float64Array, { before, beforeAt, rows: after, at, bodies }: LoggedSubstep): void {
  logTouch(log, after[at + IMPACT_SPEED]!, before, beforeAt, bodies);
}

/** Logs a crash from flight, or into rising ground. The dynamics leave the velocity as it was. */
function crash(log: Float64Array, { before, beforeAt, rows: after, at, bodies }: LoggedSubstep): void {
  if (before[beforeAt + SURFACE_STATE] === FLYING) {
    const falling = -radialSpeed(after, at, Math.sqrt(squared(after, at + POSITION)));
    logTouch(log, Math.max(0, falling), before, beforeAt, bodies);
  }
  log[OUTCOME] = CRASHED_THERE;
  log[SETTLED] = log[SINCE]!;
}

/** Adds the distance slid: the dynamics move a ship by its velocity at the substep's end. */
function slide(log: Float64Array, { rows: after, at, bodies, dt }: LoggedSubstep): void {
  log[SLIDE]! += alongGround(after, at, bodies) * dt[0];
}

/** Logs the tilt, atan2(|n × up|, n · up), if it is the largest so far. */
function lean(log: Float64Array, rows: Float64Array, at: number): void {
  const x = rows[at + ATTITUDE]!;
  const y = rows[at + ATTITUDE + 1]!;
  const z = rows[at + ATTITUDE + 2]!;
  const w = rows[at + ATTITUDE + 3]!;
  const ux = 2 * (x * z + w * y);
  const uy = 2 * (y * z - w * x);
  const uz = 1 - 2 * (x * x + y * y);
  const rx = rows[at + POSITION]!;
  const ry = rows[at + POSITION + 1]!;
  const rz = rows[at + POSITION + 2]!;
  const along = ux * rx + uy * ry + uz * rz;
  const cos = along / Math.sqrt(rx * rx + ry * ry + rz * rz);
  if (cos >= log[LEAST_COS]!) return;
  log[LEAST_COS] = cos;
  const cx = ry * uz - rz * uy;
  const cy = rz * ux - rx * uz;
  const cz = rx * uy - ry * ux;
  log[LARGEST_TILT] = Math.atan2(Math.sqrt(cx * cx + cy * cy + cz * cz), along);
}

/** Speed along the turning ground, m/s. */
function alongGround(rows: Float64Array, at: number, bodies: Float64Array): number {
  const spin = rows[at + REFERENCE_BODY]! * BODY_STRIDE + BODY_ANGULAR_VELOCITY;
  const rx = rows[at + POSITION]!;
  const ry = rows[at + POSITION + 1]!;
  const rz = rows[at + POSITION + 2]!;
  const vx = rows[at + VELOCITY]! - (bodies[spin + 1]! * rz - bodies[spin + 2]! * ry);
  const vy = rows[at + VELOCITY + 1]! - (bodies[spin + 2]! * rx - bodies[spin]! * rz);
  const vz = rows[at + VELOCITY + 2]! - (bodies[spin]! * ry - bodies[spin + 1]! * rx);
  const rising = (vx * rx + vy * ry + vz * rz) / (rx * rx + ry * ry + rz * rz);
  const tx = vx - rising * rx;
  const ty = vy - rising * ry;
  const tz = vz - rising * rz;
  return Math.sqrt(tx * tx + ty * ty + tz * tz);
}

/** v · n, m/s, positive = rising. The turning ground does not move along the radius. */
function radialSpeed(rows: Float64Array, at: number, distance: number): number {
  let sum = 0;
  for (let k = 0; k < 3; k++) sum += rows[at + VELOCITY + k]! * rows[at + POSITION + k]!;
  return sum / distance;
}

function squared(rows: Float64Array, at: number): number {
  return rows[at]! * rows[at]! + rows[at + 1]! * rows[at + 1]! + rows[at + 2]! * rows[at + 2]!;
}

export function createTouchdownView(): TouchdownView {
  return {
    known: false,
    outcome: 'open',
    verticalSpeed: Number.NaN,
    horizontalSpeed: Number.NaN,
    bounces: 0,
    slideMetres: Number.NaN,
    settleSeconds: Number.NaN,
    largestTilt: Number.NaN,
  };
}

/** Fills the card; `known` is false if the ship is not predicted. */
export function fillTouchdown(out: TouchdownView, log: Float64Array, known: boolean): void {
  out.known = known && log[KNOWN] === 1;
  out.outcome = OUTCOMES[log[OUTCOME]!]!;
  out.verticalSpeed = log[VERTICAL_SPEED]!;
  out.horizontalSpeed = log[HORIZONTAL_SPEED]!;
  out.bounces = log[BOUNCES]!;
  out.slideMetres = log[SLIDE]!;
  out.settleSeconds = log[SETTLED]!;
  out.largestTilt = log[LARGEST_TILT]!;
}
