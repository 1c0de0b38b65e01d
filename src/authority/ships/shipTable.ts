import {
  ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  CONTACT,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  POSITION,
  type Quat,
  readQuat,
  REFERENCE_BODY,
  SHIP_STRIDE,
  type ShipInit,
  spawnShip,
  SURFACE_STATE,
  type Vec3,
  VELOCITY,
  type World,
} from '../../dynamics';
import { textFault } from '../../wire';
import type { ScheduledInput } from './scheduledInput';
import { compose, inverse, rotate } from './rotation';
import type { ShipIdentity } from './shipState';

/** A ship to spawn. */
export interface SpawnOrder extends ShipIdentity {
  readonly ship: ShipInit;
  /** Inputs it applies by itself until its player's first input acts; ascending in time. */
  readonly plan?: readonly ScheduledInput[];
}

/** The ships of a world: row i belongs to entry i. */
export interface ShipTable {
  rows: Float64Array;
  /** The event of each ship in the last substep. */
  events: Uint8Array;
  readonly entries: Entry[];
}

interface Entry {
  readonly identity: ShipIdentity;
  /** The ship as spawned, and its body's attitude then: a respawn is over the same ground. */
  readonly ship: ShipInit;
  readonly bodyAttitude: Quat;
}

const MAX_SHIPS = 10_000;
/** Larger kicks are mistakes of the caller, m/s and rad/s. */
const MAX_KICK = 1e4;

export function createShipTable(): ShipTable {
  return { rows: new Float64Array(0), events: new Uint8Array(0), entries: [] };
}

/** The row offset of a ship, or -1. */
export function rowOf(table: ShipTable, shipId: string): number {
  return table.entries.findIndex((entry) => entry.identity.shipId === shipId) * SHIP_STRIDE;
}

/** Adds a ship. Returns null, or a reason that names the invalid field; then the table is unchanged. */
export function spawn(
  table: ShipTable,
  order: SpawnOrder,
  bodies: Float64Array,
  world: World,
): string | null {
  const { shipId, playerId, name, ship } = order;
  const invalid = invalidName(order);
  if (invalid !== null) return invalid;
  if (rowOf(table, shipId) >= 0) return `shipId: ${shipId} exists already`;
  if (table.entries.length >= MAX_SHIPS) return `ships: the limit of ${MAX_SHIPS} is reached`;
  const at = table.rows.length;
  const rows = new Float64Array(at + SHIP_STRIDE);
  rows.set(table.rows);
  const reason = spawnShip(rows, at, ship, world);
  if (reason !== null) return reason;
  table.rows = rows;
  table.events = new Uint8Array(rows.length / SHIP_STRIDE);
  const bodyAttitude = attitudeOf(bodies, rows[at + REFERENCE_BODY]!);
  table.entries.push({ identity: { shipId, playerId, name }, ship, bodyAttitude });
  return null;
}

/** Why the ship's names cannot be sent to clients, or null. */
function invalidName({ shipId, playerId, name }: ShipIdentity): string | null {
  if (shipId === '') return 'shipId: expected a non-empty string';
  for (const [field, text] of Object.entries({ shipId, playerId, name })) {
    const fault = textFault(text);
    if (fault !== null) return `${field}: ${fault}`;
  }
  return null;
}

/** Removes a ship from the world. */
export function despawn(table: ShipTable, shipId: string): string | null {
  const at = rowOf(table, shipId);
  if (at < 0) return `shipId: no ship named ${shipId}`;
  const rows = new Float64Array(table.rows.length - SHIP_STRIDE);
  rows.set(table.rows.subarray(0, at));
  rows.set(table.rows.subarray(at + SHIP_STRIDE), at);
  table.rows = rows;
  table.events = new Uint8Array(rows.length / SHIP_STRIDE);
  table.entries.splice(at / SHIP_STRIDE, 1);
  return null;
}

/** Puts a ship back as it was spawned, over the same ground of the turned body, or into the state `ship`; controls neutral. */
export function respawn(
  table: ShipTable,
  shipId: string,
  bodies: Float64Array,
  world: World,
  ship?: ShipInit,
): string | null {
  const at = rowOf(table, shipId);
  if (at < 0) return `shipId: no ship named ${shipId}`;
  return spawnShip(table.rows, at, ship ?? aboveSameGround(table, at, bodies, world), world);
}

/**
 * Adds `dv` (m/s) and `spin` (rad/s), ICRF axes, to a ship: an operator's command, outside the dynamics. A landed ship is
 * attached to the ground and a settling one is held down (DYNAMICS, Linear): kicked upward they fly; kicked otherwise a landed one
 * slides.
 */
export function kick(table: ShipTable, shipId: string, dv: Vec3, spin: Vec3): string | null {
  const at = rowOf(table, shipId);
  if (at < 0) return `shipId: no ship named ${shipId}`;
  const { rows } = table;
  for (const [name, vector] of [
    ['dv', dv],
    ['spin', spin],
  ] as const) {
    if (!vector.every((value) => Math.abs(value) <= MAX_KICK))
      return `${name}: expected 3 numbers of at most ${MAX_KICK}`;
  }
  let along = 0;
  for (let k = 0; k < 3; k++) {
    rows[at + VELOCITY + k]! += dv[k]!;
    rows[at + ANGULAR_VELOCITY + k]! += spin[k]!;
    along += dv[k]! * rows[at + POSITION + k]!;
  }
  const upward = along > 0;
  if (upward || rows[at + SURFACE_STATE] === LANDED) {
    rows[at + SURFACE_STATE] = upward ? FLYING : CONTACT;
    rows[at + IMPACT_SPEED] = 0;
  }
  return null;
}

function aboveSameGround(table: ShipTable, at: number, bodies: Float64Array, world: World): ShipInit {
  const { ship, bodyAttitude } = table.entries[at / SHIP_STRIDE]!;
  const body = world.bodies.findIndex((candidate) => candidate.name === ship.referenceBody);
  const turn = compose(attitudeOf(bodies, body), inverse(bodyAttitude));
  return {
    ...ship,
    relativePosition: rotate(turn, ship.relativePosition),
    relativeVelocity: rotate(turn, ship.relativeVelocity),
    attitude: compose(turn, ship.attitude),
    angularVelocity: rotate(turn, ship.angularVelocity),
  };
}

function attitudeOf(bodies: Float64Array, index: number): Quat {
  return readQuat(bodies, index * BODY_STRIDE + BODY_ATTITUDE);
}
