/** Compares the TypeScript and the Python law bit by bit, and finds where they diverge. */
import { createHash } from 'node:crypto';
import type { ExactCase } from './cases/exactCase';
import { AFTER_TICK, caseTerrain, playCase, type TakeRow } from './cases/playCase';
import { type PythonResult, type PythonRow, rowsInPython, SERVER_HOME } from './python';

/** Names of a ship row's doubles, in the order of dynamics/state/layout.ts, then the event. */
const SHIP_FIELDS = [
  ...named('relative_position', 'xyz'),
  ...named('relative_velocity', 'xyz'),
  ...named('attitude', 'xyzw'),
  ...named('angular_velocity', 'xyz'),
  'fuel',
  ...named('wheel_momentum', 'xyz'),
  ...['contact_impact_speed', 'surface_contact_state', 'reference_body', 'crashed', 'ship_class'],
  'ground_contact_offset',
  'thrust_level',
  ...named('translation_input', 'xyz'),
  ...named('rotation_input', 'xyz'),
  ...['attitude_hold', 'attitude_mode'],
  ...named('target_attitude', 'xyzw'),
  'event',
];
const BODY_FIELDS = [
  ...named('body position', 'xyz'),
  ...named('body velocity', 'xyz'),
  ...named('body attitude', 'xyzw'),
];

function named(field: string, axes: string): string[] {
  return Array.from(axes, (axis) => `${field}.${axis}`);
}

/** SHA-256 of all rows of a case in TypeScript, and the number of substeps. @throws if the law refuses the case */
export function hashCase(
  exact: ExactCase,
  also: TakeRow = () => undefined,
  terrainOf = caseTerrain,
): PythonResult {
  const hash = createHash('sha256');
  const played = playCase(
    exact,
    (row, tick, substep) => {
      hash.update(bytesOf(row));
      also(row, tick, substep);
    },
    terrainOf,
  );
  if (!played.ok) throw new Error(`${exact.name}: ${played.reason}`);
  return { name: exact.name, substeps: played.value, hash: hash.digest('hex') };
}

/** Where a case first differs: tick, substep, field, both values in hexadecimal; null when every bit agrees. */
export async function firstDifference(
  exact: ExactCase,
  { home = SERVER_HOME, terrainOf = caseTerrain } = {},
): Promise<string | null> {
  const theirs = await rowsInPython(exact, home);
  let at = 0;
  let found: string | null = null;
  const played = playCase(
    exact,
    (row, tick, substep) => {
      const their = theirs[at++];
      found ??= rowDifference(row, their, `${exact.name}: tick ${tick} substep ${substep}`);
    },
    terrainOf,
  );
  if (!played.ok) return `${exact.name}: ${played.reason}`;
  if (at !== theirs.length) return `${exact.name}: ${at} rows here, ${theirs.length} in Python`;
  return found;
}

function rowDifference(row: Float64Array, their: PythonRow | undefined, where: string): string | null {
  const ours = bytesOf(row).toString('hex');
  if (their?.bytes === ours) return null;
  const fields = their?.substep === AFTER_TICK ? BODY_FIELDS : SHIP_FIELDS;
  for (const [i, value] of row.entries()) {
    const mine = ours.slice(16 * i, 16 * i + 16);
    const other = their?.bytes.slice(16 * i, 16 * i + 16) ?? '';
    if (mine === other) continue;
    const theirValue = other === '' ? 'nothing' : String(Buffer.from(other, 'hex').readDoubleLE());
    return `${where}: ${fields[i]}: typescript ${bigEndian(mine)} (${value}), python ${bigEndian(other)} (${theirValue})`;
  }
  return `${where}: rows of different length`;
}

/** Big-endian hexadecimal: sign and exponent first. */
function bigEndian(hex: string): string {
  return `0x${(hex.match(/../g) ?? []).reverse().join('')}`;
}

/** Every machine that node runs on is little-endian, as Python's rows are. */
function bytesOf(row: Float64Array): Buffer {
  return Buffer.from(row.buffer, row.byteOffset, row.byteLength);
}
