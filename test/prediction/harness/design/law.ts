import type { Controls, ShipClass, TerrainHeight } from '../../../../src/index';
import { burn, massOf, thrustOf, turnShip } from './actuators';
import {
  conjugate,
  cross,
  dot,
  length,
  minus,
  plus,
  product,
  shortest,
  times,
  type Turn,
  turned,
  type Vec,
  zero,
} from './vectors';

/**
 * The contact physics of the game's design page, as its pseudo-code stands: one step a tick, ICRF, the ground's force along the radius.
 * Written from the page alone; it shares nothing with the law of the client.
 */

/** Constants and motion of a body, SI, ICRF. */
export interface DesignBody {
  readonly name: string;
  readonly mass: number;
  readonly radius: number;
  position: Vec;
  readonly velocity: Vec;
  attitude: Turn;
  readonly angularVelocity: Vec;
}

export interface DesignShip {
  readonly id: string;
  readonly shipClass: ShipClass;
  position: Vec;
  velocity: Vec;
  attitude: Turn;
  angularVelocity: Vec;
  fuel: number;
  state: '' | 'contact' | 'landed' | 'tipped';
  crashed: boolean;
  /** Vertical speed of the touch that began the contact, m/s. */
  impact: number;
  controls: Controls;
  /** At rest: unit normal in the body's axes, distance from its centre, attitude in its axes. */
  pin: { readonly normal: Vec; readonly distance: number; readonly attitude: Turn } | null;
}

const G = 6.6743e-11;
const CRASH_SPEED = 50;
const BOUNCE_SPEED = 10;
const SETTLE = { tilt: 5, spin: 0.01, speed: 0.5 };
const TIPPED_TILT = 80;
const SPRING = 100;
const DAMPING = 0.3;
const MU_STATIC = 0.8;
const MU_KINETIC = 0.5;
const SLIDING = 0.01;
const DEGREES = 180 / Math.PI;

interface Surface {
  readonly up: Vec;
  readonly distance: number;
  readonly penetration: number;
  readonly relative: Vec;
  readonly radial: number;
  readonly tangential: Vec;
  readonly gravity: number;
}

function surfaceUnder(ship: DesignShip, body: DesignBody, terrainHeight: TerrainHeight): Surface {
  const r = minus(ship.position, body.position);
  const distance = length(r);
  const up = times(r, 1 / distance);
  const [nx, ny, nz] = turned(conjugate(body.attitude), up);
  const surface = body.radius + terrainHeight(body.name, nx, ny, nz) + ship.shipClass.groundContactOffset;
  const relative = minus(minus(ship.velocity, body.velocity), cross(body.angularVelocity, r));
  const radial = dot(relative, up);
  return {
    up,
    distance,
    relative,
    radial,
    penetration: surface - distance,
    tangential: minus(relative, times(up, radial)),
    gravity: (G * body.mass) / distance ** 2,
  };
}

/** `_update_ship`, after its body has moved. */
export function updateShip(ship: DesignShip, body: DesignBody, terrain: TerrainHeight, dt: number): void {
  if (ship.crashed) return;
  if (ship.state === 'landed') updateLanded(ship, body);
  else if (ship.state === 'tipped') updateTipped(ship, body, terrain, dt);
  else if (ship.state === 'contact') updateContact(ship, body, terrain, dt);
  else updateFlight(ship, body, terrain, dt);
}

/** Velocity Verlet in the frame that falls with the body. */
function updateFlight(ship: DesignShip, body: DesignBody, terrain: TerrainHeight, dt: number): void {
  const push = times(thrustOf(ship), 1 / massOf(ship));
  burn(ship, dt);
  const pull = (r: Vec): Vec => plus(times(r, (-G * body.mass) / length(r) ** 3), push);
  const r = minus(ship.position, minus(body.position, times(body.velocity, dt)));
  const u = minus(ship.velocity, body.velocity);
  const before = pull(r);
  const next = plus(r, plus(times(u, dt), times(before, dt ** 2 / 2)));
  ship.position = plus(body.position, next);
  ship.velocity = plus(ship.velocity, times(plus(before, pull(next)), dt / 2));
  turnShip(ship, zero(), dt);
  const surface = surfaceUnder(ship, body, terrain);
  if (surface.penetration <= 0 || surface.radial >= 0) return;
  ship.crashed = -surface.radial > CRASH_SPEED;
  if (ship.crashed) return;
  ship.state = 'contact';
  ship.impact = -surface.radial;
  ship.angularVelocity = zero();
  const nose = turned(ship.attitude, [0, 0, 1]);
  ship.attitude = product(shortest(nose, surface.up), ship.attitude);
}

/** `_update_ship_contact`. */
function updateContact(ship: DesignShip, body: DesignBody, terrain: TerrainHeight, dt: number): void {
  ship.position = plus(ship.position, times(body.velocity, dt));
  const surface = surfaceUnder(ship, body, terrain);
  const { up, penetration, radial, tangential, gravity } = surface;
  const mass = massOf(ship);
  const k = mass * SPRING;
  const c = 2 * (ship.impact > BOUNCE_SPEED ? DAMPING : 1) * Math.sqrt(k * mass);
  const normal = penetration > 0 ? Math.max(0, k * penetration - c * radial) : 0;
  const force = plus(
    plus(times(up, normal - gravity * mass), frictionOf(tangential, normal, mass, dt)),
    thrustOf(ship),
  );
  burn(ship, dt);
  ship.velocity = plus(ship.velocity, times(force, dt / mass));
  ship.position = plus(ship.position, times(minus(ship.velocity, body.velocity), dt));
  turnShip(ship, penetration > 0 ? gravityTorque(ship, surface, mass) : zero(), dt);
  checkTransitions(ship, body, terrain);
}

function frictionOf(tangential: Vec, normal: number, mass: number, dt: number): Vec {
  const speed = length(tangential);
  if (speed === 0 || normal === 0) return zero();
  const kinetic = times(tangential, (-MU_KINETIC * normal) / speed);
  const arresting = times(tangential, -mass / dt);
  // One step a tick: more than what arrests the ship would throw it back.
  if (speed > SLIDING) return length(kinetic) < length(arresting) ? kinetic : arresting;
  return length(arresting) > MU_STATIC * normal ? kinetic : arresting;
}

/** About the feet, once the centre of mass is out of the legs' footprint. */
function gravityTorque(ship: DesignShip, { up, gravity }: Surface, mass: number): Vec {
  const { groundContactOffset, legRadius } = ship.shipClass;
  const nose = turned(ship.attitude, [0, 0, 1]);
  if (
    tiltOf(nose, up) * groundContactOffset <=
    Math.atan2(legRadius, groundContactOffset) * groundContactOffset
  )
    return zero();
  return cross(times(nose, groundContactOffset), times(up, -gravity * mass));
}

const tiltOf = (nose: Vec, up: Vec): number => Math.acos(Math.min(1, Math.max(-1, dot(nose, up))));

function checkTransitions(ship: DesignShip, body: DesignBody, terrain: TerrainHeight): void {
  const { up, penetration, radial, tangential, distance } = surfaceUnder(ship, body, terrain);
  const tilt = tiltOf(turned(ship.attitude, [0, 0, 1]), up) * DEGREES;
  const spin = length(minus(ship.angularVelocity, body.angularVelocity));
  const isStill = Math.abs(radial) < SETTLE.speed && length(tangential) < SETTLE.speed;
  if (penetration <= 0) {
    if (radial > 0) ship.state = '';
    return;
  }
  if (-radial > CRASH_SPEED) ship.crashed = true;
  else if (tilt > TIPPED_TILT) pinShip(ship, body, { state: 'tipped', up, distance });
  else if (tilt < SETTLE.tilt && spin < SETTLE.spin && isStill)
    pinShip(ship, body, { state: 'landed', up, distance });
}

function pinShip(
  ship: DesignShip,
  body: DesignBody,
  {
    state,
    up,
    distance,
  }: { readonly state: 'landed' | 'tipped'; readonly up: Vec; readonly distance: number },
): void {
  const back = conjugate(body.attitude);
  ship.state = state;
  ship.pin = { normal: turned(back, up), distance, attitude: product(back, ship.attitude) };
}

/** Position and velocity of a ship that is pinned to its body. */
function holdPinned(ship: DesignShip, body: DesignBody): Vec {
  const { normal, distance } = ship.pin!;
  const up = turned(body.attitude, normal);
  ship.position = plus(body.position, times(up, distance));
  ship.velocity = plus(body.velocity, cross(body.angularVelocity, times(up, distance)));
  return up;
}

function liftsOff(ship: DesignShip, body: DesignBody, up: Vec): boolean {
  const weight = (massOf(ship) * G * body.mass) / ship.pin!.distance ** 2;
  if (dot(thrustOf(ship), up) <= weight) return false;
  ship.state = '';
  ship.impact = 0;
  return true;
}

function updateLanded(ship: DesignShip, body: DesignBody): void {
  const up = holdPinned(ship, body);
  ship.attitude = product(body.attitude, ship.pin!.attitude);
  ship.angularVelocity = [...body.angularVelocity];
  liftsOff(ship, body, up);
}

function updateTipped(ship: DesignShip, body: DesignBody, terrain: TerrainHeight, dt: number): void {
  const up = holdPinned(ship, body);
  if (liftsOff(ship, body, up)) return;
  const torque = gravityTorque(ship, surfaceUnder(ship, body, terrain), massOf(ship));
  burn(ship, dt);
  turnShip(ship, torque, dt);
  const nose = turned(ship.attitude, [0, 0, 1]);
  const tilt = tiltOf(nose, up) * DEGREES;
  // On its side: the ground holds it.
  if (tilt > 90) ship.angularVelocity = [...body.angularVelocity];
  const isRighting = dot(cross(ship.angularVelocity, nose), up) > 0;
  if (tilt < TIPPED_TILT && isRighting) ship.state = 'contact';
}
