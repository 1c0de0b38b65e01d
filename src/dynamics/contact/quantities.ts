import type { LoadedBody } from '../constants/body';
import { SHIP_STRIDE } from '../state/layout';
import type { TerrainHeight, World } from '../constants/world';

export { SMI_MASK } from '../state/smiMask';

/**
 * Quantities of one ship's substep (DYNAMICS, Quantities), in scratch doubles shared by the passes. A double that is passed to or
 * returned from a function that the engine does not inline is boxed; a double stored here is not.
 */
export const quantities = new Float64Array(96);

/**
 * The first SHIP_STRIDE slots are a copy of the ship's row (layout.ts): the engine reads a constant index of a constant array without
 * a bounds check.
 */

/** Columns of `start` and `end`, the ship's relation to the ground. n = r / ‖r‖, ICRF: the radial direction. */
export const NORMAL = 0;
/** ‖r‖, m. */
export const DISTANCE = 3;
/** g = G mass / ‖r‖², m/s². */
export const GRAVITY = 4;
/** n in body axes of the reference body. */
export const BODY_NORMAL = 5;
/** surface_r − ‖r‖, m; positive below the surface. */
export const PENETRATION = 8;
/** s, the surface normal, ICRF. */
export const SURFACE_NORMAL = 9;
/** c_s = n · s; 1 where the surface normal is radial. */
export const COS_SLOPE = 12;
/** v_s = v_rel · s, m/s; positive away from the ground. */
export const NORMAL_SPEED = 13;
/** v_tangential = v_rel − v_s s, m/s, ICRF. */
export const TANGENTIAL_VELOCITY = 14;
/** ‖v_tangential‖², m²/s². */
export const TANGENTIAL_SPEED_SQUARED = 17;
/** n − c_s s, ICRF: points uphill, length is the sine of the slope; 0 where the surface normal is radial. */
export const SLOPE = 18;
/** Distance of the ground under the ship from the body's centre, terrain included, m. */
export const GROUND_RADIUS = 21;
const SURFACE_LENGTH = 22;
/** Rows of the columns above, at the substep's start and end. */
export const start = new Float64Array(SURFACE_LENGTH);
export const end = new Float64Array(SURFACE_LENGTH);

/** Rotation matrix of the ship's attitude, row by row; its third column is `up`. */
export const AXES = 36;
/** m, kg, before the substep's burn. */
export const MASS = 45;
/** Factor on the class's inertia tensor at the present fuel. */
export const INERTIA_FACTOR = 46;
/** Mass before the burn × gravity at the start, N. */
export const WEIGHT = 47;
/** N, ICRF. */
export const THRUST = 48;
/** thrust · n, N. */
export const LIFT = 51;
/** Torque of the actuators, later with the ground's moments, N m, body axes. */
export const TORQUE = 52;
/** Σ|tau_rcs|, N m: the torque that burns fuel. */
export const RCS_TORQUE_SUM = 55;
/** Force into the ground, weight less thrust along s, N, ≥ 0. */
export const LOAD = 56;
/** Tangential part of weight n − thrust, N, ICRF: minus the force along the ground other than friction. */
export const ALONG = 57;
/** Static penetration under the load, m. */
export const DEPTH = 60;
/** F_n, N. */
export const NORMAL_FORCE = 61;
/** Angular acceleration commanded by the attitude controller, rad/s², body axes. */
export const ANGULAR_ACCEL_COMMAND = 62;
/** Unit quaternion of the rotation to apply, ICRF axes. */
export const ROTATION = 65;
/** Unit vectors, ICRF: ROTATION takes FROM to TO; AXIS is a rotation's axis or a pointing direction. */
export const FROM = 69;
export const TO = 72;
export const AXIS = 75;
/** s · up at the substep's end. */
export const COS_TILT = 78;
/** Closing speed of ship and ground at the substep's end, m/s. */
export const IMPACT = 79;
/** Game seconds per substep. */
export const DT = 80;
/** Two level unit directions, body axes, and the ground's slope along each, m/m. */
export const LEVEL_1 = 81;
export const LEVEL_2 = 84;
export const RISE = 87;
/** The slope is sampled at the four directions n_b POINT[0] ± e POINT[1], e a level direction. */
export const POINT = 89;
/** Ω of the reference body, rad/s, ICRF; a copy, since slots here are read without a bounds check. */
export const GROUND_SPIN = 91;
/** Indices of the body and the ship class that `step` was filled for. */
export const STEP_BODY = 94;
export const STEP_CLASS = 95;

/** Every slot and its length in doubles; a test checks that none overlap. */
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
  [STEP_BODY, 1],
  [STEP_CLASS, 1],
];

/** The same for the columns of `start` and `end`. */
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

/** Inputs of one ship's substep, other than its row. */
export interface Step {
  /** Offset of the ship's row. */
  at: number;
  bodies: Float64Array;
  /** The world that the fields below are read from. */
  world: World;
  /** Offset of the reference body's row. */
  bodyAt: number;
  body: LoadedBody;
  /** Constants of the ship's class and of the settings; columns in constantRows.ts. */
  shipClass: Float64Array;
  settings: Float64Array;
  terrainHeight: TerrainHeight;
}
