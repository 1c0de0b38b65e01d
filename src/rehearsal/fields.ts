import type { Quat, Vec3 } from '../dynamics';

/**
 * Reading what came from outside: every getter gives a value of the right type whatever it was handed, and the first thing that
 * was not as it must be is kept as the reason. Nothing throws; who asks `reason()` once at the end has asked for all.
 */
export interface Fields {
  /** The first fault, naming the field, or null. */
  readonly reason: () => string | null;
  readonly fault: (path: string, message: string) => void;
  readonly record: (value: unknown, path: string) => JsonRecord;
  /** At most `most` items; each with its path. */
  readonly list: (value: unknown, path: string, most: number) => readonly { value: unknown; path: string }[];
  readonly number: (value: unknown, path: string) => number;
  /** A whole number from `least` on that a double holds exactly. */
  readonly whole: (value: unknown, path: string, least: number) => number;
  /** At most 1,000 characters. */
  readonly text: (value: unknown, path: string) => string;
  readonly flag: (value: unknown, path: string) => boolean;
  readonly choice: <T extends string>(value: unknown, path: string, choices: readonly T[]) => T;
  readonly vec3: (value: unknown, path: string) => Vec3;
  /** Any four numbers [x, y, z, w]. */
  readonly vec4: (value: unknown, path: string) => Quat;
  /** [x, y, z, w], length 1 within 1e-3. */
  readonly quat: (value: unknown, path: string) => Quat;
}

/** A JSON object's own members; absent ones read as undefined. */
export type JsonRecord = Readonly<Record<string, unknown>>;

const LONGEST_TEXT = 1000;

export function createFields(): Fields {
  let first: string | null = null;

  function fault(path: string, message: string): void {
    first ??= `${path}: ${message}`;
  }

  function record(value: unknown, path: string): JsonRecord {
    if (typeof value === 'object' && value !== null && !Array.isArray(value))
      // A copy without a prototype: a member named __proto__ or toString is absent unless it was sent.
      return Object.assign(Object.create(null) as object, value) as JsonRecord;
    fault(path, `expected an object, got ${describe(value)}`);
    return Object.create(null) as JsonRecord;
  }

  function list(value: unknown, path: string, most: number): { value: unknown; path: string }[] {
    if (!Array.isArray(value)) fault(path, `expected a list, got ${describe(value)}`);
    else if (value.length > most) fault(path, `expected at most ${most} items, got ${value.length}`);
    else return value.map((item: unknown, i) => ({ value: item, path: `${path}[${i}]` }));
    return [];
  }

  function number(value: unknown, path: string): number {
    if (typeof value === 'number' && Number.isFinite(value)) return value;
    fault(path, `expected a finite number, got ${describe(value)}`);
    return 0;
  }

  function whole(value: unknown, path: string, least: number): number {
    if (typeof value === 'number' && Number.isSafeInteger(value) && value >= least) return value;
    fault(path, `expected a whole number ≥ ${least}, got ${describe(value)}`);
    return least;
  }

  function text(value: unknown, path: string): string {
    if (typeof value === 'string' && value.length <= LONGEST_TEXT) return value;
    fault(path, `expected a text of at most ${LONGEST_TEXT} characters, got ${describe(value)}`);
    return '';
  }

  function flag(value: unknown, path: string): boolean {
    if (typeof value === 'boolean') return value;
    fault(path, `expected true or false, got ${describe(value)}`);
    return false;
  }

  function choice<T extends string>(value: unknown, path: string, choices: readonly T[]): T {
    const found = choices.find((candidate) => candidate === value);
    if (found !== undefined) return found;
    fault(path, `expected one of ${choices.map((c) => `'${c}'`).join(', ')}, got ${describe(value)}`);
    return choices[0]!;
  }

  function tuple(value: unknown, path: string, length: number): number[] {
    const items = Array.isArray(value) && value.length === length ? (value as unknown[]) : null;
    if (items === null) fault(path, `expected ${length} numbers, got ${describe(value)}`);
    return Array.from({ length }, (_, i) => (items === null ? 0 : number(items[i], `${path}[${i}]`)));
  }

  function quat(value: unknown, path: string): Quat {
    const [x, y, z, w] = tuple(value, path, 4) as [number, number, number, number];
    const length = Math.sqrt(x * x + y * y + z * z + w * w);
    if (first === null && !(Math.abs(length - 1) <= 1e-3))
      fault(path, `expected length 1 within 1e-3, got ${length}`);
    return [x, y, z, w];
  }

  return {
    reason: () => first,
    fault,
    record,
    list,
    number,
    whole,
    text,
    flag,
    choice,
    vec3: (value, path) => tuple(value, path, 3) as unknown as Vec3,
    vec4: (value, path) => tuple(value, path, 4) as unknown as Quat,
    quat,
  };
}

function describe(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (value === null) return 'null';
  if (typeof value === 'number') return String(value);
  if (typeof value === 'string') return value.length <= 40 ? `'${value}'` : `a text of ${value.length}`;
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === 'boolean') return String(value);
  return typeof value === 'object' ? 'an object' : `a ${typeof value}`;
}
