import type { Warn } from '../warnings';

/** Names in other spellings: snake_case, other capitals, "ID" for "Id". */
const plain = (name: string): string => name.replace(/[^a-z0-9]/gi, '').toLowerCase();

/** The known name that was probably meant, or '' for none. */
export function nearestName(given: string, known: readonly string[]): string {
  const wanted = plain(given);
  const same = known.find((name) => plain(name) === wanted);
  if (same !== undefined) return same;
  const near = known.find((name) => plain(name).includes(wanted) || wanted.includes(plain(name)));
  return near ?? '';
}

/** How the member names of a record are checked. */
export interface Naming {
  readonly code: string;
  /** Path of the record, for the message. */
  readonly path: string;
  readonly known: readonly string[];
}

/** Warns of each member of `given` with an unknown name, with the name that was probably meant. */
export function warnOfUnknown(warn: Warn, { code, path, known }: Naming, given: object): void {
  for (const field of Object.keys(given)) {
    if (known.includes(field)) continue;
    const nearest = nearestName(field, known);
    const hint = nearest === '' ? `Known: ${known.join(', ')}.` : `Did you mean ${nearest}?`;
    const value = (given as Readonly<Record<string, unknown>>)[field];
    warn(code, `${path}.${field} is unknown and has no effect. ${hint}`, { field, value, nearest });
  }
}
