import type { AttitudeMode } from '../../dynamics';
import type { ShipView, WorldView } from '../../prediction';
import { cross, toInertial, writeDot } from '../axes';
import { createSurface, measureSurface, type Surface } from '../surface';
import { viewOf } from '../arguments';

/** Flight instruments: engine, fuel, attitude control, heading. SI units, degrees where said; NaN where not known. */
export interface FlightReadout {
  known: boolean;
  /** 0 … 1. */
  throttle: number;
  /** Throttle at which an upright ship hovers; above 1 the engine cannot, NaN without an engine. */
  hover: number;
  /** kg, and of the capacity 0 … 1. */
  fuel: number;
  fuelShare: number;
  /** Game s until the tank is empty at this throttle; NaN with the engine off. */
  burnSeconds: number;
  /** m/s left in the main engine. */
  deltaV: number;
  /** The game's attitude_hold. */
  damping: boolean;
  mode: AttitudeMode;
  /** Degrees from north to east: where the ship's +Y points along the ground; NaN when that axis is vertical. */
  heading: number;
  /** Degrees of the thrust axis over the horizon: 90 upright, −90 upside down. */
  pitch: number;
  /** Degrees from upright towards the ship's +X and +Y: the position of the attitude ball's zenith. */
  leanX: number;
  leanY: number;
  /** Momentum of the reaction wheels as a share of their capacity, −1 … 1 about x, y, z; NaN where the class has no limit. */
  readonly wheels: Float64Array;
  /** Kept from view to view; not shown. @internal */
  readonly memory: Surface;
}

/**
 * An empty readout of the instruments, filled by updateFlightReadout.
 *
 * @example
 * ```ts
 * const readout = updateFlightReadout(createFlightReadout(), predictor.view(now));
 * console.log(readout.deltaV); // m/s
 * ```
 */
export function createFlightReadout(): FlightReadout {
  return {
    known: false,
    throttle: NaN,
    hover: NaN,
    fuel: NaN,
    fuelShare: NaN,
    burnSeconds: NaN,
    deltaV: NaN,
    damping: false,
    mode: 'none',
    heading: NaN,
    pitch: NaN,
    leanX: 0,
    leanY: 0,
    wheels: Float64Array.of(NaN, NaN, NaN),
    memory: createSurface(),
  };
}

/**
 * Fills `out` with the instruments' present values and returns it; allocates nothing. A ship that is gone has no numbers.
 *
 * @example
 * ```ts
 * const readout = createFlightReadout(); // once
 * const { fuel, heading } = updateFlightReadout(readout, predictor.view(now)); // kg, degrees
 * ```
 */
export function updateFlightReadout(out: FlightReadout, given: WorldView | null): FlightReadout {
  const view = viewOf('updateFlightReadout', out, given);
  const ship = view.ready ? view.own : null;
  const body = ship === null ? undefined : view.bodies[ship.body];
  if (ship === null || body === undefined || ship.shownState === 'crashed' || ship.provenance === 'stale') {
    forget(out);
    return out;
  }
  out.known = true;
  measureSurface(out.memory, ship, body);
  measureEngine(out, ship);
  measureAttitude(out, ship, body.angularVelocity);
  return out;
}

function measureEngine(out: FlightReadout, ship: ShipView): void {
  const { shipClass, controls, fuel } = ship;
  const { mass, weight } = out.memory;
  out.throttle = controls.thrustLevel;
  out.hover = shipClass.mainEngineThrust > 0 ? weight / shipClass.mainEngineThrust : NaN;
  out.fuel = fuel;
  out.fuelShare = shipClass.fuelCapacity > 0 ? fuel / shipClass.fuelCapacity : NaN;
  const flow = controls.thrustLevel * shipClass.mainEngineThrust * shipClass.mainEngineFlow;
  out.burnSeconds = flow > 0 ? fuel / flow : NaN;
  out.deltaV =
    shipClass.mainEngineFlow > 0 ? Math.log(mass / shipClass.dryMass) / shipClass.mainEngineFlow : NaN;
  const { reactionWheelCapacity: capacity } = shipClass;
  for (let k = 0; k < 3; k++)
    out.wheels[k] = capacity === null || capacity[k] === 0 ? NaN : ship.wheelMomentum[k]! / capacity[k]!;
  out.damping = controls.attitudeHold;
  out.mode = controls.attitudeMode;
}

const SHIP_Y = Float64Array.of(0, 1, 0);
const forward = new Float64Array(3);
const pole = new Float64Array(3);
const east = new Float64Array(3);
const north = new Float64Array(3);
const product = new Float64Array(2);
const DEGREES = 180 / Math.PI;
/** Level part of the ship's y axis below which it points straight up or down, and its heading is rounding error. */
const MIN_LEVEL = 1e-3;

/** @param spin of the body, ICRF: north is where its axis points */
function measureAttitude(out: FlightReadout, ship: ShipView, spin: readonly number[]): void {
  const { normal, normalInShip, lean } = out.memory;
  out.pitch = 90 - lean * DEGREES;
  const level = Math.sqrt(normalInShip[0]! ** 2 + normalInShip[1]! ** 2);
  out.leanX = level > 0 ? (-normalInShip[0]! / level) * lean * DEGREES : 0;
  out.leanY = level > 0 ? (-normalInShip[1]! / level) * lean * DEGREES : 0;
  for (let k = 0; k < 3; k++) pole[k] = spin[k]!;
  cross(east, pole, normal);
  writeDot(product, 0, east, east);
  const length = Math.sqrt(product[0]!);
  if (length === 0) {
    out.heading = NaN;
    return;
  }
  for (let k = 0; k < 3; k++) east[k] = east[k]! / length;
  cross(north, normal, east);
  toInertial(forward, ship.attitude, SHIP_Y);
  writeDot(product, 0, forward, east);
  writeDot(product, 1, forward, north);
  const along = Math.sqrt(product[0]! ** 2 + product[1]! ** 2);
  const degrees = Math.atan2(product[0]!, product[1]!) * DEGREES;
  out.heading = along < MIN_LEVEL ? NaN : degrees < 0 ? degrees + 360 : degrees;
}

function forget(out: FlightReadout): void {
  out.known = false;
  out.throttle = NaN;
  out.hover = NaN;
  out.fuel = NaN;
  out.fuelShare = NaN;
  out.burnSeconds = NaN;
  out.deltaV = NaN;
  out.wheels.fill(NaN);
  out.heading = NaN;
  out.pitch = NaN;
  out.leanX = 0;
  out.leanY = 0;
}
