import { type Descent, DISTANCE, DURATION, SPEED, VERTICAL_SPEED } from '../readout';
import { append, appendReading } from './elements';
import { showAttribute, showNumber } from './shown';

/** VSPD, HSPD, TTI and AGL (HUD, the design); dashes above its ceiling of 50 km. */
export function createDescentPanel(parent: Element): (descent: Descent) => void {
  const panel = append(parent, 'div', 'hud-descent');
  const paintVertical = showNumber(appendReading(panel, 'VSPD', 'vspd'), VERTICAL_SPEED);
  const paintHorizontal = showNumber(appendReading(panel, 'HSPD', 'hspd'), SPEED);
  const paintTime = showNumber(appendReading(panel, 'TTI', 'tti'), DURATION);
  const paintHeight = showNumber(appendReading(panel, 'AGL', 'agl'), DISTANCE);
  const paintShown = showAttribute(panel, 'data-shown');
  return (descent) => {
    paintShown(descent.shown ? 'true' : 'false');
    paintVertical(descent.shown ? descent.verticalSpeed : NaN);
    paintHorizontal(descent.shown ? descent.horizontalSpeed : NaN);
    paintTime(descent.shown ? descent.timeToImpact : NaN);
    paintHeight(descent.shown ? descent.feetHeight : NaN);
  };
}
