import { append } from '../elements';
import { GAUGES, type Samples, summarise } from '../../game/samples';

const COLUMNS = ['last', 'mean', 'p95', 'max'] as const;

/** The table beside the plots: last, mean, p95 and max of the last thirty seconds. */
export function createFigures(host: Element): (samples: Samples) => void {
  const table = append(host, 'table', 'figures');
  append(table, 'caption', 'unseen', 'Figures of the last thirty seconds');
  const head = append(append(table, 'thead'), 'tr');
  for (const title of ['Last 30 s', ...COLUMNS]) append(head, 'th', '', title).scope = 'col';
  const body = append(table, 'tbody');
  const rows = GAUGES.map(({ title, unit, digits }) => {
    const row = append(body, 'tr');
    append(row, 'th', '', `${title}, ${unit}`).scope = 'row';
    const cells = COLUMNS.map(() => append(row, 'td'));
    return { cells, digits };
  });
  return (samples) => {
    rows.forEach(({ cells, digits }, gauge) => {
      const summary = summarise(samples.values(gauge));
      COLUMNS.forEach((column, i) => {
        const value = summary[column];
        const text = Number.isFinite(value) ? value.toFixed(digits) : '–';
        if (cells[i]!.textContent !== text) cells[i]!.textContent = text;
      });
    });
  };
}
