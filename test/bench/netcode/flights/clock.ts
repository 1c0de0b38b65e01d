import { NETWORK_PRESETS } from '../../../../src/scenarios';
import { type Figure, spread } from '../figure';
import { flyMeasured } from './flights';

const TARGETS = [
  ['broadband', 3],
  ['fourG', 10],
] as const;

/** The label of the present, minus its lead, relative to true server time, after 5 s. */
export function* clockFigures(): Generator<Figure> {
  for (const [preset, target] of TARGETS) {
    const errors: number[] = [];
    for (let seed = 1; seed <= 4; seed++)
      errors.push(...flyMeasured({ scenario: 'bounce', network: NETWORK_PRESETS[preset], seed }, 40).clock);
    const { p50, p95, p99, max } = spread(errors.map((error) => error * 1000));
    const name = `clock, ${preset}: label − lead − true server time`;
    yield { name, unit: 'ms', p50, p95, p99, max, target: `p99 ≤ ${target}`, met: p99 <= target };
  }
}
