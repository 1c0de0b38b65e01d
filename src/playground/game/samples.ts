import type { Diagnosis } from '../../prediction';

/** Samples taken ten times per second, for plots and figures. */
export const GAUGES = [
  { name: 'roundTrip', title: 'Round trip', unit: 'ms', scale: 1000, digits: 1 },
  { name: 'jitter', title: 'Jitter', unit: 'ms', scale: 1000, digits: 1 },
  { name: 'lead', title: 'Lead', unit: 'ms', scale: 1000, digits: 1 },
  { name: 'margin', title: 'Input margin', unit: 'ms', scale: 1000, digits: 1 },
  { name: 'clockRate', title: 'Clock rate', unit: '×', scale: 1, digits: 4 },
  { name: 'errorPosition', title: 'Position error', unit: 'm', scale: 1, digits: 3 },
  { name: 'errorAngle', title: 'Attitude error', unit: '°', scale: 180 / Math.PI, digits: 2 },
  { name: 'offsetPosition', title: 'Position correction', unit: 'm', scale: 1, digits: 3 },
  { name: 'offsetAngle', title: 'Attitude correction', unit: '°', scale: 180 / Math.PI, digits: 2 },
] as const satisfies readonly Gauge[];

export type GaugeName = (typeof GAUGES)[number]['name'];

interface Gauge {
  readonly name: keyof Diagnosis;
  readonly title: string;
  readonly unit: string;
  /** From the diagnosis's unit to `unit`. */
  readonly scale: number;
  readonly digits: number;
}

/** Thirty seconds at 10 Hz. */
const LENGTH = 300;
const EVERY = 0.1;

/** Rings of the newest samples, oldest first when read. */
export interface Samples {
  readonly take: (diagnosis: Diagnosis, now: number) => boolean;
  readonly times: () => number[];
  readonly values: (gauge: number) => number[];
  readonly clear: () => void;
}

export function createSamples(): Samples {
  const times = new Float64Array(LENGTH);
  const values = GAUGES.map(() => new Float64Array(LENGTH));
  let count = 0;
  let latest = -Infinity;
  const ordered = (ring: Float64Array) => {
    const kept = Math.min(count, LENGTH);
    return Array.from({ length: kept }, (_, i) => ring[(count - kept + i) % LENGTH]!);
  };
  return {
    take(diagnosis, now) {
      if (now - latest < EVERY && now >= latest) return false;
      latest = now;
      const at = count % LENGTH;
      times[at] = now;
      GAUGES.forEach(({ name, scale }, i) => (values[i]![at] = diagnosis[name] * scale));
      count++;
      return true;
    },
    times: () => ordered(times),
    values: (gauge) => ordered(values[gauge]!),
    clear() {
      count = 0;
      latest = -Infinity;
    },
  };
}

export interface Summary {
  readonly last: number;
  readonly mean: number;
  readonly p95: number;
  readonly max: number;
}

/** NaN if there is no finite value. */
export function summarise(values: readonly number[]): Summary {
  const known = values.filter(Number.isFinite);
  if (known.length === 0) return { last: NaN, mean: NaN, p95: NaN, max: NaN };
  const sorted = [...known].sort((a, b) => a - b);
  return {
    last: known.at(-1)!,
    mean: known.reduce((sum, value) => sum + value, 0) / known.length,
    p95: sorted[Math.min(sorted.length - 1, Math.ceil(0.95 * sorted.length) - 1)]!,
    max: sorted.at(-1)!,
  };
}
