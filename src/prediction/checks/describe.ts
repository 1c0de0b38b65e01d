/** A short description of a value that was found instead of the expected one, for messages to developers. */
export function describe(value: unknown): string {
  if (typeof value === 'string')
    return value.length <= 40 ? JSON.stringify(value) : `a string of ${value.length} characters`;
  if (typeof value === 'function') return 'a function';
  if (typeof value !== 'object' || value === null) return String(value);
  if (Array.isArray(value))
    return value.length <= 4 ? `[${value.map(describeEntry).join(', ')}]` : listOf(value);
  const kind = kindOf(value);
  if (kind !== 'Object') return /^[AEIOU]/.test(kind) ? `an ${kind}` : `a ${kind}`;
  const names = Object.keys(value);
  return `{ ${names.slice(0, 5).join(', ')}${names.length > 5 ? ', …' : ''} }`;
}

/** Lists in a list only by their length: they may be nested to any depth. */
const describeEntry = (value: unknown): string => (Array.isArray(value) ? listOf(value) : describe(value));

const listOf = ({ length }: readonly unknown[]): string => `a list of ${length}`;

/** 'Promise', 'Blob', 'MessageEvent', 'Float32Array', …; 'Object' for a plain record. */
export function kindOf(value: object): string {
  return Object.prototype.toString.call(value).slice(8, -1);
}
