import { DELTA_V, DURATION, type FlightReadout, MASS, PERCENT } from '../../readout';
import { append, appendReading } from '../elements';
import { showAttribute, showNumber } from '../shown';

/** Share of the tank below which it is amber. */
const LOW = 0.05;

/** Fuel in kg, per cent and seconds at this throttle; Δv left. */
export function createFuelPanel(parent: Element): (flight: FlightReadout) => void {
  const panel = append(parent, 'div', 'td-fuel');
  const paintMass = showNumber(appendReading(panel, 'FUEL', 'fuel'), MASS);
  const paintShare = showNumber(appendReading(panel, 'OF TANK', 'tank'), PERCENT);
  const paintSeconds = showNumber(appendReading(panel, 'LASTS', 'burn'), DURATION);
  const paintDeltaV = showNumber(appendReading(panel, 'Δv', 'deltav'), DELTA_V);
  const paintLow = showAttribute(panel, 'data-low');
  return ({ fuel, fuelShare, burnSeconds, deltaV }) => {
    paintMass(fuel);
    paintShare(fuelShare);
    paintSeconds(burnSeconds);
    paintDeltaV(deltaV);
    paintLow(fuelShare < LOW ? 'true' : 'false');
  };
}
