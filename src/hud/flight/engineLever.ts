import { type FlightReadout, PERCENT } from '../../readout';
import { append, appendPicture, appendSvg } from '../elements';
import { showAttribute, showFigures, showNumber } from '../shown';

/** Height of the lever's travel in the picture's units. */
const WAY = 100;

/** The throttle as a lever that reads at a glance; a mark shows the throttle that hovers. */
export function createEngineLever(parent: Element): (flight: FlightReadout) => void {
  const panel = append(parent, 'div', 'td-engine');
  const gauge = append(panel, 'div', 'td-lever');
  gauge.setAttribute('role', 'meter');
  gauge.setAttribute('aria-label', 'Throttle');
  gauge.setAttribute('aria-valuemin', '0');
  // A meter has a value before its first painting, too.
  gauge.setAttribute('aria-valuenow', '0');
  gauge.setAttribute('aria-valuemax', '100');
  const picture = appendPicture(gauge, 'td-lever-picture', '-4 -6 46 112');
  appendSvg(picture, 'rect', { class: 'td-lever-way', x: 0, y: 0, width: 18, height: WAY });
  const fill = appendSvg(picture, 'path', { class: 'td-lever-fill' });
  const paintFill = showFigures(fill, 'd', 1, (y) => `M0 ${String(y)}H18V${String(WAY)}H0Z`);
  const mark = appendSvg(picture, 'g', { class: 'td-lever-hover' });
  appendSvg(mark, 'path', { d: 'M-2 0H22L30 -6V6L22 0' });
  const paintMark = showFigures(mark, 'transform', 1, (y) => `translate(0 ${String(y)})`);
  const paintMarkShown = showAttribute(mark, 'data-shown');
  const words = append(panel, 'div', 'td-lever-words');
  append(words, 'span', 'td-label', 'ENGINE');
  const paintThrottle = showNumber(append(words, 'span', 'td-value'), PERCENT);
  append(words, 'span', 'td-label', 'HOVER');
  const paintHover = showNumber(append(words, 'span', 'td-hover'), PERCENT);
  const paintNow = showAttribute(gauge, 'aria-valuenow');
  const paintText = showAttribute(gauge, 'aria-valuetext');
  let shown = Infinity;
  return ({ throttle, hover }) => {
    const share = Number.isNaN(throttle) ? 0 : throttle;
    paintFill(WAY * (1 - share));
    paintMarkShown(hover <= 1 ? 'true' : 'false');
    paintMark(WAY * (1 - (hover <= 1 ? hover : 0)));
    paintThrottle(throttle);
    paintHover(hover);
    const key = PERCENT.key(throttle);
    if (Object.is(key, shown)) return;
    shown = key;
    paintNow(String(Number.isNaN(key) ? 0 : key));
    paintText(PERCENT.text(key));
  };
}
