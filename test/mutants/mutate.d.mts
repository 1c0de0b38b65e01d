export interface Change {
  readonly start: number;
  readonly end: number;
  readonly text: string;
  readonly line: number;
  readonly says: string;
}
export function changesOf(path: string, text: string): Change[];
export function sampleOf<T>(items: readonly T[], count: number, seed: number): T[];
