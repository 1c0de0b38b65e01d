import { ANGLE, type Tilt } from '../../readout';
import { append, appendPicture, appendSvg } from '../elements';
import { showAttribute, showFigures } from '../shown';

/** The dial shows true angles: upright is 0°, on its side is 90°, and the needle leans as the ship does. */
const PIVOT_X = 28;
const PIVOT_Y = 100;
const RADIUS = 79;
/** Most degrees the needle can show; beyond that only the number shows the tilt. */
const DIAL_END = 96;
/** Steps of a degree in which zones and marks move: less than their lines are wide. */
const PER_DEGREE = 10;
/** Degrees between two marks below which their labels would overlap. */
const LABEL_WIDTH = 13;

/** Arc gauge of the tilt, with the settle, no-return and tipped marks (HUD, Tilt). */
export function createTiltGauge(parent: Element): (tilt: Tilt) => void {
  const gauge = append(parent, 'div', 'td-tilt-gauge');
  gauge.setAttribute('role', 'meter');
  gauge.setAttribute('aria-label', 'Tilt');
  gauge.setAttribute('aria-valuemin', '0');
  // A meter has a value before its first painting, too.
  gauge.setAttribute('aria-valuenow', '0');
  gauge.setAttribute('aria-valuemax', '180');
  const picture = appendPicture(gauge, 'td-dial', '0 -3 150 128');
  const paintScale = createScale(picture);
  const needle = createNeedle(picture);
  const paintNow = showFigures(gauge, 'aria-valuenow', 1, String);
  const paintText = showAttribute(gauge, 'aria-valuetext');
  const paintKnown = showAttribute(gauge, 'data-known');
  let shownText = Infinity;
  return (tilt) => {
    const known = !Number.isNaN(tilt.degrees);
    paintKnown(known ? 'true' : 'false');
    paintScale(tilt);
    needle(known ? Math.min(tilt.degrees, DIAL_END) : 0);
    const whole = Math.round(tilt.degrees);
    if (Object.is(whole, shownText)) return;
    shownText = whole;
    paintNow(known ? whole : 0);
    paintText(known ? `${ANGLE.text(whole * 10)} of tilt` : 'not known');
  };
}

/** The arc in four parts (settles, rocks back, topples, tipped) with marks between; without parts until a ship gives the angles. */
function createScale(picture: Element): (tilt: Tilt) => void {
  appendSvg(picture, 'path', { class: 'td-zone', d: arc(0, DIAL_END) });
  const zones = ['settled', 'leaning', 'toppling', 'tipped'].map((zone) =>
    appendSvg(picture, 'path', { class: `td-zone td-zone-${zone}` }),
  );
  const paintZones = zones.map((zone) => showFigures(zone, 'd', PER_DEGREE, arc));
  const paintSettle = createMark(picture);
  const paintNoReturn = createMark(picture);
  const paintTipped = createMark(picture);
  return ({ settle, noReturn, tipped }) => {
    if (Number.isNaN(settle)) return;
    const leaning = Math.max(settle, Math.min(noReturn, tipped));
    paintZones[0]!(0, settle);
    paintZones[1]!(settle, leaning);
    paintZones[2]!(leaning, tipped);
    paintZones[3]!(tipped, DIAL_END);
    paintSettle(settle, Math.abs(noReturn - settle) > LABEL_WIDTH);
    paintNoReturn(noReturn, Math.abs(tipped - noReturn) > LABEL_WIDTH);
    paintTipped(tipped, true);
  };
}

/** A mark and its angle; where marks are close only one is labelled. */
function createMark(picture: Element): (angle: number, isLabelled: boolean) => void {
  const line = appendSvg(picture, 'path', { class: 'td-mark' });
  const label = appendSvg(picture, 'text', { class: 'td-mark-text' });
  const paintLine = showFigures(
    line,
    'd',
    PER_DEGREE,
    (angle) => `M${point(angle, RADIUS - 8)}L${point(angle, RADIUS + 6)}`,
  );
  const paintPlace = showFigures(
    label,
    'transform',
    PER_DEGREE,
    (angle) => `translate(${point(angle, RADIUS + 15)})`,
  );
  let shown = NaN;
  return (angle, isLabelled) => {
    paintLine(angle);
    paintPlace(angle);
    const whole = isLabelled ? Math.round(angle) : -1;
    if (whole === shown) return;
    shown = whole;
    label.textContent = isLabelled ? `${String(whole)}°` : '';
  };
}

/** A lander seen from the side, its axis drawn out to the scale. */
function createNeedle(picture: Element): (angle: number) => void {
  const needle = appendSvg(picture, 'g', { class: 'td-needle' });
  appendSvg(needle, 'path', { class: 'td-needle-axis', d: `M0 -10V${String(5 - RADIUS)}` });
  appendSvg(needle, 'path', { class: 'td-needle-legs', d: 'M-6 4L-13 17M6 4L13 17M-16 17H-10M10 17H16' });
  appendSvg(needle, 'path', { class: 'td-needle-hull', d: 'M-8 9H8L10 0L6 -12H-6L-10 0Z' });
  return showFigures(
    needle,
    'transform',
    5,
    (angle) => `translate(${String(PIVOT_X)} ${String(PIVOT_Y)}) rotate(${String(angle)})`,
  );
}

function arc(from: number, to: number): string {
  return `M${point(from, RADIUS)}A${String(RADIUS)} ${String(RADIUS)} 0 0 1 ${point(to, RADIUS)}`;
}

function point(angle: number, radius: number): string {
  const radians = (angle * Math.PI) / 180;
  const x = PIVOT_X + radius * Math.sin(radians);
  const y = PIVOT_Y - radius * Math.cos(radians);
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
