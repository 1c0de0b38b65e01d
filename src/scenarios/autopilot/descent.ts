import { compose, cross, inverse, rotate } from '../../authority';
import {
  type Result,
  ok,
  type Controls,
  GRAVITATIONAL_CONSTANT,
  type Quat,
  err,
  type ShipClass,
  type TerrainHeight,
  type Vec3,
} from '../../dynamics';
import type { BodyState, ShipState } from '../../wire';
import { dot, length, minus, scaled } from '../vectors';
import { planTravel } from './travel';

/** Where a ship lands. */
export interface LandingSite {
  readonly body: BodyState;
  readonly shipClass: ShipClass;
  readonly terrainHeight: TerrainHeight;
  /**
   * Game seconds from a state to the middle of the interval in which the controls computed from it act: half a tick if they act at once,
   * one and a half if they act a tick later. 0 by default; a ship that turns upright during the descent then starts its engine later.
   */
  readonly delay?: number;
  /** m/s: a harder touch fails the landing; by default that of DEFAULT_SETTINGS. */
  readonly bounceSpeed?: number;
  /** Where to land, relative to the body's centre, m, the body's axes; by default below the ship. */
  readonly target?: Vec3;
}

/** A ship relative to the ground below it. SI units; up is local up, speeds are relative to the turning ground. */
export interface Approach {
  /** Height of an upright ship's feet above the ground, m. */
  readonly height: number;
  /** m/s, positive upward. */
  readonly climb: number;
  /** Speed along the ground, body axes, m/s. */
  readonly drift: Vec3;
  /** Along the ground to the target, body axes, m; null without a target. */
  readonly away: Vec3 | null;
  /** Cosine of the tilt now or when the controls act, whichever is more upright. */
  readonly upright: number;
  /** Cosine of the angle between thrust and the direction against the motion over the ground; 0 at rest. */
  readonly retrograde: number;
  /** m/s² */
  readonly gravity: number;
}

const TOP: Vec3 = [0, 0, 1];
/** Descent speed in the last metres, m/s: below the bounce speed, and high enough that a slow tick does not turn it into a hover. */
const TOUCH_SPEED = 1.5;
/** Largest descent speed, m/s: after a delay of a second the ship can still brake. */
const MAX_SPEED = 15;
/** Height below which it descends at TOUCH_SPEED, m. */
const LAST_METRES = 3;
/** Share of the excess thrust (thrust − weight) that the braking plan uses; the rest is for corrections. */
const BRAKING_SHARE = 0.5;
/** m/s²: stronger braking would start too late with states a second apart, however strong the engine. */
const MAX_BRAKING = 1;
/** s⁻¹: speed errors are corrected within two seconds, slow enough for one state per second and controls that act a second later. */
const RESPONSE = 0.5;
/** At tilts past 60° the engine pushes more sideways than up, so it waits until the ship is more upright. */
const MIN_UPRIGHT = 0.5;
/** Below its height over the ground it climbs: s⁻¹, and m/s at most. */
const HOLDING = 0.4;
const MAX_CLIMB = 4;
/** Steps in which a ship's rotation is extrapolated. */
const STEPS = 4;

/** The approach of a ship, or a reason that names the field without a finite value. */
export function approachOf(ship: ShipState, site: LandingSite): Result<Approach> {
  const { body, shipClass, terrainHeight, delay = 0, target } = site;
  // The game's own server sends ICRF only: at 1 au exact to 15 µm, enough for a pilot.
  const position = ship.relativePosition ?? minus(ship.position, body.position);
  const velocity = ship.relativeVelocity ?? minus(ship.velocity, body.velocity);
  const distance = length(position);
  if (!(distance >= 1 && distance < Infinity))
    return err('relativePosition: expected a position above the body');
  const up = scaled(position, 1 / distance);
  const overGround = minus(velocity, cross(body.angularVelocity, position));
  if (!overGround.every(Number.isFinite)) return err('relativeVelocity: expected finite numbers');
  if (!ship.attitude.every(Number.isFinite)) return err('attitude: expected finite numbers');
  if (!(ship.mass > 0 && ship.mass < Infinity)) return err('mass: expected a finite number > 0 kg');
  if (!(delay >= 0 && delay < Infinity)) return err(`delay: expected ≥ 0 s, got ${delay}`);
  if (!ship.angularVelocity.every(Number.isFinite)) return err('angularVelocity: expected finite numbers');
  if (target?.every(Number.isFinite) === false) return err('target: expected finite numbers');
  const ground = terrainHeight(body.name, ...rotate(inverse(body.attitude), up));
  if (!Number.isFinite(ground)) return err('terrainHeight: expected a finite number');
  const climb = dot(overGround, up);
  const speed = length(overGround);
  const alongGround = (v: Vec3) => rotate(inverse(ship.attitude), minus(v, scaled(up, dot(v, up))));
  return ok({
    height: distance - (body.radius + ground + shipClass.groundContactOffset),
    climb,
    drift: alongGround(overGround),
    away: target === undefined ? null : alongGround(minus(rotate(body.attitude, target), position)),
    upright: Math.max(dot(rotate(ship.attitude, TOP), up), dot(rotate(turned(ship, delay), TOP), up)),
    retrograde: speed > 0 ? -dot(rotate(ship.attitude, TOP), overGround) / speed : 0,
    gravity: (GRAVITATIONAL_CONSTANT * body.mass) / (distance * distance),
  });
}

/** The attitude after rotating for `seconds` at the present rate, in small steps. */
function turned({ attitude, angularVelocity }: ShipState, seconds: number): Quat {
  const [x, y, z] = scaled(angularVelocity, seconds / (2 * STEPS));
  const perLength = 1 / Math.sqrt(x * x + y * y + z * z + 1);
  const step: Quat = [x * perLength, y * perLength, z * perLength, perLength];
  let after = attitude;
  for (let i = 0; i < STEPS; i++) after = compose(step, after);
  return after;
}

/**
 * The controls of a vertical descent: upright, thrusters cancelling the drift, and no faster than half of the engine's excess thrust
 * can brake. Where gravity is too weak, the thrusters push the ship down. With a target the thrusters carry the ship there first.
 */
export function descend(approach: Approach, mass: number, shipClass: ShipClass): Controls {
  const { climb, upright, gravity } = approach;
  const [rcsX, rcsY, rcsZ] = shipClass.rcsThrust;
  const travel = planTravel(approach, mass, shipClass);
  const height = approach.height - travel.hold;
  const reserve = shipClass.mainEngineThrust / mass - gravity;
  const affordable = BRAKING_SHARE * (reserve > 0 ? reserve : 0);
  const braking = affordable < MAX_BRAKING ? affordable : MAX_BRAKING;
  const toBrake = height > LAST_METRES ? height - LAST_METRES : 0;
  const touch =
    travel.hold > 0 ? Math.max(-MAX_CLIMB, Math.min(0, HOLDING * (height - LAST_METRES))) : TOUCH_SPEED;
  const planned = toBrake > 0 ? Math.sqrt(Math.max(touch, 0) ** 2 + 2 * braking * toBrake) : touch;
  const speed = planned < MAX_SPEED ? planned : MAX_SPEED;
  // The planned speed decreases on the way down, except at the cap and in the last metres.
  const onCurve = toBrake > 0 && planned < MAX_SPEED && climb < 0;
  const easing = onCurve ? (braking * -climb) / planned : 0;
  const wanted = gravity + easing + RESPONSE * (-speed - climb);
  const push = upright > MIN_UPRIGHT ? (mass * wanted) / upright : 0;
  return {
    thrustLevel: share(push > 0 ? push : 0, shipClass.mainEngineThrust),
    translationInput: [
      share(-RESPONSE * mass * travel.error[0], rcsX),
      share(-RESPONSE * mass * travel.error[1], rcsY),
      share(push < 0 ? push : 0, rcsZ),
    ],
    rotationInput: [0, 0, 0],
    attitudeHold: true,
    attitudeMode: 'radial',
    targetAttitude: [0, 0, 0, 1],
  };
}

/** `force` as a share of `most`, −1 … 1; 0 without thrust. */
function share(force: number, most: number): number {
  if (!(most > 0)) return 0;
  return Math.max(-1, Math.min(1, force / most));
}
