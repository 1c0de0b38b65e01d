import { type Drift, SPEED, type Tilt } from '../../readout';
import { append, appendPicture, appendSvg } from '../elements';
import { showAttribute, showFigures, showText } from '../shown';

/** Radius of full deflection in the picture's units. */
const RADIUS = 50;

/** Horizontal velocity in ship axes, +Y up and +X right, with its scale; on the rim the side that leans (HUD). */
export function createCrossPointer(parent: Element): (drift: Drift, tilt: Tilt) => void {
  const gauge = append(parent, 'div', 'td-drift');
  gauge.setAttribute('role', 'meter');
  gauge.setAttribute('aria-label', 'Drift along the ground');
  gauge.setAttribute('aria-valuemin', '0');
  // A meter has a value before its first painting, too.
  gauge.setAttribute('aria-valuenow', '0');
  const picture = appendPicture(gauge, 'td-dial', '-66 -69 132 138');
  paintDial(picture);
  const moving = appendSvg(picture, 'g', { class: 'td-cross' });
  const paintAcross = showFigures(appendSvg(moving, 'path'), 'd', 2, (x) => `M${String(x)} -50V50`);
  const paintAlong = showFigures(appendSvg(moving, 'path'), 'd', 2, (y) => `M-50 ${String(y)}H50`);
  const paintWay = showFigures(
    appendSvg(moving, 'path', { class: 'td-cross-way' }),
    'd',
    2,
    (x, y) => `M0 0L${String(x)} ${String(y)}`,
  );
  const dot = appendSvg(moving, 'circle', { class: 'td-cross-dot', r: 4 });
  const paintDot = showFigures(dot, 'transform', 2, (x, y) => `translate(${String(x)} ${String(y)})`);
  const paintLean = createLean(picture);
  const paintScale = createScale(gauge);
  const paintWords = createValueText(gauge);
  const paintKnown = showAttribute(gauge, 'data-known');
  return (drift, tilt) => {
    const known = !Number.isNaN(drift.x);
    paintKnown(known ? 'true' : 'false');
    const x = known ? clamp((drift.x / drift.scale) * RADIUS) : 0;
    const y = known ? clamp((-drift.y / drift.scale) * RADIUS) : 0;
    paintAcross(x);
    paintAlong(y);
    paintWay(x, y);
    paintDot(x, y);
    paintLean(tilt);
    paintScale(drift.scale);
    paintWords(drift);
  };
}

function paintDial(picture: Element): void {
  appendSvg(picture, 'circle', { class: 'td-rim', r: RADIUS });
  appendSvg(picture, 'circle', { class: 'td-ring', r: RADIUS / 2 });
  appendSvg(picture, 'path', { class: 'td-axes', d: 'M-50 0H50M0 -50V50' });
}

/** A wedge on the rim at the ship's lowest side; it hides the letter of an axis behind it. */
function createLean(picture: Element): (tilt: Tilt) => void {
  const paintX = createLetter(picture, 'X', 58, 4);
  const paintY = createLetter(picture, 'Y', 0, -55);
  const wedge = appendSvg(picture, 'path', { class: 'td-lean', d: 'M0 -48L7 -60H-7Z' });
  const paint = showFigures(wedge, 'transform', 1, (degrees) => `rotate(${String(degrees)})`);
  const paintShown = showAttribute(wedge, 'data-shown');
  return ({ leanX, leanY }) => {
    const leans = leanX !== 0 || leanY !== 0;
    paintShown(leans ? 'true' : 'false');
    paintX(leanX > COVERED ? 'true' : 'false');
    paintY(leanY > COVERED ? 'true' : 'false');
    if (leans) paint((Math.atan2(leanX, leanY) * 180) / Math.PI);
  };
}

/** Cosine of 20°: closer than this the wedge covers the letter. */
const COVERED = 0.94;

function createLetter(picture: Element, text: string, x: number, y: number): (covered: string) => void {
  const letter = appendSvg(picture, 'text', { class: 'td-axis-text', x, y });
  letter.textContent = text;
  return showAttribute(letter, 'data-covered');
}

function createScale(gauge: HTMLElement): (scale: number) => void {
  const paint = showText(append(gauge, 'span', 'td-scale'));
  let shown = NaN;
  return (scale) => {
    if (scale === shown) return;
    shown = scale;
    paint(`±${String(scale)} m/s`);
    gauge.setAttribute('aria-valuemax', String(scale));
  };
}

/** The dial in words, in whole metres per second: a screen reader would read every change of a decimal. */
function createValueText(gauge: Element): (drift: Drift) => void {
  const paintText = showAttribute(gauge, 'aria-valuetext');
  const paintNow = showAttribute(gauge, 'aria-valuenow');
  let shownX = Infinity;
  let shownY = Infinity;
  return ({ x, y }) => {
    const keyX = Math.round(x) + 0;
    const keyY = Math.round(y) + 0;
    if (Object.is(keyX, shownX) && Object.is(keyY, shownY)) return;
    shownX = keyX;
    shownY = keyY;
    const known = !Number.isNaN(keyX);
    const speed = known ? Math.sqrt(keyX * keyX + keyY * keyY) : 0;
    paintNow(String(Math.round(speed)));
    const along = (key: number) => SPEED.text(key * 10);
    paintText(known ? `${along(keyX)} along X, ${along(keyY)} along Y` : 'not known');
  };
}

function clamp(value: number): number {
  return Math.max(-RADIUS, Math.min(RADIUS, value));
}
