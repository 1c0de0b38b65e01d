import type { Controls, Quat, ShipClass, SurfaceState, TerrainHeight, Vec3 } from '../../../src/dynamics';
import {
  conjugate,
  cross,
  dot,
  length,
  minus,
  multiply,
  plus,
  rotate,
  rotationFromTo,
  scale,
} from './vectors';
import { turn } from './attitude';

/**
 * The design's pseudo-code, word for word ("Post-Touchdown Physics"): one step per tick of any length, ICRF positions, the ground's
 * force along the radius, the legs no more than a bound on the tilt that gravity overcomes. Where the design is silent, the shortest code
 * that works: flight is velocity Verlet, a landed ship keeps its unit normal and its altitude.
 */

const G = 6.6743e-11;
const CRASH_SPEED = 50;
const BOUNCE_SPEED = 10;

export interface LiteralBody {
  readonly name: string;
  readonly mass: number;
  readonly radius: number;
  position: Vec3;
  velocity: Vec3;
  attitude: Quat;
  angularVelocity: Vec3;
}

/** Contact parameters in which a server may differ from its clients. */
export interface ContactOptions {
  readonly terrainHeight: TerrainHeight;
  readonly frictionStatic: number;
  readonly frictionKinetic: number;
  /** k / m, 1/s². */
  readonly spring: number;
  /** ζ of an impact above the bounce speed. */
  readonly damping: number;
  /** Factor on the mass that the client assumes. */
  readonly massFactor: number;
  /** Factor on the controller's gains. */
  readonly gain: number;
  /** False: attitude and spin are kept at a touch. */
  readonly aligned: boolean;
}

export interface LiteralShip {
  readonly id: string;
  readonly shipClass: ShipClass;
  position: Vec3;
  velocity: Vec3;
  attitude: Quat;
  angularVelocity: Vec3;
  fuel: number;
  state: SurfaceState;
  crashed: boolean;
  impact: number;
  /** Landed: direction in the body's axes, distance from its centre, attitude in its axes. */
  rest: { readonly normal: Vec3; readonly distance: number; readonly attitude: Quat } | null;
  controls: Controls;
}

/** One tick of one ship, after its body has moved. */
export function updateShip(ship: LiteralShip, body: LiteralBody, options: ContactOptions, dt: number): void {
  if (ship.crashed) return;
  if (ship.state === 'landed') stayLanded(ship, body, options);
  else if (ship.state === '') fly(ship, body, options, dt);
  else updateContact(ship, body, options, dt);
}

interface Ground {
  readonly normal: Vec3;
  readonly distance: number;
  readonly penetration: number;
  readonly relative: Vec3;
  readonly vertical: number;
  readonly along: Vec3;
  readonly gravity: number;
}

function groundUnder(ship: LiteralShip, body: LiteralBody, { terrainHeight }: ContactOptions): Ground {
  const r = minus(ship.position, body.position);
  const distance = length(r);
  const normal = scale(r, 1 / distance);
  const [nx, ny, nz] = rotate(conjugate(body.attitude), normal);
  const surface = body.radius + terrainHeight(body.name, nx, ny, nz) + ship.shipClass.groundContactOffset;
  const relative = minus(minus(ship.velocity, body.velocity), cross(body.angularVelocity, r));
  const vertical = dot(relative, normal);
  return {
    normal,
    distance,
    penetration: surface - distance,
    relative,
    vertical,
    along: minus(relative, scale(normal, vertical)),
    gravity: (G * body.mass) / (distance * distance),
  };
}

function massOf(ship: LiteralShip, { massFactor }: ContactOptions): number {
  return (ship.shipClass.dryMass + ship.fuel) * massFactor;
}

function fly(ship: LiteralShip, body: LiteralBody, options: ContactOptions, dt: number): void {
  const thrust = burn(ship, dt);
  const mass = massOf(ship, options);
  const pull = (at: Vec3): Vec3 => {
    const r = minus(at, body.position);
    return plus(scale(r, (-G * body.mass) / length(r) ** 3), scale(thrust, 1 / mass));
  };
  // The body has already moved in free fall, and carries the ship along.
  const before = minus(ship.position, scale(body.velocity, -dt));
  const u = minus(ship.velocity, body.velocity);
  const a0 = pull(before);
  ship.position = plus(before, plus(scale(u, dt), scale(a0, 0.5 * dt * dt)));
  ship.velocity = plus(ship.velocity, scale(plus(a0, pull(ship.position)), 0.5 * dt));
  turn(ship, body, options, { dt, torque: [0, 0, 0] });
  const ground = groundUnder(ship, body, options);
  if (!(ground.penetration > 0 && ground.vertical < 0)) return;
  if (-ground.vertical > CRASH_SPEED) {
    ship.crashed = true;
    return;
  }
  ship.state = 'contact';
  ship.impact = -ground.vertical;
  if (!options.aligned) return;
  ship.angularVelocity = [0, 0, 0];
  const up = rotate(ship.attitude, [0, 0, 1]);
  ship.attitude = multiply(rotationFromTo(up, ground.normal), ship.attitude);
}

function updateContact(ship: LiteralShip, body: LiteralBody, options: ContactOptions, dt: number): void {
  const carried = { ...ship, position: plus(ship.position, scale(body.velocity, dt)) };
  const ground = groundUnder(carried, body, options);
  const thrust = burn(ship, dt);
  const mass = massOf(ship, options);
  const zeta = ship.impact > BOUNCE_SPEED && ship.state !== 'tipped' ? options.damping : 1;
  const k = mass * options.spring;
  const c = 2 * zeta * Math.sqrt(k * mass);
  const normalForce = ground.penetration > 0 ? Math.max(0, k * ground.penetration - c * ground.vertical) : 0;
  const friction = frictionOf(ground, normalForce, { mass, dt, options });
  const weight = mass * ground.gravity;
  const force = plus(plus(scale(ground.normal, normalForce - weight), friction), thrust);
  ship.velocity = plus(ship.velocity, scale(force, dt / mass));
  ship.position = plus(carried.position, scale(minus(ship.velocity, body.velocity), dt));
  const feet = ground.penetration > 0 ? { ground, held: Math.min(normalForce, weight) } : null;
  turn(ship, body, options, { dt, torque: feet === null ? [0, 0, 0] : tilting(ship, body, feet, dt) });
  checkTransitions(ship, body, options);
}

function frictionOf(
  { along }: Ground,
  normalForce: number,
  { mass, dt, options }: { readonly mass: number; readonly dt: number; readonly options: ContactOptions },
): Vec3 {
  const speed = length(along);
  if (normalForce === 0 || speed === 0) return [0, 0, 0];
  const sliding = scale(along, (-options.frictionKinetic * normalForce) / speed);
  const stopping = scale(along, -mass / dt);
  if (speed > 0.01) return length(stopping) < length(sliding) ? stopping : sliding;
  return length(stopping) > options.frictionStatic * normalForce ? sliding : stopping;
}

/** Gravity about the feet beyond arctan(leg_radius / h), where the centre of mass is out of the footprint; within it the legs right the ship. */
function tilting(
  ship: LiteralShip,
  body: LiteralBody,
  { ground, held }: { readonly ground: Ground; readonly held: number },
  dt: number,
): Vec3 {
  const { groundContactOffset: h, legRadius } = ship.shipClass;
  const up = rotate(ship.attitude, [0, 0, 1]);
  const gravityTorque = cross(scale(up, h), scale(ground.normal, -held));
  const tilt = Math.acos(Math.min(1, Math.max(-1, dot(up, ground.normal))));
  // The legs damp rotation about the feet.
  const spin = minus(ship.angularVelocity, body.angularVelocity);
  ship.angularVelocity = minus(ship.angularVelocity, scale(spin, Math.min(1, 2 * dt)));
  if (tilt >= Math.PI / 2) {
    ship.angularVelocity = body.angularVelocity;
    return [0, 0, 0];
  }
  if (tilt > Math.atan2(legRadius, h)) return gravityTorque;
  return scale(gravityTorque, -Math.min(1, (legRadius / h) * Math.cos(tilt)));
}

function checkTransitions(ship: LiteralShip, body: LiteralBody, options: ContactOptions): void {
  const ground = groundUnder(ship, body, options);
  const up = rotate(ship.attitude, [0, 0, 1]);
  const tilt = (Math.acos(Math.min(1, Math.max(-1, dot(up, ground.normal)))) * 180) / Math.PI;
  const spin = length(minus(ship.angularVelocity, body.angularVelocity));
  if (ground.penetration > 0 && -ground.vertical > CRASH_SPEED) ship.crashed = true;
  else if (ground.penetration <= 0 && ground.vertical > 0) {
    ship.state = '';
    ship.impact = 0;
  } else if (ship.state === 'contact' && tilt > 80) ship.state = 'tipped';
  else if (ship.state === 'tipped' && tilt < 80) ship.state = 'contact';
  else if (
    ship.state === 'contact' &&
    ground.penetration > 0 &&
    tilt < 5 &&
    spin < 0.01 &&
    Math.abs(ground.vertical) < 0.5 &&
    length(ground.along) < 0.5
  )
    land(ship, body, ground);
}

function land(ship: LiteralShip, body: LiteralBody, { normal, distance }: Ground): void {
  const back = conjugate(body.attitude);
  ship.state = 'landed';
  ship.rest = { normal: rotate(back, normal), distance, attitude: multiply(back, ship.attitude) };
}

function stayLanded(ship: LiteralShip, body: LiteralBody, options: ContactOptions): void {
  const rest = ship.rest!;
  const r = scale(rotate(body.attitude, rest.normal), rest.distance);
  ship.position = plus(body.position, r);
  ship.velocity = plus(body.velocity, cross(body.angularVelocity, r));
  ship.attitude = multiply(body.attitude, rest.attitude);
  ship.angularVelocity = body.angularVelocity;
  const lift = dot(thrustOf(ship), scale(r, 1 / rest.distance));
  if (lift <= (massOf(ship, options) * G * body.mass) / rest.distance ** 2) return;
  ship.state = '';
  ship.impact = 0;
}

function thrustOf({ shipClass, controls, fuel, attitude }: LiteralShip): Vec3 {
  if (fuel <= 0) return [0, 0, 0];
  const { translationInput: t, thrustLevel } = controls;
  const rcs = shipClass.rcsThrust;
  return rotate(attitude, [
    t[0] * rcs[0],
    t[1] * rcs[1],
    t[2] * rcs[2] + thrustLevel * shipClass.mainEngineThrust,
  ]);
}

function burn(ship: LiteralShip, dt: number): Vec3 {
  const thrust = thrustOf(ship);
  const { mainEngineThrust, mainEngineIsp } = ship.shipClass;
  const rate = (ship.controls.thrustLevel * mainEngineThrust) / (mainEngineIsp * 9.80665);
  ship.fuel = Math.max(0, ship.fuel - rate * dt);
  return thrust;
}
