import type { Warn } from '../warnings';

/** Names as people write them alike: snake_case, other capitals, "ID" for "Id". */
const plain = (name: string): string => name.replace(/[^a-z0-9]/gi, '').toLowerCase();

/** The known name that was probably meant, or ''. */
export function nearestName(given: string, known: readonly string[]): string {
  const wanted = plain(given);
  const same = known.find((name) => plain(name) === wanted);
  if (same !== undefined) return same;
  const near = known.find((name) => plain(name).includes(wanted) || wanted.includes(plain(name)));
  return near ?? '';
}

/** What a record of names is checked for. */
export interface Naming {
  readonly code: string;
  /** Path of the record, for the message. */
  readonly path: string;
  readonly known: readonly string[];
}

/** Warns of each member of `given` whose name is not known, with the name that was probably meant. */
export function warnOfUnknown(warn: Warn, { code, path, known }: Naming, given: object): void {
  for (const field of Object.keys(given)) {
    if (known.includes(field)) continue;
    const nearest = nearestName(field, known);
    const hint = nearest === '' ? `Known are ${known.join(', ')}.` : `Did you mean ${nearest}?`;
    const value = (given as Readonly<Record<string, unknown>>)[field];
    warn(code, `${path}.${field} is not known and has no effect. ${hint}`, { field, value, nearest });
  }
}
