/** One figure of a benchmark. */
export interface Figure {
  readonly name: string;
  readonly unit: string;
  readonly median: number;
  readonly min: number;
  readonly max: number;
}

/** Rounds that are timed, after the warm-up: the median of them is the figure. */
const ROUNDS = 15;
/** Wall ms that a case runs before it is timed, so that it is compiled for good. */
const WARM_UP = 600;

/**
 * Times `run(times)`, which does the thing measured that many times.
 * @param each how many of the unit's things one time is, e.g. substeps: the figure is per each
 */
export function timed(name: string, times: number, each: number, run: (times: number) => void): Figure {
  const warm = performance.now() + WARM_UP;
  while (performance.now() < warm) run(times);
  const rounds: number[] = [];
  for (let i = 0; i < ROUNDS; i++) {
    const from = process.hrtime.bigint();
    run(times);
    rounds.push(Number(process.hrtime.bigint() - from) / (times * each));
  }
  return figure(name, 'ns', rounds);
}

/** Bytes of heap that one of `times` runs leaves behind, young garbage counted. Wants node's --expose-gc. */
export function heapGrowth(name: string, times: number, run: (times: number) => void): Figure {
  const { gc } = globalThis;
  if (!gc) throw new Error('heap figures want node --expose-gc');
  const rounds: number[] = [];
  for (let i = 0; i < 5; i++) {
    run(times);
    gc();
    const before = process.memoryUsage().heapUsed;
    run(times);
    // The reading itself allocates some kB: below a hundredth of a byte a run there is nothing.
    const perRun = (process.memoryUsage().heapUsed - before) / times;
    rounds.push(Math.abs(perRun) < 0.01 ? 0 : perRun);
  }
  return figure(name, 'bytes', rounds);
}

/** The figure of a name from its rounds. */
export function figure(name: string, unit: string, rounds: readonly number[]): Figure {
  const sorted = [...rounds].sort((a, b) => a - b);
  const at = (share: number) => round(sorted[Math.floor(share * (sorted.length - 1))]!);
  return { name, unit, median: at(0.5), min: at(0), max: at(1) };
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
