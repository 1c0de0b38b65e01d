import { ATTITUDE, CRASHED, POSITION, SURFACE_STATE, SURFACE_STATES, VELOCITY } from '../../src/dynamics';
import type { WorldView } from '../../src/prediction';
import { rowAt, type Truth } from './truth';

/** What was drawn at one frame, kept until the server has simulated it. */
export interface Sample {
  readonly wall: number;
  readonly tick: number;
  readonly sinceTick: number;
  readonly shipId: string;
  readonly drawn: readonly number[];
  /** Predicted, without the offset. */
  readonly position: readonly number[];
  readonly predictedAttitude: readonly number[];
  /** Drawn. */
  readonly attitude: readonly number[];
  readonly state: string;
  readonly provenance: string;
}

export function sampleOf(view: WorldView, wall: number, index = 0): Sample {
  const ship = view.ships[index]!;
  return {
    wall,
    tick: view.tick,
    sinceTick: view.sinceTick,
    shipId: ship.shipId,
    drawn: [...ship.easedPosition],
    position: [...ship.position],
    predictedAttitude: [...ship.attitude],
    attitude: [...ship.meshAttitude],
    state: ship.crashed ? 'crashed' : ship.surfaceContactState,
    provenance: ship.provenance,
  };
}

/** A ship's true state on the server, linear between substep boundaries. */
export interface TruePose {
  readonly position: readonly number[];
  readonly velocity: readonly number[];
  readonly attitude: readonly number[];
  readonly state: string;
}

/** The true state at a sample's label; null if the server has not simulated it yet, or has no such ship. */
export function truthAt(
  truth: Truth,
  sample: Pick<Sample, 'tick' | 'sinceTick' | 'shipId'>,
): TruePose | null {
  const interval = truth.interval(sample.tick);
  if (interval === undefined) return null;
  const i = interval.shipIds.indexOf(sample.shipId);
  if (i < 0) return null;
  const substeps = Math.min(interval.timing.substeps, sample.sinceTick / interval.timing.dt);
  // A label at a boundary may be an ulp below it.
  const whole = Math.min(interval.timing.substeps - 1, Math.floor(substeps + 1e-9));
  const share = Math.max(0, substeps - whole);
  const before = rowAt(interval, whole, i);
  const after = rowAt(interval, whole + 1, i);
  const between = (column: number, count: number) => {
    const values: number[] = [];
    for (let k = column; k < column + count; k++) values.push(before[k]! + (after[k]! - before[k]!) * share);
    return values;
  };
  return {
    position: between(POSITION, 3),
    velocity: between(VELOCITY, 3),
    attitude: between(ATTITUDE, 4),
    state: before[CRASHED] === 1 ? 'crashed' : SURFACE_STATES[before[SURFACE_STATE]!]!,
  };
}

export function distance(a: readonly number[], b: readonly number[]): number {
  return Math.sqrt((a[0]! - b[0]!) ** 2 + (a[1]! - b[1]!) ** 2 + (a[2]! - b[2]!) ** 2);
}

/** Angle between two attitudes, rad; from their difference, which keeps small angles. */
export function angleBetween(a: readonly number[], b: readonly number[]): number {
  const apart = (sign: number) =>
    Math.sqrt(a.reduce((sum, value, k) => sum + (value - sign * b[k]!) ** 2, 0));
  return 4 * Math.asin(Math.min(1, Math.min(apart(1), apart(-1)) / 2));
}
