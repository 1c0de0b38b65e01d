import {
  ANGULAR_VELOCITY,
  BODY_ATTITUDE,
  BODY_STRIDE,
  CONTACT,
  type Controls,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  loadControls,
  POSITION,
  type Quat,
  REFERENCE_BODY,
  SHIP_STRIDE,
  type ShipInit,
  spawnShip,
  SURFACE_STATE,
  type Vec3,
  VELOCITY,
  type World,
  writeControls,
} from '../dynamics';
import { textComplaint } from '../wire';
import type { PlannedInput } from './plans';
import { compose, inverse, rotate } from './rotation';
import type { ShipIdentity } from './shipState';

/** A ship to be put into the world. */
export interface SpawnOrder extends ShipIdentity {
  readonly ship: ShipInit;
  /** Neutral unless said. */
  readonly controls?: Controls;
  /** What it does by itself until its player's first input acts; in the order of time. */
  readonly plan?: readonly PlannedInput[];
}

/** The ships of a world: row i belongs to identity i. */
export interface Roster {
  rows: Float64Array;
  /** What each ship reported in a substep. */
  events: Uint8Array;
  readonly berths: Berth[];
}

interface Berth {
  readonly identity: ShipIdentity;
  /** As spawned, and how its body was turned then: a respawn is over the same ground. */
  readonly ship: ShipInit;
  readonly bodyAttitude: Quat;
}

const MAX_SHIPS = 10_000;
/** Beyond this a kick is a slip of the caller's, m/s and rad/s. */
const LARGEST_KICK = 1e4;

export function createRoster(): Roster {
  return { rows: new Float64Array(0), events: new Uint8Array(0), berths: [] };
}

/** The row offset of a ship, or -1. */
export function rowOf(roster: Roster, shipId: string): number {
  return roster.berths.findIndex((berth) => berth.identity.shipId === shipId) * SHIP_STRIDE;
}

/** Adds a ship; a reason that names the field leaves the roster as it was. */
export function spawn(roster: Roster, order: SpawnOrder, bodies: Float64Array, world: World): string | null {
  const { shipId, playerId, name, ship } = order;
  const unsaid = notOnWire(order);
  if (unsaid !== null) return unsaid;
  if (rowOf(roster, shipId) >= 0) return `shipId: ${shipId} is there already`;
  if (roster.berths.length >= MAX_SHIPS) return `ships: ${MAX_SHIPS} are there already`;
  const at = roster.rows.length;
  const rows = new Float64Array(at + SHIP_STRIDE);
  rows.set(roster.rows);
  const reason = spawnShip(rows, at, ship, world) ?? command(rows, at, order.controls);
  if (reason !== null) return reason;
  roster.rows = rows;
  roster.events = new Uint8Array(rows.length / SHIP_STRIDE);
  const bodyAttitude = attitudeOf(bodies, rows[at + REFERENCE_BODY]!);
  roster.berths.push({ identity: { shipId, playerId, name }, ship, bodyAttitude });
  return null;
}

/** Why the order's names could not be told to any client, or null. */
function notOnWire({ shipId, playerId, name }: ShipIdentity): string | null {
  if (shipId === '') return 'shipId: expected a text';
  for (const [field, text] of Object.entries({ shipId, playerId, name })) {
    const complaint = textComplaint(text);
    if (complaint !== null) return `${field}: ${complaint}`;
  }
  return null;
}

/** Takes a ship out of the world. */
export function despawn(roster: Roster, shipId: string): string | null {
  const at = rowOf(roster, shipId);
  if (at < 0) return `shipId: no ship named ${shipId}`;
  const rows = new Float64Array(roster.rows.length - SHIP_STRIDE);
  rows.set(roster.rows.subarray(0, at));
  rows.set(roster.rows.subarray(at + SHIP_STRIDE), at);
  roster.rows = rows;
  roster.events = new Uint8Array(rows.length / SHIP_STRIDE);
  roster.berths.splice(at / SHIP_STRIDE, 1);
  return null;
}

/** Puts a ship back as it was spawned, over the same ground of the turned body, or as `ship` says; controls neutral. */
export function respawn(
  roster: Roster,
  shipId: string,
  bodies: Float64Array,
  world: World,
  ship?: ShipInit,
): string | null {
  const at = rowOf(roster, shipId);
  if (at < 0) return `shipId: no ship named ${shipId}`;
  return spawnShip(roster.rows, at, ship ?? overSameGround(roster, at, bodies, world), world);
}

/**
 * Adds `dv` (m/s) and `spin` (rad/s), ICRF axes, to a ship: an operator's doing, outside the law. A landed ship is attached to
 * the ground and a settling one is held down (DYNAMICS, Linear): pushed upward they fly, pushed otherwise a landed one slides.
 */
export function kick(roster: Roster, shipId: string, dv: Vec3, spin: Vec3): string | null {
  const at = rowOf(roster, shipId);
  if (at < 0) return `shipId: no ship named ${shipId}`;
  const { rows } = roster;
  for (const [name, vector] of [
    ['dv', dv],
    ['spin', spin],
  ] as const) {
    if (!vector.every((value) => Math.abs(value) <= LARGEST_KICK))
      return `${name}: expected 3 numbers of at most ${LARGEST_KICK}`;
  }
  for (let k = 0; k < 3; k++) {
    rows[at + VELOCITY + k]! += dv[k]!;
    rows[at + ANGULAR_VELOCITY + k]! += spin[k]!;
  }
  const [x, y, z] = rows.subarray(at + POSITION, at + POSITION + 3) as unknown as Vec3;
  const upward = dv[0] * x + dv[1] * y + dv[2] * z > 0;
  if (upward || rows[at + SURFACE_STATE] === LANDED) {
    rows[at + SURFACE_STATE] = upward ? FLYING : CONTACT;
    rows[at + IMPACT_SPEED] = 0;
  }
  return null;
}

function overSameGround(roster: Roster, at: number, bodies: Float64Array, world: World): ShipInit {
  const { ship, bodyAttitude } = roster.berths[at / SHIP_STRIDE]!;
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

function command(rows: Float64Array, at: number, controls: Controls | undefined): string | null {
  if (controls === undefined) return null;
  const checked = loadControls(controls);
  if (!checked.ok) return `controls.${checked.reason}`;
  writeControls(rows, at, checked.value);
  return null;
}

function attitudeOf(bodies: Float64Array, index: number): Quat {
  const at = index * BODY_STRIDE + BODY_ATTITUDE;
  return [bodies[at]!, bodies[at + 1]!, bodies[at + 2]!, bodies[at + 3]!];
}
