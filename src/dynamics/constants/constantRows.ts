/**
 * What a substep reads of the settings and of a ship's class, each as one row of doubles like ships and bodies. Objects of one shape
 * are not of one shape to an engine (a setting of 1 is another representation than one of 0.5): after a page has seen a few worlds,
 * each number read from one was boxed, 80 bytes per substep. The columns are named here; units as in settings.ts and shipClass.ts.
 */

/** Of the settings: as their names say. */
export const CRASH_SPEED = 0;
export const BOUNCE_SPEED = 1;
export const SETTLE_ANGULAR_VEL = 2;
export const SETTLE_LINEAR_VEL = 3;
export const DAMPING_RATIO = 4;
export const FRICTION_STATIC = 5;
export const FRICTION_KINETIC = 6;
export const COS_SETTLE_TILT = 7;
export const COS_TIPPED_ANGLE = 8;
/** 1: touchdown_attitude aligned; 0: kept. */
export const IS_ALIGNED = 9;
/** 1: surface_normal terrain; 0: radial. */
export const IS_TERRAIN_NORMAL = 10;

/** Of a class. */
export const DRY_MASS = 0;
export const LEG_RADIUS = 1;
/** What the tensor is multiplied by: INERTIA_AT_DRY + INERTIA_PER_FUEL · fuel. */
export const INERTIA_AT_DRY = 2;
export const INERTIA_PER_FUEL = 3;
/** J and J' with full tanks. */
export const SUPPORT_INERTIA = 4;
export const SCRUB_INERTIA = 5;
/** ω_n² and 2 ω_n. */
export const ATTITUDE_STIFFNESS = 6;
export const ATTITUDE_DAMPING = 7;
export const MAIN_ENGINE_THRUST = 8;
export const MAIN_ENGINE_FLOW = 9;
export const RCS_FLOW = 10;
export const FORCE_PER_TORQUE = 11;
/** About or along body x, y, z. */
export const RCS_THRUST = 12;
export const RCS_TORQUE = 15;
export const WHEEL_TORQUE = 18;
export const WHEEL_CAPACITY = 21;
/** Tensor with full tanks and its inverse, row by row. */
export const INERTIA_TENSOR = 24;
export const INVERSE_INERTIA = 33;
