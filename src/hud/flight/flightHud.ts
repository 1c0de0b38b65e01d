import type { FlightReadout, LandingAids, TargetReadout } from '../../readout';
import type { Hud } from '../landingHud';
import { createAidsPanel } from './aidsPanel';
import { createApproachDial } from './approachDial';
import { createAttitudeBall } from './attitudeBall';
import { createEngineLever } from './engineLever';
import { createFuelPanel } from './fuelPanel';
import { createModesPanel, type FlightKey } from './modesPanel';

/** What the instruments of flying show. */
export interface FlightPanels {
  readonly flight: FlightReadout;
  readonly aids: LandingAids;
  readonly target: TargetReadout;
  readonly autopilot: boolean;
  /** The landing aids are switched on. */
  readonly aidsOn: boolean;
}

export interface FlightHudOptions {
  /** Names the key of a mode; '' when it has none. Asked anew at every paint. */
  readonly keyLabel?: (key: FlightKey) => string;
}

/**
 * The instruments of flying, appended to `host` (HUD, a pilot's instruments): lever with the hover mark, fuel, attitude ball, modes
 * with their keys, and the landing aids.
 */
export function createFlightHud(
  document: Document,
  host: Element,
  options: FlightHudOptions = {},
): Hud<FlightPanels> {
  const root = document.createElement('section');
  root.className = 'hud hud-flight';
  root.setAttribute('aria-label', 'Flight');
  const paintLever = createEngineLever(root);
  const paintFuel = createFuelPanel(root);
  const paintBall = createAttitudeBall(root);
  const paintModes = createModesPanel(root, options.keyLabel ?? (() => ''));
  const paintAids = createAidsPanel(root);
  const paintDial = createApproachDial(root);
  host.append(root);
  return {
    paint({ flight, aids, target, autopilot, aidsOn }) {
      paintLever(flight);
      paintFuel(flight);
      paintBall(flight);
      paintModes(flight, autopilot);
      paintAids(aids, aidsOn);
      paintDial(target, aidsOn);
    },
    dispose: () => root.remove(),
  };
}
