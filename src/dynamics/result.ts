/** The result of a validation: the checked value, or a reason that names the invalid field. */
export type Result<T> =
  { readonly ok: true; readonly value: T } | { readonly ok: false; readonly reason: string };

export function ok<T>(value: T): Result<T> {
  return { ok: true, value };
}

export function err(reason: string): { readonly ok: false; readonly reason: string } {
  return { ok: false, reason };
}

/** [x, y, z] */
export type Vec3 = readonly [number, number, number];
/** [x, y, z, w], unit: rotates body axes into ICRF. */
export type Quat = readonly [number, number, number, number];
/** Row by row. */
export type Mat3 = readonly [Vec3, Vec3, Vec3];

/** The vector at `at` of a row. Element by element: Array.from of a part takes forty times as long, for each ship of each frame. */
export function readVec3(row: Float64Array, at: number): Vec3 {
  return [row[at]!, row[at + 1]!, row[at + 2]!];
}

export function readQuat(row: Float64Array, at: number): Quat {
  return [row[at]!, row[at + 1]!, row[at + 2]!, row[at + 3]!];
}

/** Why `value` is not a finite number, or null. */
export function notFinite(field: string, value: unknown): string | null {
  if (typeof value === 'number' && Number.isFinite(value)) return null;
  return `${field}: expected a finite number, got ${describe(value)}`;
}

/** Why `value` is not `length` finite numbers, or null. */
export function notFiniteTuple(field: string, value: unknown, length: number): string | null {
  if (!Array.isArray(value) || value.length !== length) {
    return `${field}: expected ${String(length)} numbers, got ${describe(value)}`;
  }
  for (let i = 0; i < length; i++) {
    // The element's name is built only for an error, so that checking valid tuples does not allocate.
    if (!Number.isFinite(value[i])) return notFinite(`${field}[${String(i)}]`, value[i]);
  }
  return null;
}

/**
 * For the options of a constructor.
 * @throws RangeError that names the first member of `given` that is not `known`
 */
export function requireKnown(path: string, known: readonly string[], given: object): void {
  const unknown = Object.keys(given).find((name) => !known.includes(name));
  if (unknown !== undefined) throw new RangeError(`${path}.${unknown}: unknown. Known: ${known.join(', ')}.`);
}

/** Describes a value that is no number or list, for a refusal's reason. */
export function describe(value: unknown): string {
  if (value === null) return 'null';
  if (typeof value === 'number') return String(value);
  if (Array.isArray(value)) return `a list of ${String(value.length)}`;
  return typeof value;
}
