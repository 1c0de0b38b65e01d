import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createRandom, type Random, NETWORK_PRESETS, type NetworkPreset } from '../../../src/scenarios';
import {
  createFaultyLine,
  type FaultyLine,
  type FaultyLineOptions,
  instantOf,
} from '../../prediction/faults/faultyLine';
import { type Fault, FAULTS } from './faultKinds';
import { type Figure, spread } from './figure';
import { createLeastRoundTrip, type LeastRoundTrip, serverTimeBy, takeAnswer } from './leastRoundTrip';

const RUNS = 200;
const SEED = 2026;
/** Time before the fault, s; and after it, beyond the allowed second or two ticks. */
const BEFORE = 8;
const AFTER = 10;
/** Length of the run without a fault, beyond the measured time, s. */
const USUAL = 20;
/** A larger error is wrong, s (PREDICTION, Clock). */
const WITHIN = 0.05;
const WITHIN_ON_LAN = 0.01;
const RATES = [0.1, 0.25, 1, 5, 20];
const DRIFT = 5e-4;
const COARSE = 0.1;
/** How long a state confirms in addition to interval and lead, s. */
const CONFIRMS = 0.05;

/** The result of one fault. */
interface Outcome {
  readonly fault: string;
  /** s from the end of the fault to the last wrong frame; 0 if none was wrong. */
  rightAfter: number;
  /** Worst error of the drawn instant from a second or two ticks on, s, relative to before the fault. */
  worstOff: number;
  worstKey: number;
  falselyConfirmed: number;
  /** The same for the reference clock. */
  yardstickRightAfter: number;
  yardstickOff: number;
  /** s allowed until it is right. */
  readonly allowed: number;
  readonly tolerance: number;
}

/** Random stalls, freezes, jumps, pauses, restarts, drift and coarse clocks: time until everything is right again. */
export function* faultFigures(): Generator<Figure> {
  const rng = createRandom(SEED);
  const outcomes = Array.from({ length: RUNS }, () => runFault(rng));
  const late = outcomes.map(({ rightAfter, allowed }) => Math.max(0, rightAfter - allowed));
  const lateYardstick = outcomes.map(({ yardstickRightAfter, allowed }) =>
    Math.max(0, yardstickRightAfter - allowed),
  );
  const note = `${RUNS} faults, seed ${SEED}; worst: ${worstOf(outcomes, late)}`;
  const ours = spread(late);
  const theirs = spread(lateYardstick);
  yield {
    name: 'faults: wrong for longer than 1 s or two ticks',
    unit: 's',
    ...ours,
    note,
    target: 'p95 0',
    met: ours.p95 === 0,
  };
  yield {
    name: 'faults: the same of a least-round-trip filter',
    unit: 's',
    ...theirs,
    target: 'the yardstick',
    met: true,
  };
  yield* comparedFigures(outcomes);
}

function* comparedFigures(outcomes: readonly Outcome[]): Generator<Figure> {
  const right = spread(outcomes.map(({ rightAfter }) => rightAfter));
  const yardstick = spread(outcomes.map(({ yardstickRightAfter }) => yardstickRightAfter));
  const off = spread(outcomes.map(({ worstOff }) => worstOff * 1000));
  const offYardstick = spread(outcomes.map(({ yardstickOff }) => yardstickOff * 1000));
  const key = spread(outcomes.map(({ worstKey }) => worstKey * 1000));
  const falsely = outcomes.reduce((sum, one) => sum + one.falselyConfirmed, 0);
  yield {
    name: 'faults: seconds until right again',
    unit: 's',
    ...right,
    target: `p50, p99 ≤ the yardstick’s`,
    met: right.p50 <= yardstick.p50 && right.p99 <= yardstick.p99,
    note: `yardstick p50 ${yardstick.p50.toFixed(2)}, p99 ${yardstick.p99.toFixed(2)}, worst ${yardstick.max.toFixed(2)}`,
  };
  yield {
    name: 'faults: instant drawn, off what it was before',
    unit: 'ms',
    ...off,
    target: 'p99 ≤ the yardstick’s',
    met: off.p99 <= offYardstick.p99,
    note: `yardstick p50 ${offYardstick.p50.toFixed(1)}, p99 ${offYardstick.p99.toFixed(1)}, worst ${offYardstick.max.toFixed(1)}`,
  };
  yield {
    name: 'faults: a key’s delay beyond what it was before',
    unit: 'ms',
    ...key,
    target: 'p99 ≤ 50',
    met: key.p99 <= 50,
  };
  yield {
    name: 'faults: frames confirmed that were not',
    unit: '',
    value: falsely,
    target: '0',
    met: falsely === 0,
  };
}

function worstOf(outcomes: readonly Outcome[], late: readonly number[]): string {
  const worst = late.indexOf(Math.max(...late));
  return outcomes[worst]!.fault;
}

function runFault(rng: Random): Outcome {
  const pick = <T>(list: readonly T[]): T => list[Math.floor(rng() * list.length)]!;
  const preset = pick(Object.keys(NETWORK_PRESETS) as NetworkPreset[]);
  const tickRate = pick(RATES);
  const drift = pick([0, DRIFT, -DRIFT]);
  const grain = pick([0, 0, COARSE]);
  const seconds = 0.3 * 2000 ** rng();
  const name = pick(Object.keys(FAULTS));
  const seed = Math.floor(rng() * 1e9);
  const make = () =>
    lineAndFilter({ network: NETWORK_PRESETS[preset], tickRate, drift, seed, hello: true }, grain);
  const allowed = Math.max(1, 2 / tickRate);
  const tolerance = (preset === 'lan' ? WITHIN_ON_LAN : WITHIN) + grain;
  const label = `${name} for ${seconds.toFixed(1)} s, ${preset}, ${tickRate} Hz, drift ${drift}, grain ${grain}`;
  const undisturbed = make();
  const usual = usualOf(undisturbed.line, undisturbed.filter, allowed + AFTER + USUAL);
  const { line, filter } = make();
  const how = { fault: label, happen: FAULTS[name]!, seconds, allowed, tolerance, tickRate, usual };
  return measure(line, filter, how);
}

/** A line, and the reference clock that receives the same pongs. */
function lineAndFilter(
  options: FaultyLineOptions,
  grain: number,
): { readonly line: FaultyLine; readonly filter: LeastRoundTrip } {
  const filter = createLeastRoundTrip();
  const onPong = (pinged: number, answered: number, now: number) => {
    takeAnswer(filter, pinged, answered, now);
  };
  const line = createFaultyLine({ ...options, onPong });
  if (grain > 0) line.pageClock = (now) => Math.floor(now / grain + 1e-9) * grain;
  return { line, filter };
}

interface Measuring {
  readonly usual: Usual;
  readonly fault: string;
  readonly happen: Fault;
  readonly seconds: number;
  readonly allowed: number;
  readonly tolerance: number;
  readonly tickRate: number;
}

function measure(line: FaultyLine, filter: LeastRoundTrip, how: Measuring): Outcome {
  const { fault, allowed, tolerance, tickRate } = how;
  const outcome: Outcome = {
    fault,
    allowed,
    tolerance,
    rightAfter: 0,
    worstOff: 0,
    worstKey: 0,
    falselyConfirmed: 0,
    yardstickRightAfter: 0,
    yardstickOff: 0,
  };
  line.run(Math.max(BEFORE, 3 / tickRate));
  how.happen(line, how.seconds);
  const since = line.now;
  let pressed = line.inputs.length;
  line.run(allowed + AFTER, (view) => {
    const after = line.now - since;
    const off = outside(instantOf(view) - line.serverNow(), how.usual.ours);
    const filtered = serverTimeBy(filter, line.pageClock(line.now));
    const offYardstick = outside(filtered - line.serverNow(), how.usual.yardstick);
    if (!(off <= tolerance)) outcome.rightAfter = after;
    if (!(offYardstick <= tolerance)) outcome.yardstickRightAfter = after;
    if (after < allowed) return;
    outcome.worstOff = Math.max(outcome.worstOff, off);
    outcome.yardstickOff = Math.max(outcome.yardstickOff, offYardstick);
    const reach = line.newestFrame + 1 / tickRate + view.diagnosis.lead + CONFIRMS;
    if (view.own?.provenance === 'confirmed' && instantOf(view) > reach) outcome.falselyConfirmed += 1;
    pressEachSecond(line, after);
    for (; pressed < line.inputs.length; pressed++)
      outcome.worstKey = Math.max(outcome.worstKey, delayOf(line, pressed, tickRate) - how.usual.key);
  });
  return outcome;
}

/** Difference of largest and smallest. */
type Range = readonly [number, number];

/** Time by which the view, and the reference clock, are ahead of the server without faults. */
interface Usual {
  readonly ours: Range;
  readonly yardstick: Range;
  /** Delay of a key, s. */
  readonly key: number;
}

function usualOf(line: FaultyLine, filter: LeastRoundTrip, seconds: number): Usual {
  const ours = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY] as [number, number];
  const yardstick = [...ours] as [number, number];
  line.run(Math.max(BEFORE, 3 / line.tickRate));
  const first = line.inputs.length;
  const from = line.now;
  line.run(seconds, (view) => {
    pressEachSecond(line, line.now - from);
    widen(ours, instantOf(view) - line.serverNow());
    widen(yardstick, serverTimeBy(filter, line.pageClock(line.now)) - line.serverNow());
  });
  const keys = line.inputs.slice(first).map((_, i) => delayOf(line, first + i, line.tickRate));
  return { ours, yardstick, key: Math.max(...keys) };
}

function pressEachSecond(line: FaultyLine, seconds: number): void {
  line.controls =
    Math.floor(seconds) % 2 === 0 ? { ...NEUTRAL_CONTROLS, attitudeHold: true } : NEUTRAL_CONTROLS;
}

function widen(range: [number, number], value: number): void {
  range[0] = Math.min(range[0], value);
  range[1] = Math.max(range[1], value);
}

function outside(value: number, [least, most]: Range): number {
  return Number.isNaN(value) ? Number.POSITIVE_INFINITY : Math.max(0, value - most, least - value);
}

/** From sending to the substep at which it acts, server s. */
function delayOf(line: FaultyLine, index: number, tickRate: number): number {
  const { record, sentAt } = line.inputs[index]!;
  const substeps = Math.ceil(100 / tickRate);
  return record.tick / tickRate + record.substep / substeps / tickRate - sentAt;
}
