import { type LoadedShipClass, loadShipClass, SHIP_CLASSES, type ShipClass } from '../../../dynamics';
import type { Warn } from '../../warnings';
import { warnOfUnknown } from '../names';

/** m/s² at full mass: less than the first lifts off nowhere, more than the second kills the pilot. */
const MIN_ACCELERATION = 0.05;
const MAX_ACCELERATION = 2_000;

/** Warns of unknown members of ship classes, and of kN or tonnes. */
export function checkClasses(warn: Warn, path: string, classes: readonly unknown[]): void {
  for (const [i, given] of classes.entries()) {
    if (typeof given !== 'object' || given === null) continue;
    warnOfUnknown(warn, { code: 'unknown-class-field', path: `${path}[${i}]`, known: known() }, given);
    checkThrust(warn, given as ShipClass);
  }
}

/** A loaded class has its derived constants too. */
function known(): readonly string[] {
  const loaded = loadShipClass(SHIP_CLASSES[0]!);
  return Object.keys(loaded.ok ? (loaded.value satisfies LoadedShipClass) : SHIP_CLASSES[0]!);
}

function checkThrust(warn: Warn, { name, mainEngineThrust, dryMass, fuelCapacity }: ShipClass): void {
  const acceleration = mainEngineThrust / (dryMass + fuelCapacity);
  const isPlausible = acceleration >= MIN_ACCELERATION && acceleration <= MAX_ACCELERATION;
  if (isPlausible || mainEngineThrust === 0 || Number.isNaN(acceleration)) return;
  const message = `Ship class ${name} accelerates by ${acceleration} m/s²: thrust in N (not kN), masses in kg (not t)?`;
  warn('class-units', message, { name, mainEngineThrust, dryMass, fuelCapacity });
}
