/** One line of the bench: a figure with its unit, its target, and whether the target is met. */
export interface Figure {
  readonly name: string;
  readonly unit: string;
  readonly value?: number;
  readonly p50?: number;
  readonly p95?: number;
  readonly p99?: number;
  readonly max?: number;
  readonly target: string;
  readonly met: boolean;
  /** A timing or a heap size, which varies between runs. All others have the same bits in every run. */
  readonly timing?: boolean;
  readonly note?: string;
}

/** Percentiles of a list of numbers; the list is sorted. */
export function spread(values: number[]): { p50: number; p95: number; p99: number; max: number } {
  const sorted = Float64Array.from(values).sort();
  const at = (share: number) =>
    sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? Number.NaN;
  return { p50: at(0.5), p95: at(0.95), p99: at(0.99), max: sorted.at(-1) ?? Number.NaN };
}

export function print(figure: Figure, asJson: boolean): void {
  if (asJson) {
    console.log(JSON.stringify(figure));
    return;
  }
  const { name, unit, target, met, note } = figure;
  const values = (['value', 'p50', 'p95', 'p99', 'max'] as const)
    .filter((key) => figure[key] !== undefined)
    .map((key) => `${key === 'value' ? '' : `${key} `}${shortened(figure[key]!)}`)
    .join(', ');
  console.log(
    `${met ? 'ok  ' : 'MISS'} ${name}: ${values} ${unit} (target ${target})${note === undefined ? '' : ` – ${note}`}`,
  );
}

function shortened(value: number): string {
  return Number.isInteger(value) ? String(value) : value.toPrecision(4);
}
