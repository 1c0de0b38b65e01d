/** Both HUDs: painting only. What they show is decided in readout. */
import './hud.css';
import './status.css';
import './instruments.css';
import './panels.css';
import './fleet.css';
import './smallScreens.css';

export {
  createCockpitLandingHud,
  createCockpitLandingHud as cockpitLandingHud,
  type Hud,
  type LandingHudOptions,
} from './landingHud';
export { createFleetHud, createFleetHud as fleetHud } from './fleetHud';
/** Names keys in hints. */
export type { KeyLabel } from './rightingPanel';
