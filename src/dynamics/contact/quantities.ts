import type { LoadedBody } from '../constants/body';
import type { TerrainHeight, World } from '../constants/world';

export { SMI_MASK } from '../state/smiMask';

/**
 * Quantities of one ship's substep (DYNAMICS, Quantities), in scratch doubles shared by the passes. A double that is passed to or
 * returned from a function that the engine does not inline is boxed; a double stored here is not, and a constant index of a constant
 * array is read without a bounds check.
 */
export const quantities = new Float64Array(87);

/** Rotation matrix of the ship's attitude, row by row, where it is needed; its third column, `up`, is kept current. */
export const AXES = 0;
/** m, kg, before the substep's burn. */
export const MASS = 9;
/** Factor on the class's inertia tensor at the present fuel. */
export const INERTIA_FACTOR = 10;
/** Mass before the burn × gravity at the start, N. */
export const WEIGHT = 11;
/** N, ICRF. */
export const THRUST = 12;
/** thrust · n, N. */
export const LIFT = 15;
/** Torque of the actuators, N m, body axes. */
export const TORQUE = 16;
/** Σ|tau_rcs|, N m: the torque that burns fuel. */
export const RCS_TORQUE_SUM = 19;
/** From here to SLOPE: the ship against the ground, at the start, later at the end. n = r / ‖r‖, ICRF: the radial direction. */
export const NORMAL = 20;
/** ‖r‖, m, and ‖r‖², m². */
export const DISTANCE = 23;
export const DISTANCE_SQUARED = 24;
/** surface_r − ‖r‖, m; positive below the surface. */
export const PENETRATION = 25;
/** s, the surface normal, ICRF. */
export const SURFACE_NORMAL = 26;
/** c_s = n · s; 1 where the surface normal is radial. */
export const COS_SLOPE = 29;
/** n − c_s s, ICRF: points uphill, length is the sine of the slope; 0 where the surface normal is radial. */
export const SLOPE = 30;
/** v_s = v_rel · s, m/s; positive away from the ground. */
export const NORMAL_SPEED = 33;
/** PENETRATION at the start, m. */
export const START_PENETRATION = 34;
/** Position at the start of a flying ship's substep, m, as in the row. */
export const START_POSITION = 35;
/** F_n, N. */
export const NORMAL_FORCE = 38;
/** Angular acceleration commanded by the attitude controller, rad/s², body axes. */
export const ANGULAR_ACCEL_COMMAND = 39;
/** Unit quaternion of the rotation to apply, ICRF axes. */
export const ROTATION = 42;
/** Unit vectors, ICRF: ROTATION takes FROM to TO; AXIS is a rotation's axis or a pointing direction. */
export const FROM = 46;
export const TO = 49;
export const AXIS = 52;
/** s · up at the substep's end. */
export const COS_TILT = 55;
/** Game seconds per substep. */
export const DT = 56;
/** n in body axes of the reference body, and the distance of the ground there from its centre, m: where the slope is read. */
export const BODY_NORMAL = 57;
export const GROUND_RADIUS = 60;
/** Rotation matrix of the body's attitude, row by row, where the slope is read. */
export const BODY_AXES = 61;
/** Two level unit directions, body axes, and the ground's slope along each, m/m. */
export const LEVEL_1 = 70;
export const LEVEL_2 = 73;
export const RISE = 76;
/** The slope is sampled at the four directions n_b POINT[0] ± e POINT[1], e a level direction. */
export const POINT = 78;
/** Ω of the reference body, rad/s, ICRF; a copy, since slots here are read without a bounds check. */
export const GROUND_SPIN = 80;
/** Indices of the body and the ship class that `step` was filled for. */
export const STEP_BODY = 83;
export const STEP_CLASS = 84;
/** The body's radius, m, and G · mass, m³/s². */
export const BODY_RADIUS = 85;
export const GRAVITY_PARAMETER = 86;

/** Every slot and its length in doubles; a test checks that none overlap. */
export const SLOTS: readonly (readonly [slot: number, length: number])[] = [
  [AXES, 9],
  [MASS, 1],
  [INERTIA_FACTOR, 1],
  [WEIGHT, 1],
  [THRUST, 3],
  [LIFT, 1],
  [TORQUE, 3],
  [RCS_TORQUE_SUM, 1],
  [NORMAL, 3],
  [DISTANCE, 1],
  [DISTANCE_SQUARED, 1],
  [PENETRATION, 1],
  [SURFACE_NORMAL, 3],
  [COS_SLOPE, 1],
  [SLOPE, 3],
  [NORMAL_SPEED, 1],
  [START_PENETRATION, 1],
  [START_POSITION, 3],
  [NORMAL_FORCE, 1],
  [ANGULAR_ACCEL_COMMAND, 3],
  [ROTATION, 4],
  [FROM, 3],
  [TO, 3],
  [AXIS, 3],
  [COS_TILT, 1],
  [DT, 1],
  [BODY_NORMAL, 3],
  [GROUND_RADIUS, 1],
  [BODY_AXES, 9],
  [LEVEL_1, 3],
  [LEVEL_2, 3],
  [RISE, 2],
  [POINT, 2],
  [GROUND_SPIN, 3],
  [STEP_BODY, 1],
  [STEP_CLASS, 1],
  [BODY_RADIUS, 1],
  [GRAVITY_PARAMETER, 1],
];

/** Where the row of the substep's ship is, and its other inputs. */
export interface Step {
  /** The ships' rows. */
  ships: Float64Array;
  /** Offset of the ship's row. */
  at: number;
  bodies: Float64Array;
  /** Offset of the reference body's row. */
  bodyAt: number;
  /** The world that the fields below are read from. */
  world: World;
  body: LoadedBody;
  /** Constants of the ship's class and of the settings; columns in constantRows.ts. */
  shipClass: Float64Array;
  settings: Float64Array;
  terrainHeight: TerrainHeight;
}

/** The present substep's. */
export const step = { ships: quantities, at: 0, bodies: quantities, bodyAt: 0 } as Step;
