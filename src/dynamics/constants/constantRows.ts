/**
 * Constants of the settings and of a ship class that a substep reads, each set as one row of doubles. An engine represents integers and
 * fractions in objects differently (1 and 0.5), so after a page had loaded a few worlds each number read from such objects was boxed,
 * 80 bytes per substep. Columns are named here; units as in settings.ts and shipClass.ts.
 */

/** Columns of the settings. */
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

/** Columns of a class. */
export const DRY_MASS = 0;
export const LEG_RADIUS = 1;
/** Factor on the inertia tensor: INERTIA_AT_DRY + INERTIA_PER_FUEL · fuel. */
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
/** Three columns each, about or along body x, y, z. */
export const RCS_THRUST = 12;
export const RCS_TORQUE = 15;
export const WHEEL_TORQUE = 18;
export const WHEEL_CAPACITY = 21;
/** Inertia tensor with full tanks and its inverse, nine columns each, row by row. */
export const INERTIA_TENSOR = 24;
export const INVERSE_INERTIA = 33;
