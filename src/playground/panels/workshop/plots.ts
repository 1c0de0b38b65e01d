import { append } from '../elements';
import type Plotting from './plotting';
import { type GaugeName, GAUGES, type Samples } from '../../game/samples';

/** Which gauges share a plot. */
const PLOTS: readonly PlotKind[] = [
  { title: 'Position, m', gauges: ['errorPosition', 'offsetPosition'], base: 0, least: 0.001 },
  { title: 'Attitude, °', gauges: ['errorAngle', 'offsetAngle'], base: 0, least: 0.01 },
  { title: 'Network, ms', gauges: ['roundTrip', 'lead', 'jitter'], base: 0, least: 10 },
  { title: 'Clock', gauges: ['clockRate'], base: 1, least: 0.001 },
];

interface PlotKind {
  readonly title: string;
  readonly gauges: readonly GaugeName[];
  /** A value that is always on the axis, and how far the axis reaches from it at least. */
  readonly base: number;
  readonly least: number;
}

/** The axis of a plot: without a range, errors of zero would get an axis to 100. */
export function axisRange({ base, least }: Pick<PlotKind, 'base' | 'least'>, low: number, high: number) {
  const top = Math.max(Number.isFinite(high) ? high : base, base + least);
  const bottom = Math.min(Number.isFinite(low) ? low : base, base);
  return [bottom, top + 0.05 * (top - bottom)] as const;
}
const HEIGHT = 92;
const STROKES = ['#ffd24a', '#58b8ff', '#ff9d92'] as const;
/** Lines of one plot differ in more than colour; px drawn and left out. */
const DASHES = [[], [6, 3], [2, 3]] as const;

type Setter = (samples: Samples) => void;

/** Paints the plots; the first call loads the plotting code. */
export function createPlots(host: Element): (samples: Samples) => void {
  const holder = append(host, 'div', 'plots');
  let plots: readonly Setter[] = [];
  let state: 'idle' | 'loading' | 'ready' = 'idle';

  const load = async () => {
    state = 'loading';
    holder.replaceChildren();
    const waiting = append(holder, 'p', 'quiet', 'Loading the plots …');
    try {
      const { default: Plot } = await import('./plotting');
      waiting.remove();
      plots = PLOTS.map((plot) => createPlot(Plot, holder, plot));
      state = 'ready';
    } catch {
      waiting.textContent =
        'The plots did not load. Check the network and reload; the figures work meanwhile.';
    }
  };

  return (samples) => {
    if (state === 'idle') void load();
    for (const show of plots) show(samples);
  };
}

function createPlot(Plot: typeof Plotting, holder: Element, kind: PlotKind): Setter {
  const { title, gauges } = kind;
  const rings = gauges.map((name) => GAUGES.findIndex((gauge) => gauge.name === name));
  const series = rings.map((ring, i) => ({
    label: GAUGES[ring]!.title,
    stroke: STROKES[i]!,
    dash: [...DASHES[i]!],
    width: 1.5,
  }));
  const axis = {
    stroke: getComputedStyle(holder).color,
    grid: { stroke: 'rgba(128,144,160,0.25)', width: 1 },
    ticks: { show: false },
  };
  const place = append(holder, 'div');
  const made = new Plot(
    {
      title,
      width: Math.max(200, place.clientWidth),
      height: HEIGHT,
      legend: { live: false },
      cursor: { show: false },
      scales: {
        x: { time: false },
        y: { range: (_, low, high) => [...axisRange(kind, low, high)] },
      },
      axes: [
        { ...axis, size: 20 },
        { ...axis, size: 46, values: (_, splits) => splits.map(tickText) },
      ],
      series: [{}, ...series],
    },
    [[], ...gauges.map(() => [])],
    place,
  );
  return (samples) => {
    const times = samples.times();
    const newest = times.at(-1) ?? 0;
    const ago = times.map((time) => time - newest);
    made.setData([ago, ...rings.map((ring) => samples.values(ring).map(orGap))]);
  };
}

/** Errors are millimetres and less: ticks need digits enough to differ. */
function tickText(value: number): string {
  return value === 0 || Math.abs(value) >= 0.001
    ? String(Number(value.toPrecision(4)))
    : value.toExponential(0);
}

/** Unknown values are gaps in the line. */
function orGap(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}
