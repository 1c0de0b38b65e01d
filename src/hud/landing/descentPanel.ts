import { type Descent, DISTANCE, DURATION, SPEED, VERTICAL_SPEED } from '../../readout';
import { append, appendReading } from '../elements';
import { showAttribute, showNumber, showText } from '../shown';

/** VSPD, HSPD, TTI and AGL (HUD, the design); dashes above its ceiling of 50 km. */
export function createDescentPanel(parent: Element): (descent: Descent) => void {
  const panel = append(parent, 'div', 'td-descent');
  const paintVertical = createVerticalSpeed(appendReading(panel, 'VSPD', 'vspd'));
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

/** `↓ 12.3 m/s`, its arrow drawn by the style sheet: fonts lack it more often than letters. */
function createVerticalSpeed(parent: Element): (value: number) => void {
  const arrow = append(parent, 'span', 'td-arrow');
  const paintArrow = showText(arrow);
  const paintDirection = showAttribute(arrow, 'data-arrow');
  const paintNumber = showText(parent);
  paintDirection('none');
  let shown = Infinity;
  return (value) => {
    const key = VERTICAL_SPEED.key(value);
    if (Object.is(key, shown)) return;
    shown = key;
    const text = VERTICAL_SPEED.text(key);
    const length = key > 0 || key < 0 ? 1 : 0;
    paintArrow(text.slice(0, length));
    paintDirection(key > 0 ? 'down' : key < 0 ? 'up' : 'none');
    paintNumber(text.slice(length));
  };
}
