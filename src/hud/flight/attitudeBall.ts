import { ANGLE, BEARING, type FlightReadout, PERCENT } from '../../readout';
import { append, appendPicture, appendSvg } from '../elements';
import { showAttribute, showFigures, showNumber, showPart } from '../shown';

/** Radius of the ball, and picture units a degree of lean. */
const RADIUS = 40;
const PER_DEGREE = RADIUS / 90;

/**
 * The attitude ball, seen along the thrust axis from behind: the zenith mark is in the middle when the ship is upright, and moves
 * away from the side that leans down. Beside it heading, pitch and the fullest reaction wheel.
 */
export function createAttitudeBall(parent: Element): (flight: FlightReadout) => void {
  const panel = append(parent, 'div', 'td-attitude');
  const picture = appendPicture(panel, 'td-ball', '-46 -46 92 92');
  appendSvg(picture, 'circle', { class: 'td-rim', r: RADIUS });
  appendSvg(picture, 'circle', { class: 'td-ring', r: 15 * PER_DEGREE });
  appendSvg(picture, 'circle', { class: 'td-ring', r: 45 * PER_DEGREE });
  appendSvg(picture, 'path', { class: 'td-axes', d: 'M-40 0H-6M6 0H40M0 -40V-6M0 6V40' });
  const zenith = appendSvg(picture, 'path', { class: 'td-zenith', d: 'M0 -7L7 0L0 7L-7 0Z' });
  const paintZenith = showFigures(zenith, 'transform', 2, (x, y) => `translate(${String(x)} ${String(y)})`);
  const paintKnown = showAttribute(picture, 'data-known');
  const words = append(panel, 'div', 'td-attitude-words');
  append(words, 'span', 'td-label', 'HDG');
  const paintHeading = showNumber(append(words, 'span', 'td-value'), BEARING);
  append(words, 'span', 'td-label', 'PITCH');
  const paintPitch = showNumber(append(words, 'span', 'td-value'), ANGLE);
  const wheelLabel = append(words, 'span', 'td-label', 'WHEELS');
  const wheels = append(words, 'span', 'td-value');
  const paintWheels = showNumber(wheels, PERCENT);
  const paintWheelLabelShown = showPart(wheelLabel);
  const paintWheelsShown = showPart(wheels);
  return (flight) => {
    paintKnown(flight.known ? 'true' : 'false');
    paintZenith(-flight.leanX * PER_DEGREE, flight.leanY * PER_DEGREE);
    paintHeading(flight.heading);
    paintPitch(flight.pitch);
    let fullest = NaN;
    for (let k = 0; k < 3; k++) {
      const share = Math.abs(flight.wheels[k]!);
      if (!(fullest >= share)) fullest = share;
    }
    paintWheelLabelShown(!Number.isNaN(fullest));
    paintWheelsShown(!Number.isNaN(fullest));
    paintWheels(fullest);
  };
}
