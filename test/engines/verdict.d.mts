/** Types of verdict.mjs. */
export interface Answer {
  readonly family: string;
  readonly label?: string;
  readonly missing?: string;
  readonly failure?: string;
  readonly lines?: readonly string[];
}
export function describeAnswer(
  answer: Answer,
  reference: readonly string[],
): { readonly line: string; readonly agrees: boolean; readonly fails: boolean };
export function verdictOf(
  answers: readonly Answer[],
  pinned: string,
): { readonly summary: string; readonly complaints: readonly string[] };
