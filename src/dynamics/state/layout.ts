/**
 * Each ship and each body is one row of a Float64Array, so that history, copy, hash, comparison and transfer are one line each.
 * Columns are named only here. SI units, radians; vectors in ICRF axes unless stated; quaternions (x, y, z, w).
 */

/** Centre of mass relative to the reference body's centre, m; the frame falls freely with that centre and has ICRF axes. */
export const POSITION = 0;
/** Velocity in that frame, m/s. */
export const VELOCITY = 3;
/** Rotates body axes into ICRF, unit. */
export const ATTITUDE = 6;
/** rad/s, ICRF axes. */
export const ANGULAR_VELOCITY = 10;
/** kg. */
export const FUEL = 13;
/** Momentum stored in the reaction wheels, N m s, body axes; 0 at spawn. */
export const WHEEL_MOMENTUM = 14;
/** Impact speed of the touch that began this contact, m/s; 0 in flight. */
export const IMPACT_SPEED = 17;
/** One of FLYING, CONTACT, LANDED, TIPPED. */
export const SURFACE_STATE = 18;
/** Index into World.bodies; in ground states the body that the ship is on. */
export const REFERENCE_BODY = 19;
/** 1 once crashed: the ship is not simulated until it is respawned. */
export const CRASHED = 20;
/** Index into World.shipClasses. */
export const SHIP_CLASS = 21;
/** h: height of the centre of mass above the feet, m; the class's unless the ship's state has its own. */
export const GROUND_CONTACT_OFFSET = 22;
/** 0 … 1. */
export const THRUST_LEVEL = 23;
/** −1 … 1 along body x, y, z. */
export const TRANSLATION_INPUT = 24;
/** −1 … 1 about body x (pitch), y (yaw), z (roll). */
export const ROTATION_INPUT = 27;
/** 1 = rate damping. */
export const ATTITUDE_HOLD = 30;
/** Index into ATTITUDE_MODES, or MODE_UNKNOWN. */
export const ATTITUDE_MODE = 31;
/** For attitude mode hold: rotates body axes into ICRF, unit. */
export const TARGET_ATTITUDE = 32;
export const SHIP_STRIDE = 36;

export const FLYING = 0;
export const CONTACT = 1;
export const LANDED = 2;
export const TIPPED = 3;

/** The game's `surface_contact_state` of each state. */
export const SURFACE_STATES = ['', 'contact', 'landed', 'tipped'] as const;
export type SurfaceState = (typeof SURFACE_STATES)[number];

/** Attitude modes of the dynamics. */
export const ATTITUDE_MODES = [
  'none',
  'hold',
  'prograde',
  'retrograde',
  'surface_retrograde',
  'normal',
  'antinormal',
  'radial',
  'antiradial',
] as const;
/** 'unknown' stands for any other mode of the game and acts like none with attitude_hold. */
export type AttitudeMode = (typeof ATTITUDE_MODES)[number] | 'unknown';
export const MODE_NONE = 0;
export const MODE_HOLD = 1;
export const MODE_PROGRADE = 2;
export const MODE_RETROGRADE = 3;
export const MODE_SURFACE_RETROGRADE = 4;
export const MODE_ANTINORMAL = 6;
export const MODE_RADIAL = 7;
export const MODE_ANTIRADIAL = 8;
export const MODE_UNKNOWN = 9;

/** Events of a ship, at most one per substep. */
export const NO_EVENT = 0;
export const EVENT_CONTACT = 1;
export const EVENT_LANDED = 2;
export const EVENT_TIPPED = 3;
export const EVENT_RIGHTED = 4;
export const EVENT_DESTROYED = 5;
/** The game's event names; index 0 is no event. */
export const EVENT_NAMES = [
  '',
  'ship.contact',
  'ship.landed',
  'ship.tipped',
  'ship.righted',
  'ship.destroyed',
] as const;
export type ShipEventName = Exclude<(typeof EVENT_NAMES)[number], ''>;

/** Body row: centre, m, ICRF. Moves once per tick; used only for the wire and to change the reference body. */
export const BODY_POSITION = 0;
/** m/s, ICRF. */
export const BODY_VELOCITY = 3;
/** Ω, rad/s, ICRF axes. */
export const BODY_ANGULAR_VELOCITY = 6;
/** Rotates body axes (Y pole, Z prime meridian, X 90° E) into ICRF, at the substep's start. */
export const BODY_ATTITUDE = 9;
/** The attitude at the substep's end; equal to BODY_ATTITUDE between substeps. */
export const BODY_END_ATTITUDE = 13;
export const BODY_STRIDE = 17;
