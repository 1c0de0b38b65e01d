/** Counts the states, events and modes that the drawn cases reach. */
import {
  ATTITUDE,
  ATTITUDE_MODE,
  ATTITUDE_MODES,
  CRASHED,
  EVENT_NAMES,
  FLYING,
  FUEL,
  LANDED,
  modeName,
  POSITION,
  REFERENCE_BODY,
  SHIP_STRIDE,
  SURFACE_STATE,
  SURFACE_STATES,
} from '../../../src/dynamics';
import type { ExactCase } from './exactCase';
import { AFTER_TICK, type TakeRow } from './playCase';

export interface Coverage {
  /** "state contact/radial" → substeps, "event ship.landed" → times, … */
  readonly counts: Map<string, number>;
  readonly tickRates: Set<number>;
  readonly timeScales: Set<number>;
  /** Counts the rows of a case. */
  readonly follow: (exact: ExactCase) => TakeRow;
}

/** Kinds that must occur, by the prefix of their keys. */
const KINDS = {
  state: SURFACE_STATES.flatMap((state) => [...ATTITUDE_MODES, 'unknown'].map((mode) => `${state}/${mode}`)),
  event: EVENT_NAMES.slice(1),
  world: ['aligned', 'kept', 'flat', 'hills', 'bowl'],
  ground: ['radial', 'terrain'],
  change: ['reference body', 'ran dry', 'launched'],
  tilt: ['under 5', 'to 90', 'past 90', 'overhead'],
} as const;

/** How often the rarest of a kind occurred. */
export function fewestOf({ counts }: Coverage, kind: keyof typeof KINDS): number {
  return Math.min(...KINDS[kind].map((key) => counts.get(`${kind} ${key}`) ?? 0));
}

export function createCoverage(): Coverage {
  const counts = new Map<string, number>();
  const tickRates = new Set<number>();
  const timeScales = new Set<number>();
  const count = (key: string) => counts.set(key, (counts.get(key) ?? 0) + 1);
  return {
    counts,
    tickRates,
    timeScales,
    follow(exact) {
      tickRates.add(exact.tickRate);
      timeScales.add(exact.timeScale);
      const before = new Float64Array(SHIP_STRIDE);
      before[REFERENCE_BODY] = exact.bodies.findIndex(({ name }) => name === exact.ship.referenceBody);
      return (row, _tick, substep) => {
        if (substep === AFTER_TICK) return;
        if (row[CRASHED] === 1) count('crashed');
        else countSubstep(exact, row, count);
        if (row[SHIP_STRIDE] !== 0) count(`event ${EVENT_NAMES[row[SHIP_STRIDE]!]!}`);
        countChanges(before, row, count);
        before.set(row.subarray(0, SHIP_STRIDE));
      };
    },
  };
}

function countSubstep(
  { settings, terrain }: ExactCase,
  row: Float64Array,
  count: (key: string) => void,
): void {
  count(`state ${SURFACE_STATES[row[SURFACE_STATE]!]!}/${modeName(row[ATTITUDE_MODE]!)}`);
  count(`world ${settings.touchdownAttitude ?? 'aligned'}`);
  if (row[SURFACE_STATE] !== FLYING) count(`ground ${settings.surfaceNormal ?? 'radial'}`);
  count(`world ${'name' in terrain ? terrain.name : 'bowl'}`);
  if (row[SURFACE_STATE] !== FLYING) count(`tilt ${tiltOf(row)}`);
}

function countChanges(before: Float64Array, row: Float64Array, count: (key: string) => void): void {
  if (before[REFERENCE_BODY] !== row[REFERENCE_BODY]) count('change reference body');
  if (before[FUEL]! > 0 && row[FUEL] === 0) count('change ran dry');
  if (before[SURFACE_STATE] === LANDED && row[SURFACE_STATE] !== LANDED) count('change launched');
}

function tiltOf(row: Float64Array): string {
  const [x, y, z, w] = row.subarray(ATTITUDE, ATTITUDE + 4) as unknown as [number, number, number, number];
  const [rx, ry, rz] = row.subarray(POSITION, POSITION + 3) as unknown as [number, number, number];
  const up = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)] as const;
  const cos = (up[0] * rx + up[1] * ry + up[2] * rz) / Math.hypot(rx, ry, rz);
  if (cos > 0.99619) return 'under 5';
  if (cos >= 0) return 'to 90';
  return cos > -0.5 ? 'past 90' : 'overhead';
}
