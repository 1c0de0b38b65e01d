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
  const rounds = timerOf(times, run)(ROUNDS);
  return figure(
    name,
    'ns',
    rounds.map((ns) => ns / each),
  );
}

/** Passes of a comparison, and rounds of each case in a pass. */
const PASSES = 15;
const ROUNDS_PER_PASS = 3;

/** Times `rounds` rounds, ns each. */
export type Timer = (rounds: number) => readonly number[];

/** A timer of `run(times)`, ns per unit, once it is fully compiled. */
export function timerOf(times: number, run: (times: number) => void): Timer {
  warmUp(times, run);
  return (rounds) =>
    Array.from({ length: rounds }, () => {
      const from = process.hrtime.bigint();
      run(times);
      return Number(process.hrtime.bigint() - from) / times;
    });
}

/**
 * Times cases in turn, pass by pass: other programs, and on a rented machine other tenants, slow it down for seconds, by up to 1.8 ×,
 * and so slow all cases of a pass alike.
 * @returns for each case the median of each pass, ns
 */
export function timedInTurn(timers: readonly Timer[]): readonly (readonly number[])[] {
  const passes = timers.map((): number[] => []);
  for (let pass = 0; pass < PASSES; pass++)
    timers.forEach((timer, i) => passes[i]!.push(median(timer(ROUNDS_PER_PASS))));
  return passes;
}

/** How many times one case's time is another's, of cases timed in turn: the median of the passes. */
export function ratioInTurn(name: string, one: readonly number[], other: readonly number[]): Figure {
  return figure(
    name,
    '×',
    one.map((time, i) => time / other[i]!),
  );
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

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor((values.length - 1) / 2)]!;
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
