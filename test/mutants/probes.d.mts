export interface Block {
  readonly start: number;
  readonly end: number;
  readonly isExpression: boolean;
}
export function blocksOf(path: string, text: string): Block[];
export function blockAt(blocks: readonly Block[], start: number): number;
export function withProbes(path: string, text: string): string;
