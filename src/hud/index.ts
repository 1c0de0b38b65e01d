/** The HUDs: painting only. Readouts decide the contents; the style sheet is hud.css. */

export type { Hud } from './hud';
export { createCockpitLandingHud, type LandingHudOptions } from './landing/landingHud';
export { createFleetHud } from './fleet/fleetHud';
export { createFlightHud, type FlightHudOptions, type FlightPanels } from './flight/flightHud';
export type { FlightKey } from './flight/modesPanel';
/** Theme and layout. */
export type { HudAppearance } from './appearance';
/** Warnings of a HUD that cannot be seen. */
export type { HudWarn } from './checks';
/** Names keys in hints. */
export type { KeyLabel, TurnKey, TurnKeys } from './landing/rightingPanel';
