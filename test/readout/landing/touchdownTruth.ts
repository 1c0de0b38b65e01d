/** The touchdown card computed from the server's own substeps, as reference. */
import {
  ATTITUDE,
  type BodyMotion,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  POSITION,
  SURFACE_STATE,
  TIPPED,
  VELOCITY,
} from '../../../src/dynamics';
import { rowAt, type Truth } from '../../prediction/truth';

export interface Card {
  verticalSpeed: number;
  horizontalSpeed: number;
  bounces: number;
  slideMetres: number;
  settleSeconds: number;
  /** Degrees. */
  largestTilt: number;
}

type Row = Float64Array;

/** Ship 0, state by state, with the game s between two states. */
export interface Track {
  readonly rows: Row[];
  dt: number;
  /** The next interval to take. */
  tick: number;
}

/** Takes the intervals that the server has simulated since. */
export function follow(track: Track, truth: Truth): void {
  for (;;) {
    const interval = truth.interval(track.tick);
    if (interval === undefined) return;
    track.dt = interval.timing.dt;
    for (let boundary = track.tick === 0 ? 0 : 1; boundary <= interval.timing.substeps; boundary++)
      track.rows.push(rowAt(interval, boundary, 0));
    track.tick += 1;
  }
}

/** From the first substep that ends on the ground on; settled at the first that ends at rest. Distances are measured by positions, not by speeds. */
export function cardOf({ rows, dt }: Track, body: BodyMotion): Card {
  const touch = rows.findIndex((row) => row[SURFACE_STATE] !== FLYING || row[CRASHED] === 1);
  if (touch < 1) throw new Error('no touch');
  const rest = rows.findIndex((row) => row[SURFACE_STATE] === LANDED || row[SURFACE_STATE] === TIPPED);
  const card: Card = {
    verticalSpeed: rows[touch]![IMPACT_SPEED]!,
    horizontalSpeed: acrossSpeed(rows[touch - 1]!, body),
    bounces: 0,
    slideMetres: 0,
    settleSeconds: (rest - touch) * dt,
    largestTilt: tiltOf(rows[touch - 1]!),
  };
  for (let i = touch; i < rows.length; i++) {
    const before = rows[i - 1]!;
    const after = rows[i]!;
    const flew = before[SURFACE_STATE] === FLYING;
    const flies = after[SURFACE_STATE] === FLYING;
    if (i > touch && flew && !flies) card.bounces += 1;
    if (!flew && !flies) card.slideMetres += way(before, after, body, dt);
    if (!flies) card.largestTilt = Math.max(card.largestTilt, tiltOf(after));
  }
  return card;
}

function groundVelocity(row: Row, { angularVelocity: w }: BodyMotion): number[] {
  const [x, y, z] = [...row.slice(POSITION, POSITION + 3)] as [number, number, number];
  return [w[1] * z - w[2] * y, w[2] * x - w[0] * z, w[0] * y - w[1] * x];
}

/** The part of `v` along the ground under the row. */
function level(row: Row, v: readonly number[]): number {
  const r = [...row.slice(POSITION, POSITION + 3)];
  const far = Math.hypot(...r);
  const rising = v.reduce((sum, x, k) => sum + (x * r[k]!) / far, 0);
  return Math.hypot(...v.map((x, k) => x - (rising * r[k]!) / far));
}

function acrossSpeed(row: Row, body: BodyMotion): number {
  const ground = groundVelocity(row, body);
  return level(
    row,
    ground.map((g, k) => row[VELOCITY + k]! - g),
  );
}

function way(before: Row, after: Row, body: BodyMotion, dt: number): number {
  const ground = groundVelocity(before, body);
  return level(
    before,
    ground.map((g, k) => after[POSITION + k]! - before[POSITION + k]! - g * dt),
  );
}

/** By the chord between local up and the ship's up: exact to 1e-8 at any tilt except 180°. */
function tiltOf(row: Row): number {
  const [x, y, z, w] = [...row.slice(ATTITUDE, ATTITUDE + 4)] as [number, number, number, number];
  const up = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
  const r = [...row.slice(POSITION, POSITION + 3)];
  const far = Math.hypot(...r);
  return (2 * Math.asin(Math.hypot(...up.map((u, k) => u - r[k]! / far)) / 2) * 180) / Math.PI;
}
