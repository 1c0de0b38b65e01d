/** Both HUDs: painting only. What they show is decided in readout. */
import './hud.css';
import './status.css';
import './instruments.css';
import './panels.css';
import './fleet.css';
import './flight/flight.css';
import './smallScreens.css';

export {
  createCockpitLandingHud,
  createCockpitLandingHud as cockpitLandingHud,
  type Hud,
  type LandingHudOptions,
} from './landingHud';
export { createFleetHud, createFleetHud as fleetHud } from './fleetHud';
export { createFlightHud, type FlightHudOptions, type FlightPanels } from './flight/flightHud';
export type { FlightKey } from './flight/modesPanel';
/** Names keys in hints. */
export type { KeyLabel, TurnKey, TurnKeys } from './rightingPanel';
