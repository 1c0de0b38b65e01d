import type { Provenance, ShipView, WorldView } from '../../prediction';
import { createDescent, type Descent, forgetDescent, measureDescent } from './descent';
import { createDrift, type Drift, forgetDrift, measureDrift } from './drift';
import { createGates, type Gates, measureGates } from './gates';
import { createViewClock, followView, type ViewClock } from './viewClock';
import { createLookAhead, type LookAhead } from './ahead/lookAhead';
import { createRighting, type Righting } from './ahead/righting';
import { type StatusId, statusOf } from '../status';
import { createSurface, measureSurface, type Surface } from '../surface';
import { createTilt, forgetTilt, measureTilt, type Tilt } from './tilt';
import { createTipMargin, measureTipMargin, type TipMargin } from './tipMargin';
import { createTouchdown, readTouchdown, type Touchdown } from './touchdown';
import { viewOf } from '../arguments';

/** Everything the cockpit's landing HUD shows of the player's ship: numbers in named units, decisions made. */
export interface LandingReadout {
  status: StatusId;
  provenance: Provenance;
  /** Wall s, of the provenance. */
  age: number;
  /** Game s per wall s. */
  timeScale: number;
  /** A predicted state that the server did not have, shown as withdrawn; '' for none. */
  withdrawn: ShipView['withdrawn'];
  /** False without a ship or a recent state: numbers are NaN, to be dashed, and the status hatched. */
  known: boolean;
  shipName: string;
  bodyName: string;
  readonly descent: Descent;
  readonly tilt: Tilt;
  readonly drift: Drift;
  readonly gates: Gates;
  readonly margin: TipMargin;
  readonly righting: Righting;
  readonly touchdown: Touchdown;
  /** Whether the card belongs to the status shown. */
  touchdownShown: boolean;
  /** Kept from view to view; not shown. @internal */
  readonly memory: LandingMemory;
}

interface LandingMemory {
  readonly surface: Surface;
  readonly clock: ViewClock;
  /** Null in a lean readout. */
  readonly ahead: LookAhead | null;
}

/**
 * An empty readout for the landing HUD; updateLandingReadout fills it.
 *
 * @example
 * ```ts
 * const readout = updateLandingReadout(createLandingReadout(), predictor.view(now));
 * console.log(readout.descent.verticalSpeed); // m/s
 * ```
 */
export function createLandingReadout(): LandingReadout {
  return readoutWith(createLookAhead());
}

/**
 * An empty readout that simulates nothing ahead, for a page that loads less: the same numbers, without the time until a leaning ship has
 * tipped (`margin.outlook` stays 'working') and without the help for a tipped one (`righting.shown` stays false).
 *
 * @example
 * ```ts
 * const readout = updateLandingReadout(createLeanLandingReadout(), predictor.view(now));
 * console.log(readout.tilt, readout.margin.degrees);
 * ```
 */
export function createLeanLandingReadout(): LandingReadout {
  return readoutWith(null);
}

function readoutWith(ahead: LookAhead | null): LandingReadout {
  return {
    status: 'none',
    provenance: 'stale',
    age: Infinity,
    timeScale: 1,
    withdrawn: '',
    known: false,
    shipName: '',
    bodyName: '',
    descent: createDescent(),
    tilt: createTilt(),
    drift: createDrift(),
    gates: createGates(),
    margin: createTipMargin(),
    righting: createRighting(),
    touchdown: createTouchdown(),
    touchdownShown: false,
    memory: { surface: createSurface(), clock: createViewClock(), ahead },
  };
}

/**
 * Updates the readout of `view.own`'s pilot (HUD, The landing HUD). Depends on the view and on the memory in `out`, not on a
 * clock. Reuses `out` and returns it; allocates only when a simulation ahead begins.
 *
 * @example
 * ```ts
 * const readout = createLandingReadout(); // once
 * const { status, tilt } = updateLandingReadout(readout, predictor.view(now)); // each display frame
 * ```
 */
export function updateLandingReadout(out: LandingReadout, given: WorldView | null): LandingReadout {
  const view = viewOf('updateLandingReadout', out, given);
  const ship = view.ready ? view.own : null;
  const body = ship === null ? undefined : view.bodies[ship.body];
  hideParts(out);
  out.timeScale = view.timeScale;
  if (ship === null || body === undefined) {
    out.status = 'none';
    out.provenance = 'stale';
    out.withdrawn = '';
    out.shipName = '';
    out.bodyName = '';
    forgetNumbers(out);
    return out;
  }
  out.status = statusOf(ship.shownState);
  out.provenance = ship.provenance;
  out.age = ship.age;
  out.withdrawn = ship.withdrawn;
  out.shipName = ship.name;
  out.bodyName = body.name;
  const { surface, clock } = out.memory;
  measureSurface(surface, ship, body);
  if (!followView(clock, view, ship)) forgetRuns(out.memory);
  readTouchdown(out.touchdown, ship);
  if (ship.provenance === 'stale') forgetNumbers(out);
  else readNumbers(out, view, ship);
  return out;
}

/** Numbers are predicted truth (PREDICTION, "HUD numbers are predicted truth, the mesh is eased"). */
function readNumbers(out: LandingReadout, view: WorldView, ship: ShipView): void {
  const { surface, clock, ahead } = out.memory;
  out.known = true;
  measureDescent(out.descent, surface, ship);
  measureTilt(out.tilt, surface, view.settings);
  out.tilt.prominent = out.status === 'contact' || out.status === 'tipped';
  if (out.status === 'crashed') forgetDrift(out.drift);
  else measureDrift(out.drift, surface, ship.attitude);
  out.touchdownShown =
    out.touchdown.known && (out.status === 'landed' || out.status === 'tipped' || out.status === 'crashed');
  const isContact = out.status === 'contact';
  const isRighted = isContact && ahead?.followRighting(out.righting, ahead.righting, surface, ship) === true;
  if (isContact && !isRighted) {
    measureGates(out.gates, surface, view.settings);
    measureTipMargin(out.margin, surface);
    ahead?.forecastTipping(out.margin, ahead.tipping, view, clock);
  } else ahead?.forgetTipping(ahead.tipping);
  if (out.status === 'tipped') ahead?.measureRighting(out.righting, ahead.righting, surface, view, ship);
  else if (!isContact) ahead?.forgetRightingRun(ahead.righting.run);
}

/** Simulations ahead of another ship, or of this one elsewhere, no longer apply. */
function forgetRuns({ ahead }: LandingMemory): void {
  ahead?.forgetTipping(ahead.tipping);
  ahead?.forgetRightingRun(ahead.righting.run);
}

function hideParts(out: LandingReadout): void {
  out.gates.shown = false;
  out.margin.shown = false;
  out.righting.shown = false;
  out.touchdownShown = false;
}

function forgetNumbers(out: LandingReadout): void {
  out.known = false;
  forgetDescent(out.descent);
  forgetTilt(out.tilt);
  forgetDrift(out.drift);
}
