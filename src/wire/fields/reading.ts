import { describe as describeNumbers, type Result, ok, err } from '../../dynamics';
import { type Bound, MAX_TEXT } from '../limits';

/**
 * One pass over an untrusted message, the same for a decoded protobuf message and for JSON (the generated codec
 * keeps the proto's names). Every reader below takes the field `name` of `from` and returns a value that is always of its
 * type. The first invalid field leaves its reason here, and the whole message is refused.
 */
export interface Reading {
  /** Protobuf omits values that are 0, false or empty; JSON omits unsent ones. */
  readonly source: 'protobuf' | 'json';
  /** Path of the pass: names, and indices into lists. */
  readonly path: Step[];
  /** Reason of the first refusal, with the path of the field. */
  reason: string | null;
}

/** A name, an index into a list, or a key of an object from outside, already quoted: ["ship-1"]. */
export type Step = string | number;

export type Fields = Readonly<Record<string, unknown>>;

const NO_FIELDS: Fields = Object.freeze({});

export function beginReading(source: Reading['source'], ...path: Step[]): Reading {
  return { source, path, reason: null };
}

/** The message, or the reason why it is refused. */
export function endReading<T>(r: Reading, message: T): Result<T> {
  return r.reason === null ? ok(message) : err(r.reason);
}

/** Refuses the message because of the field `name` (empty: because of the value at the path itself). */
export function refuse(r: Reading, name: string, complaint: string): void {
  if (r.reason !== null) return;
  const steps = name === '' ? r.path : [...r.path, name];
  let path = '';
  for (const step of steps) {
    if (typeof step === 'number') path += `[${step}]`;
    else path += path === '' || step.startsWith('[') ? step : `.${step}`;
  }
  r.reason = `${path === '' ? 'message' : path}: ${complaint}`;
}

/** The field, or undefined: own properties only, null counts as not sent. JSON may spell `name` in camelCase too. */
export function valueIn(r: Reading, from: Fields, name: string): unknown {
  if (Object.hasOwn(from, name)) return from[name] ?? undefined;
  if (r.source === 'protobuf') return undefined;
  const spelled = inCamelCase(name);
  return Object.hasOwn(from, spelled) ? (from[spelled] ?? undefined) : undefined;
}

/** `value` as fields. If it is not an object, the message is refused and there are none. */
export function fieldsOf(r: Reading, value: unknown): Fields {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Fields;
  refuse(r, '', value === undefined ? 'missing' : `expected an object, got ${describe(value)}`);
  return NO_FIELDS;
}

/** Reads the submessage `name` with `read`; refused when it is missing. */
export function messageIn<T>(r: Reading, from: Fields, name: string, read: (r: Reading, f: Fields) => T): T {
  r.path.push(name);
  const message = read(r, fieldsOf(r, valueIn(r, from, name)));
  r.path.pop();
  return message;
}

/** At most `most` submessages; none when the list is not sent. */
export function listIn<T>(
  r: Reading,
  from: Fields,
  name: string,
  most: number,
  read: (r: Reading, f: Fields) => T,
): T[] {
  const list = valueIn(r, from, name) ?? [];
  const items: T[] = [];
  if (!Array.isArray(list)) refuse(r, name, `expected a list, got ${describe(list)}`);
  else if (list.length > most) refuse(r, name, `expected at most ${most}, got ${list.length}`);
  else {
    r.path.push(name, 0);
    for (let i = 0; i < list.length && r.reason === null; i++) {
      r.path[r.path.length - 1] = i;
      items.push(read(r, fieldsOf(r, list[i])));
    }
    r.path.length -= 2;
  }
  return items;
}

/** Refuses a list in which two items have the same `key` text. */
export function refuseRepeats(r: Reading, list: string, key: string, texts: readonly string[]): void {
  if (new Set(texts).size === texts.length) return;
  const seen = new Set<string>();
  const repeated = texts.findIndex((text) => seen.size === seen.add(text).size);
  refuse(r, `${list}[${repeated}].${key}`, `expected each once, got ${describe(texts[repeated])} again`);
}

/** A finite number within `bound`. If not sent: `absent`; in JSON, refused without one. */
export function numberIn(r: Reading, from: Fields, name: string, bound: Bound, absent?: number): number {
  const value = plainNumber(r, valueIn(r, from, name)) ?? absent ?? zeroOf(r);
  if (typeof value !== 'number' || !Number.isFinite(value)) {
    refuse(r, name, value === undefined ? 'missing' : `expected a finite number, got ${describe(value)}`);
    return NaN;
  }
  if (value >= bound.low && value <= bound.high) return value;
  refuse(r, name, `expected ${bound.low} to ${bound.high}${inUnit(bound)}, got ${value}`);
  return NaN;
}

function inUnit({ unit }: Bound): string {
  return unit === '' ? '' : ` ${unit}`;
}

/** A whole number from `low` to `high`, at most 2⁵³ − 1; 0 when it is not sent. Converts 64-bit integers of the codec. */
export function integerIn(r: Reading, from: Fields, name: string, low: number, high: number): number {
  const value = wholeNumber(r, plainNumber(r, valueIn(r, from, name)) ?? 0) as number;
  if (Number.isSafeInteger(value) && value >= low && value <= high) return value;
  refuse(r, name, `expected a whole number from ${low} to ${high}, got ${describe(value)}`);
  return low;
}

/** A well-formed string of at most MAX_TEXT characters; empty when it is not sent. */
export function textIn(r: Reading, from: Fields, name: string): string {
  const value = valueIn(r, from, name) ?? '';
  const complaint = textFault(value);
  if (complaint === null) return value as string;
  refuse(r, name, complaint);
  return '';
}

/** Why `value` cannot be sent as a name or an id, or null. */
export function textFault(value: unknown): string | null {
  if (typeof value !== 'string') return `expected a string, got ${describe(value)}`;
  if (value.length > MAX_TEXT) return `expected at most ${MAX_TEXT} characters, got ${value.length}`;
  return LONE_SURROGATE.test(value) ? 'expected well-formed Unicode' : null;
}

/** A non-empty string. */
export function nameIn(r: Reading, from: Fields, name: string): string {
  const text = textIn(r, from, name);
  if (text === '') refuse(r, name, 'expected a non-empty string');
  return text;
}

/** One of `choices`; the first of them when it is not sent or empty and `mayBeEmpty`. */
export function choiceIn<T extends string>(
  r: Reading,
  from: Fields,
  name: string,
  choices: readonly [T, ...T[]],
  mayBeEmpty: boolean,
): T {
  const value = valueIn(r, from, name) ?? '';
  const found = choices.find((choice) => choice === value);
  if (found !== undefined) return found;
  const listed = choices.map((choice) => JSON.stringify(choice)).join(', ');
  if (value !== '' || !mayBeEmpty) refuse(r, name, `expected one of ${listed}, got ${describe(value)}`);
  return choices[0];
}

/** True or false; false when it is not sent. */
export function flagIn(r: Reading, from: Fields, name: string): boolean {
  const value = valueIn(r, from, name) ?? false;
  if (typeof value === 'boolean') return value;
  if (r.source === 'json' && (value === 'true' || value === 'false')) return value === 'true';
  refuse(r, name, `expected true or false, got ${describe(value)}`);
  return false;
}

/** Describes an untrusted value for a reason: short, and always printable. */
export function describe(value: unknown): string {
  if (typeof value !== 'string') return describeNumbers(value);
  return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
}

const LONE_SURROGATE = /\p{Surrogate}/u;
/** A decimal number as Redis stores it. */
const DECIMAL = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$/;
/** No double needs more characters. */
const MAX_DECIMAL = 64;

/** A number that JSON sent as a string, as a number; anything else unchanged. */
function plainNumber(r: Reading, value: unknown): unknown {
  if (r.source === 'protobuf' || typeof value !== 'string') return value;
  return value.length <= MAX_DECIMAL && DECIMAL.test(value) ? Number(value) : value;
}

const camelCaseOf = new Map<string, string>();

function inCamelCase(name: string): string {
  let spelled = camelCaseOf.get(name);
  if (spelled === undefined) {
    spelled = name.replace(/_(\w)/g, (_, letter: string) => letter.toUpperCase());
    camelCaseOf.set(name, spelled);
  }
  return spelled;
}

function zeroOf(r: Reading): number | undefined {
  return r.source === 'protobuf' ? 0 : undefined;
}

/** The double nearest to the codec's unsigned 64-bit integer; anything else unchanged. */
function wholeNumber(r: Reading, value: unknown): unknown {
  if (r.source === 'json') return value;
  const { high, low } = Object(value) as { readonly high?: unknown; readonly low?: unknown };
  if (typeof high !== 'number' || typeof low !== 'number') return value;
  return (high >>> 0) * 4294967296 + (low >>> 0);
}
