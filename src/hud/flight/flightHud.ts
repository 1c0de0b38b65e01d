import { createFrame, type HudAppearance } from '../appearance';
import { checked, requireHost } from '../checks';
import type { FlightReadout, LandingAids, TargetReadout } from '../../readout';
import type { Hud } from '../hud';
import { createAidsPanel } from './aidsPanel';
import { createApproachDial } from './approachDial';
import { createAttitudeBall } from './attitudeBall';
import { createEngineLever } from './engineLever';
import { createFuelPanel } from './fuelPanel';
import { createModesPanel, type FlightKey } from './modesPanel';

/** The readouts that the flight instruments show. */
export interface FlightPanels {
  readonly flight: FlightReadout;
  readonly aids: LandingAids;
  readonly target: TargetReadout;
  readonly autopilot: boolean;
  /** Whether the landing aids are switched on. */
  readonly aidsOn: boolean;
}

export interface FlightHudOptions extends HudAppearance {
  /** Names the key of a mode; '' when it has none. Called at every paint. */
  readonly keyLabel?: (key: FlightKey) => string;
}

/**
 * Creates the flight instruments and appends them to `host` (HUD, Flight instruments): lever with the hover mark, fuel, attitude ball, modes
 * with their keys, and the landing aids.
 *
 * @example
 * ```ts
 * const hud = createFlightHud(document, host);
 * const flight = updateFlightReadout(createFlightReadout(), predictor.view(now));
 * const [aids, target] = [createLandingAids(), createTargetReadout()];
 * hud.paint({ flight, aids, target, autopilot: false, aidsOn: false });
 * ```
 */
export function createFlightHud(
  document: Document,
  host: Element | ShadowRoot,
  options: FlightHudOptions = {},
): Hud<FlightPanels> {
  requireHost(document, host, options);
  const { root, panel, dispose } = createFrame(document, 'flight', 'Flight', options);
  const paintLever = createEngineLever(panel);
  const paintFuel = createFuelPanel(panel);
  const paintBall = createAttitudeBall(panel);
  const paintModes = createModesPanel(panel, options.keyLabel ?? (() => ''));
  const paintAids = createAidsPanel(panel);
  const paintDial = createApproachDial(panel);
  host.append(root);
  const hud = {
    ...({ root, members: ['flight', 'aids', 'target'], madeBy: 'each update function' } as const),
    paint({ flight, aids, target, autopilot, aidsOn }: FlightPanels) {
      paintLever(flight);
      paintFuel(flight);
      paintBall(flight);
      paintModes(flight, autopilot);
      paintAids(aids, aidsOn);
      paintDial(target, aidsOn);
    },
    dispose,
  };
  return checked(hud, options.onWarning);
}
