import type { LoadedBody } from './body';
import type { LoadedShipClass } from './shipClass';
import type { World } from './world';

/**
 * The quantities of one substep of one ship (DYNAMICS, Quantities), in scratch doubles that the passes hand on:
 * a double passed as an argument or returned by a function that is not inlined is boxed, one that stands here is not.
 */
export const quantity = new Float64Array(80);

/** Where the ship stands to the ground, at the substep's start and again at its end: columns from one of these two on. */
export const START = 0;
export const END = 16;
/** n = r / ‖r‖, ICRF: local up and the surface normal. */
export const NORMAL = 0;
/** surface_r − ‖r‖, m; positive below the surface. */
export const PENETRATION = 3;
/** v_rel · n, m/s; positive upward. */
export const RADIAL_SPEED = 4;
/** v_rel − v_radial n, m/s, ICRF. */
export const TANGENTIAL_VELOCITY = 5;
/** Its length, m/s. */
export const TANGENTIAL_SPEED = 8;
/** g = G mass / ‖r‖², m/s². */
export const GRAVITY = 9;

/** Rotation matrix of the ship's attitude, row by row; its third column is `up`. */
export const AXES = 32;
/** m, kg: from before the burn. */
export const MASS = 41;
/** m / full mass: scales the class's inertia tensor. */
export const MASS_RATIO = 42;
/** N, from mass before the burn and gravity at the start. */
export const WEIGHT = 43;
/** N, ICRF. */
export const THRUST = 44;
/** thrust · n, N. */
export const LIFT = 47;
/** From the actuators, N m, body axes. */
export const TORQUE = 48;
/** Σ|tau_rcs|, N m: what burns fuel. */
export const RCS_TORQUE_SUM = 51;
/** Static penetration under what the thrust leaves of the weight, m. */
export const DEPTH = 52;
/** F_n, N. */
export const NORMAL_FORCE = 53;
/** Attitude control's wish, rad/s², body axes. */
export const WISH = 54;
/** A rotation under way, quaternion. */
export const ROTATION = 57;
/** Vectors a rotation is made from and to, and its axis. */
export const FROM = 61;
export const TO = 64;
export const AXIS = 67;
/** n · up at the substep's end. */
export const COS_TILT = 71;
/** Speed at which ship and ground close at the substep's end, m/s. */
export const IMPACT = 72;
/** Wheel + RCS torque there is about each body axis, N m. */
export const AVAILABLE = 73;
/** Seconds of game time a substep. */
export const DT = 70;

/**
 * `at & INDEX` is `at` for every row there can be (two million ships), and tells the engine that `at + COLUMN` cannot overflow:
 * without that check at each access a substep takes a sixth less time.
 */
export const INDEX = 0x3ffffff;

/** What a substep works on: the rows it changes, and what of the world it reads. Filled anew for each ship. */
export interface Step {
  ships: Float64Array;
  /** Of the ship's row. */
  at: number;
  bodies: Float64Array;
  /** Of the reference body's row. */
  bodyAt: number;
  body: LoadedBody;
  shipClass: LoadedShipClass;
  world: World;
}
