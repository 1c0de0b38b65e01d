import { ANGLE, DURATION, type LandingReadout, type TipMargin } from '../../readout';
import { append } from '../elements';
import { showAttribute, showNumber, showText } from '../shown';
import { createTiltGauge } from './tiltGauge';

const TRENDS = { '-1': 'coming up', '0': 'steady', '1': 'leaning over' } as const;

/** Gauge, number, trend and tip margin; the number is the largest one when in contact or tipped (HUD, Tilt). */
export function createTiltPanel(parent: Element): (readout: LandingReadout) => void {
  const panel = append(parent, 'div', 'td-tilt');
  const paintGauge = createTiltGauge(panel);
  const figures = append(panel, 'div', 'td-tilt-figures');
  append(figures, 'span', 'td-label', 'TILT');
  const paintTilt = showNumber(append(figures, 'span', 'td-tilt-value'), ANGLE);
  const trend = append(figures, 'span', 'td-trend');
  const paintTrend = showAttribute(trend, 'data-trend');
  const paintTrendText = showText(trend);
  const paintMargin = createMargin(figures);
  const paintProminent = showAttribute(panel, 'data-prominent');
  return ({ tilt, margin }) => {
    paintProminent(tilt.prominent ? 'true' : 'false');
    paintGauge(tilt);
    paintTilt(tilt.degrees);
    paintTrend(Number.isNaN(tilt.degrees) ? 'none' : String(tilt.trend));
    paintTrendText(Number.isNaN(tilt.degrees) ? '' : TRENDS[tilt.trend]);
    paintMargin(margin);
  };
}

/** `24.5° to tip`; past the point of no return the result of simulating ahead: `tips in 4.2 s`. */
function createMargin(parent: Element): (margin: TipMargin) => void {
  const line = append(parent, 'span', 'td-margin');
  const paintOutlook = showAttribute(line, 'data-outlook');
  const paintText = showText(line);
  let key = NaN;
  let kind = '';
  return (margin) => {
    const outlook = margin.shown ? margin.outlook : 'none';
    const next = outlook === 'tips' ? DURATION.key(margin.timeToTipped) : ANGLE.key(margin.degrees);
    if (outlook === kind && Object.is(next, key)) return;
    kind = outlook;
    key = next;
    paintOutlook(outlook);
    paintText(marginText(margin, outlook, next));
  };
}

function marginText(margin: TipMargin, outlook: TipMargin['outlook'] | 'none', key: number): string {
  if (outlook === 'none') return '';
  if (outlook === 'tips') return `tips in ${DURATION.text(key)}`;
  if (margin.degrees >= 0) return `${ANGLE.text(key)} to tip`;
  return outlook === 'holds' ? 'past, but held' : 'past the point of no return';
}
