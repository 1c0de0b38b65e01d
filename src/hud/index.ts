/** Both HUDs: painting only. What they show is decided in readout; their style sheet is hud.css. */

export {
  createCockpitLandingHud,
  createCockpitLandingHud as cockpitLandingHud,
  type Hud,
  type LandingHudOptions,
} from './landingHud';
export { createFleetHud, createFleetHud as fleetHud } from './fleetHud';
/** Theme and layout. */
export type { HudAppearance } from './appearance';
/** Names keys in hints. */
export type { KeyLabel } from './rightingPanel';
