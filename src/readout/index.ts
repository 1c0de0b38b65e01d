/** Numbers a pilot reads, computed from a view by pure functions: painting decides nothing. */

/** The landing of the player's ship. */
export {
  createLandingReadout,
  createLeanLandingReadout,
  updateLandingReadout,
  type LandingReadout,
} from './landing/landing';
/** The flight instruments, landing aids and the direction of the pad. */
export { createFlightReadout, updateFlightReadout, type FlightReadout } from './flight/flight';
export { createLandingAids, updateLandingAids, type LandingAids } from './flight/landingAids';
export { createTargetReadout, updateTargetReadout, type Target, type TargetReadout } from './flight/target';
export { toBodyAxes, toInertial } from './axes';
/** All ships, those that need help first. */
export {
  createFleetReadout,
  updateFleetReadout,
  type FleetReadout,
  type FleetRow,
  FLEET_ORDER,
} from './fleet';
/** Status: word, shape and colour together. */
export { STATUS_LOOKS, type StatusId, type StatusLook } from './status';
/** Parts of a landing. */
export { type Descent } from './landing/descent';
export type { Drift } from './landing/drift';
export type { Gate, Gates } from './landing/gates';
export type { Righting } from './landing/ahead/righting';
export type { Tilt } from './landing/tilt';
export type { TipMargin } from './landing/tipMargin';
export type { Touchdown } from './landing/touchdown';
/** Actions of keys, for hints that name them. */
export {
  type HintAction,
  ROTATION_ACTIONS,
  type RotationAction,
  TRANSLATION_ACTIONS,
  type TranslationAction,
} from './actions';
/** Texts of numbers. */
export * from './formats';
/** Where a state comes from, in words. */
export { provenanceText, withdrawnText } from './provenance';
