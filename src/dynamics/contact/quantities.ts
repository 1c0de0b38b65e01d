import type { LoadedBody } from '../constants/body';
import { SHIP_STRIDE } from '../state/layout';
import type { TerrainHeight } from '../constants/world';

export { SMI_MASK } from '../state/smiMask';

/**
 * The quantities of one substep of one ship (DYNAMICS, Quantities), in scratch doubles that the passes hand on:
 * a double passed as an argument or returned by a function that is not inlined is boxed, one that stands here is not.
 */
export const quantities = new Float64Array(94);

/**
 * The first SHIP_STRIDE slots are the ship's row (layout.ts), copied in and out: a slot at a constant place of a constant array is read
 * without a check of its bounds.
 */

/** How a surface stands to a ship: columns of `start` and `end`. n = r / ‖r‖, ICRF: local up. */
export const NORMAL = 0;
/** ‖r‖, m. */
export const DISTANCE = 3;
/** g = G mass / ‖r‖², m/s². */
export const GRAVITY = 4;
/** n in the body's axes. */
export const BODY_NORMAL = 5;
/** surface_r − ‖r‖, m; positive below the surface. */
export const PENETRATION = 8;
/** s, ICRF: the surface normal. */
export const SURFACE_NORMAL = 9;
/** c_s = n · s; 1 where the surface normal is radial. */
export const COS_SLOPE = 12;
/** v_s = v_rel · s, m/s; positive off the ground. */
export const NORMAL_SPEED = 13;
/** v_rel − v_s s, m/s, ICRF. */
export const TANGENTIAL_VELOCITY = 14;
/** ‖v_tangential‖², m²/s². */
export const TANGENTIAL_SPEED_SQUARED = 17;
/** n − c_s s, ICRF: how the ground slopes; 0 where the surface normal is radial. */
export const SLOPE = 18;
/** Radius of the ground below, terrain included, m. */
export const GROUND_RADIUS = 21;
const SURFACE_LENGTH = 22;
/** Where the ship stands to the ground, at the substep's start and again at its end: the columns above. */
export const start = new Float64Array(SURFACE_LENGTH);
export const end = new Float64Array(SURFACE_LENGTH);

/** Rotation matrix of the ship's attitude, row by row; its third column is `up`. */
export const AXES = 36;
/** m, kg: from before the burn. */
export const MASS = 45;
/** What the class's inertia tensor is multiplied by at this fuel. */
export const INERTIA_FACTOR = 46;
/** N, from mass before the burn and gravity at the start. */
export const WEIGHT = 47;
/** N, ICRF. */
export const THRUST = 48;
/** thrust · n, N. */
export const LIFT = 51;
/** From the actuators, N m, body axes. */
export const TORQUE = 52;
/** Σ|tau_rcs|, N m: what burns fuel. */
export const RCS_TORQUE_SUM = 55;
/** What presses into the ground, N, ≥ 0. */
export const LOAD = 56;
/** What pushes along the ground, N, ICRF. */
export const ALONG = 57;
/** Static penetration under the load, m. */
export const DEPTH = 60;
/** F_n, N. */
export const NORMAL_FORCE = 61;
/** The angular acceleration that the attitude controller asks for, rad/s², body axes. */
export const ANGULAR_ACCEL_COMMAND = 62;
/** A rotation under way, quaternion. */
export const ROTATION = 65;
/** Vectors a rotation is made from and to, and its axis. */
export const FROM = 69;
export const TO = 72;
export const AXIS = 75;
/** s · up at the substep's end. */
export const COS_TILT = 78;
/** Speed at which ship and ground close at the substep's end, m/s. */
export const IMPACT = 79;
/** Seconds of game time per substep. */
export const DT = 80;
/** The two level directions in which the slope is measured, body's axes, and the ground's rise along each. */
export const LEVEL_1 = 81;
export const LEVEL_2 = 84;
export const RISE = 87;
/** The four points of the ground that it is measured at are n_b POINT[0] ± e POINT[1]. */
export const POINT = 89;
/** Ω of the reference body, rad/s, ICRF: a copy, since a slot here is read without a check of its bounds. */
export const GROUND_SPIN = 91;

/** Every slot and how many doubles it holds: a test finds two that overlap. */
export const SLOTS: readonly (readonly [slot: number, length: number])[] = [
  [0, SHIP_STRIDE],
  [AXES, 9],
  [MASS, 1],
  [INERTIA_FACTOR, 1],
  [WEIGHT, 1],
  [THRUST, 3],
  [LIFT, 1],
  [TORQUE, 3],
  [RCS_TORQUE_SUM, 1],
  [LOAD, 1],
  [ALONG, 3],
  [DEPTH, 1],
  [NORMAL_FORCE, 1],
  [ANGULAR_ACCEL_COMMAND, 3],
  [ROTATION, 4],
  [FROM, 3],
  [TO, 3],
  [AXIS, 3],
  [COS_TILT, 1],
  [IMPACT, 1],
  [DT, 1],
  [LEVEL_1, 3],
  [LEVEL_2, 3],
  [RISE, 2],
  [POINT, 2],
  [GROUND_SPIN, 3],
];

/** The columns of `start` and `end`, likewise. */
export const SURFACE_SLOTS: readonly (readonly [slot: number, length: number])[] = [
  [NORMAL, 3],
  [DISTANCE, 1],
  [GRAVITY, 1],
  [BODY_NORMAL, 3],
  [PENETRATION, 1],
  [SURFACE_NORMAL, 3],
  [COS_SLOPE, 1],
  [NORMAL_SPEED, 1],
  [TANGENTIAL_VELOCITY, 3],
  [TANGENTIAL_SPEED_SQUARED, 1],
  [SLOPE, 3],
  [GROUND_RADIUS, 1],
];

/** What a substep works on: the rows it changes, and what of the world it reads. Filled anew for each ship. */
export interface Step {
  /** Number of the ship's row. */
  row: number;
  bodies: Float64Array;
  /** Of the reference body's row. */
  bodyAt: number;
  body: LoadedBody;
  /** Constants of the ship's class and of the settings, columns of constantRows.ts. */
  shipClass: Float64Array;
  settings: Float64Array;
  terrainHeight: TerrainHeight;
}
