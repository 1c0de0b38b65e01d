import type { Result } from '../../dynamics';
import {
  beginReading,
  describe,
  endReading,
  type Fields,
  fieldsOf,
  type Reading,
  refuse,
  type Step,
  valueIn,
} from '../fields/reading';

/** One pass over a JSON message whose parts are accepted or refused individually. */
export interface JsonPass {
  /** Path and reason of each part left out, in the order of the message. */
  readonly refusals: string[];
}

/** A list whose entries are read one by one, or an object of them by `key`. */
export interface EntryList<T> {
  readonly name: string;
  readonly most: number;
  /** The field that an object's key gives, unique in the list; null for none. */
  readonly key: string | null;
  readonly read: (r: Reading, from: Fields) => T;
}

/**
 * The valid entries; each invalid one leaves a refusal. Undefined if the list is absent or no list.
 */
export function entriesIn<T>(pass: JsonPass, from: Fields, list: EntryList<T>): T[] | undefined {
  const root = beginReading('json');
  const sent = valueIn(root, from, list.name);
  if (sent === undefined) return undefined;
  const entries = listed(sent, list);
  if (typeof entries === 'string') {
    pass.refusals.push(`${list.name}: ${entries}`);
    return undefined;
  }
  const items: T[] = [];
  const seen = new Set<unknown>();
  for (const [step, value] of entries) {
    const r = beginReading('json', list.name, step);
    const fields = withKey(r, fieldsOf(r, value), list, step);
    const item = endReading(r, list.read(r, fields));
    if (!item.ok) pass.refusals.push(item.reason);
    else if (isRepeated(seen, fields, list)) {
      refuse(r, list.key ?? '', 'expected each once');
      pass.refusals.push(r.reason ?? '');
    } else items.push(item.value);
  }
  return items;
}

/** Reads a single part of the message: undefined if it is absent or refused. */
export function partIn<T>(
  pass: JsonPass,
  from: Fields,
  name: string,
  read: (r: Reading) => T,
): T | undefined {
  const r = beginReading('json');
  if (valueIn(r, from, name) === undefined) return undefined;
  const part: Result<T> = endReading(r, read(r));
  if (part.ok) return part.value;
  pass.refusals.push(part.reason);
  return undefined;
}

/** Longest key shown in a path. */
const MAX_STEP = 40;

function listed<T>(sent: unknown, { most }: EntryList<T>): [Step, unknown][] | string {
  if (typeof sent !== 'object' || sent === null) return `expected a list or an object, got ${describe(sent)}`;
  const count = Array.isArray(sent) ? sent.length : Object.keys(sent).length;
  if (count > most) return `expected at most ${most}, got ${count}`;
  if (Array.isArray(sent)) return sent.map((value: unknown, i) => [i, value]);
  return Object.entries(sent).map(([key, value]) => [`[${JSON.stringify(key)}]`, value]);
}

/** The fields, with the object's key added as one of them. */
function withKey<T>(r: Reading, fields: Fields, { key }: EntryList<T>, step: Step): Fields {
  if (key === null || typeof step === 'number') return fields;
  const name = JSON.parse(step.slice(1, -1)) as string;
  if (step.length > MAX_STEP) r.path[1] = `["${name.slice(0, MAX_STEP)}…"]`;
  const own = valueIn(r, fields, key) ?? name;
  if (own !== name) refuse(r, key, `expected ${describe(name)}, got ${describe(own)}`);
  return { ...fields, [key]: name };
}

function isRepeated<T>(seen: Set<unknown>, fields: Fields, { key }: EntryList<T>): boolean {
  if (key === null) return false;
  const value = valueIn(beginReading('json'), fields, key);
  return seen.size === seen.add(value).size;
}
