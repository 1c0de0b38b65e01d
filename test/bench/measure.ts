/** One figure of a benchmark. */
export interface Figure {
  readonly name: string;
  readonly unit: string;
  readonly median: number;
  readonly min: number;
  readonly max: number;
}

/** Rounds timed after the warm-up: the figure is their median. */
const ROUNDS = 15;
/** Wall ms that a case runs before it is timed, so that it is fully compiled. */
const WARM_UP = 600;

/**
 * Times `run(times)`, which runs the subject that many times.
 * @param each number of units per run, e.g. substeps: the figure is per unit
 */
export function timed(name: string, times: number, each: number, run: (times: number) => void): Figure {
  warmUp(times, run);
  const rounds: number[] = [];
  for (let i = 0; i < ROUNDS; i++) {
    const from = process.hrtime.bigint();
    run(times);
    rounds.push(Number(process.hrtime.bigint() - from) / (times * each));
  }
  return figure(name, 'ns', rounds);
}

/** Parts that the runs of a heap figure are cut into. */
const HEAP_PARTS = 100;

/**
 * Bytes of heap that one of `times` runs allocates, garbage included. Allocation of the runs is the same in each part, and so
 * shows in the median; the compiler's (0.2 MB each time) is in a few parts; and a part in which the collector ran
 * is left out.
 */
export function heapGrowth(name: string, times: number, run: (times: number) => void): Figure {
  warmUp(times, run);
  const runs = times / HEAP_PARTS;
  const reading = median(heapParts(0, run));
  const parts = heapParts(runs, run).map((grown) => (grown - reading) / runs);
  return figure(name, 'bytes', parts);
}

/** Growth of the heap over each part of `runs` runs, bytes, including that of the reading. @throws if nearly all parts had a collection */
function heapParts(runs: number, run: (times: number) => void): number[] {
  const parts: number[] = [];
  for (let tried = 0; parts.length < HEAP_PARTS; tried++) {
    if (tried > 20 * HEAP_PARTS) throw new Error(`${runs} runs fill the young generation: measure fewer`);
    const before = process.memoryUsage().heapUsed;
    run(runs);
    const grown = process.memoryUsage().heapUsed - before;
    if (grown >= 0) parts.push(grown);
  }
  return parts;
}

function warmUp(times: number, run: (times: number) => void): void {
  const warm = performance.now() + WARM_UP;
  while (performance.now() < warm) run(times);
}

/** The figure of these rounds under a name. */
export function figure(name: string, unit: string, rounds: readonly number[]): Figure {
  const ends = [Math.min(...rounds), Math.max(...rounds)] as const;
  return { name, unit, median: round(median(rounds)), min: round(ends[0]), max: round(ends[1]) };
}

/** How many times one figure is another, by their medians, and by the rounds that are furthest apart. */
export function ratio(name: string, one: Figure, other: Figure): Figure {
  return {
    name,
    unit: '×',
    median: round(one.median / other.median),
    min: round(one.min / other.max),
    max: round(one.max / other.min),
  };
}

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor((values.length - 1) / 2)]!;
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
