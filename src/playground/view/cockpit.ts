import {
  createCockpitLandingHud,
  createFleetHud,
  createFlightHud,
  type KeyLabel,
  type TurnKeys,
} from '../../hud';
import type { WorldView } from '../../prediction';
import {
  createFleetReadout,
  createFlightReadout,
  createLandingAids,
  createLandingReadout,
  createTargetReadout,
  type FlightReadout,
  type LandingAids,
  type LandingReadout,
  updateFleetReadout,
  updateFlightReadout,
  updateLandingAids,
  updateLandingReadout,
  updateTargetReadout,
  type Target,
} from '../../readout';
import type { FlightKey } from '../../hud';

export interface CockpitContext {
  readonly host: Element;
  readonly flightHost: Element;
  readonly keyLabel: KeyLabel;
  readonly turnKeys: TurnKeys;
  readonly modeLabel: (key: FlightKey) => string;
  readonly target: () => Target | null;
  readonly screen: () => Float64Array;
  readonly isAutopilotOn: () => boolean;
}

/** All displays, from one view per frame. */
export interface Cockpit {
  readonly paint: (view: WorldView, turn: Turn) => void;
  /** Another world: clears everything remembered of the old one. */
  readonly forget: () => void;
  readonly landing: () => LandingReadout;
  readonly flight: FlightReadout;
  readonly aids: LandingAids;
  readonly aidsOn: () => boolean;
  readonly toggleAids: () => boolean;
}

/** Which displays a frame paints. */
export type Turn = 'all' | 'landing' | 'flight' | 'none';

/** All displays; while frames come fast, each in every other frame, and none in a busy one. */
export function createTurns(): (isFast: boolean, isBusy: boolean) => Turn {
  let isFlights = false;
  return (isFast, isBusy) => {
    if (!isFast) return 'all';
    if (isBusy) return 'none';
    isFlights = !isFlights;
    return isFlights ? 'flight' : 'landing';
  };
}

export function createCockpit(document: Document, context: CockpitContext): Cockpit {
  let landing = createLandingReadout();
  const flight = createFlightReadout();
  const aids = createLandingAids();
  const target = createTargetReadout();
  const fleet = createFleetReadout();
  let aidsOn = true;
  const { keyLabel, turnKeys } = context;
  const landingHud = createCockpitLandingHud(document, context.host, { theme: 'system', keyLabel, turnKeys });
  const fleetHud = createFleetHud(document, context.host, { theme: 'system' });
  const flightHud = createFlightHud(document, context.flightHost, {
    theme: 'system',
    keyLabel: context.modeLabel,
  });
  return {
    flight,
    aids,
    landing: () => landing,
    aidsOn: () => aidsOn,
    toggleAids: () => (aidsOn = !aidsOn),
    forget() {
      landing = createLandingReadout();
    },
    paint(view, turn) {
      updateFlightReadout(flight, view);
      if (aidsOn) updateLandingAids(aids, view);
      if (turn === 'all' || turn === 'landing') {
        landingHud.paint(updateLandingReadout(landing, view));
        fleetHud.paint(updateFleetReadout(fleet, view));
      }
      if (turn !== 'all' && turn !== 'flight') return;
      updateTargetReadout(target, view, context.target(), context.screen(), aids);
      flightHud.paint({ flight, aids, target, autopilot: context.isAutopilotOn(), aidsOn });
    },
  };
}
