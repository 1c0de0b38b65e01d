/** Values that callers pass by mistake instead of a parsed message, and what to do about each. */

/** The kind of a value that is not a plain object, with advice; null for a plain object. */
export function notPlain(value: unknown): string | null {
  if (typeof value === 'string') return 'a string: parse it with JSON.parse first';
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return null;
  const kind = Object.prototype.toString.call(value).slice(8, -1);
  const todo = TODO[kind] ?? (ArrayBuffer.isView(value) ? BYTES : '');
  if (todo !== '') return `a ${kind}: ${todo}`;
  if (kind !== 'Object' && 'data' in value) return `an event: its .data holds the text of the message`;
  const { ok, value: held } = value as { ok?: unknown; value?: unknown };
  if (typeof ok === 'boolean' && held !== undefined)
    return 'a Result: it is already decoded, check .ok and pass .value';
  return null;
}

const BYTES = 'bytes are decoded with decodeServerMessage of the protobuf entry';
const TODO: Readonly<Record<string, string>> = {
  Promise: 'await it first',
  Blob: 'await its text(), and parse that with JSON.parse',
  ArrayBuffer: BYTES,
};

/** Where a message's fields are, if it is still in its envelope: in the member that holds all of these names. Null if it is not. */
export function wrapped(envelope: unknown, names: readonly string[]): string | null {
  if (typeof envelope !== 'object' || envelope === null) return null;
  const holds = (inner: unknown): boolean =>
    typeof inner === 'object' && inner !== null && names.every((name) => Object.hasOwn(inner, name));
  const member = Object.entries(envelope).find(([, inner]) => holds(inner))?.[0];
  return member === undefined ? null : `missing; it is in the message's ${member}: pass that`;
}
