import { append } from './elements';
import { GAUGES, type Samples } from './samples';

/** Which gauges share a plot. */
const PLOTS: readonly { readonly title: string; readonly gauges: readonly number[] }[] = [
  { title: 'Correction being eased, m', gauges: [5] },
  { title: 'Correction being eased, °', gauges: [6] },
  { title: 'Round trip, lead, jitter, ms', gauges: [0, 2, 1] },
  { title: 'Clock rate', gauges: [4] },
];
const HEIGHT = 92;
const STROKES = ['#ffd24a', '#58b8ff', '#ff9d92'] as const;

/** Paints the plots; fetches the plotting code when it is first asked to. */
export function createPlots(host: Element): (samples: Samples) => void {
  const holder = append(host, 'div', 'plots');
  const plots: { readonly setData: (data: number[][]) => void }[] = [];
  let state: 'idle' | 'loading' | 'ready' | 'failed' = 'idle';

  const load = async () => {
    state = 'loading';
    const waiting = append(holder, 'p', 'quiet', 'Fetching the plots …');
    try {
      const { default: UPlot } = await import('./plotting');
      waiting.remove();
      for (const { title, gauges } of PLOTS) {
        const series = gauges.map((gauge, i) => ({
          label: GAUGES[gauge]!.title,
          stroke: STROKES[i]!,
          width: 1.5,
        }));
        const ink = getComputedStyle(host).color;
        const axis = {
          stroke: ink,
          grid: { stroke: 'rgba(128,144,160,0.25)', width: 1 },
          ticks: { show: false },
        };
        const made = new UPlot(
          {
            title,
            width: Math.max(200, holder.clientWidth),
            height: HEIGHT,
            legend: { show: false },
            cursor: { show: false },
            scales: { x: { time: false } },
            axes: [
              { ...axis, size: 20 },
              { ...axis, size: 46 },
            ],
            series: [{}, ...series],
          },
          [[], ...gauges.map(() => [])],
          append(holder, 'div'),
        );
        plots.push({ setData: ([x = [], ...rest]) => made.setData([x, ...rest]) });
      }
      state = 'ready';
    } catch {
      state = 'failed';
      waiting.textContent =
        'The plots could not be fetched: is the network off? The table beside them still holds.';
    }
  };

  return (samples) => {
    if (state === 'idle') void load();
    if (state !== 'ready') return;
    const times = samples.times();
    const newest = times.at(-1) ?? 0;
    const ago = times.map((time) => time - newest);
    PLOTS.forEach(({ gauges }, i) => plots[i]!.setData([ago, ...gauges.map(samples.values)]));
  };
}
