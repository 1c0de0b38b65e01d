import { DISTANCE, type TargetReadout } from '../../readout';
import { append, appendPicture, appendSvg } from '../elements';
import { showAttribute, showFigures, showNumber, showPart, showText } from '../shown';

const RADIUS = 40;
/** Seconds of drift that the arrow shows. */
const AHEAD = 5;

/** The glide cross: the ship in the middle, the pad's ring, and a cross where the ship will touch; right and away as on the screen. */
export function createApproachDial(parent: Element): (target: TargetReadout, aidsOn: boolean) => void {
  const gauge = append(parent, 'div', 'td-approach');
  gauge.setAttribute('role', 'meter');
  gauge.setAttribute('aria-label', 'Distance to the beacon');
  gauge.setAttribute('aria-valuemin', '0');
  const picture = appendPicture(gauge, 'td-approach-picture', '-46 -46 92 92');
  appendSvg(picture, 'circle', { class: 'td-rim', r: RADIUS });
  appendSvg(picture, 'path', { class: 'td-axes', d: 'M-40 0H40M0 -40V40' });
  const pad = appendSvg(picture, 'circle', { class: 'td-pad', r: 5 });
  const paintPadX = showFigures(pad, 'cx', 2, String);
  const paintPadY = showFigures(pad, 'cy', 2, String);
  const paintPadR = showFigures(pad, 'r', 2, String);
  const drift = appendSvg(picture, 'path', { class: 'td-drift-way' });
  const paintDrift = showFigures(drift, 'd', 1, (x, y) => `M0 0L${String(x)} ${String(y)}`);
  const cross = appendSvg(picture, 'path', { class: 'td-touch-cross', d: 'M-5 -5L5 5M-5 5L5 -5' });
  const paintCross = showFigures(cross, 'transform', 2, (x, y) => `translate(${String(x)} ${String(y)})`);
  const paintCrossShown = showAttribute(cross, 'data-shown');
  const words = append(gauge, 'div', 'td-approach-words');
  append(words, 'span', 'td-label', 'BEACON');
  const paintDistance = showNumber(append(words, 'span', 'td-value'), DISTANCE);
  const paintWay = showText(append(words, 'span', 'td-way'));
  const paintShown = showPart(gauge);
  const paintText = showAttribute(gauge, 'aria-valuetext');
  const paintNow = showAttribute(gauge, 'aria-valuenow');
  const paintMax = showAttribute(gauge, 'aria-valuemax');
  let shownKey = NaN;
  let shownWay = '';
  return (target, aidsOn) => {
    paintShown(target.shown);
    if (!target.shown) return;
    const per = RADIUS / target.scale;
    paintPadX(bounded(target.x * per));
    paintPadY(bounded(-target.y * per));
    paintPadR(Math.max(3, Math.min(RADIUS, target.radius * per)));
    paintDrift(bounded(target.driftX * AHEAD * per), bounded(-target.driftY * AHEAD * per));
    const known = aidsOn && !Number.isNaN(target.missX);
    paintCrossShown(known ? 'true' : 'false');
    if (known)
      paintCross(bounded((target.x + target.missX) * per), bounded(-(target.y + target.missY) * per));
    paintDistance(target.distance);
    const way = directionText(target);
    paintWay(way);
    const key = DISTANCE.key(target.distance);
    if (Object.is(key, shownKey) && way === shownWay) return;
    shownKey = key;
    shownWay = way;
    paintText(`${DISTANCE.text(key)}, ${way}`);
    paintNow(String(Math.round(target.distance)));
    paintMax(String(Math.max(target.scale, Math.round(target.distance))));
  };
}

/** Share of the distance below which a component is not named: directions within 24° of an axis are along it. */
const UNNAMED = 0.4;

/** The direction of the pad in words, for readers who cannot see the dial. */
function directionText({ x, y, distance, radius }: TargetReadout): string {
  if (distance <= radius) return 'below you';
  const enough = UNNAMED * distance;
  const along = y > enough ? 'ahead' : y < -enough ? 'behind' : '';
  const across = x > enough ? 'right' : x < -enough ? 'left' : '';
  return [along, across].filter((word) => word !== '').join(' ');
}

function bounded(value: number): number {
  return Math.max(-RADIUS, Math.min(RADIUS, value));
}
