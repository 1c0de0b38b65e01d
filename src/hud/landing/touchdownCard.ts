import { ANGLE, COUNT, DISTANCE, DURATION, type Format, type LandingReadout, SPEED } from '../../readout';
import { append } from '../elements';
import { showNumber, showPart } from '../shown';

/** How the touchdown went, once the ship has landed or tipped (HUD, touchdown card). */
export function createTouchdownCard(parent: Element): (readout: LandingReadout) => void {
  const part = append(parent, 'div', 'td-touchdown');
  append(part, 'p', 'td-label', 'TOUCHDOWN');
  const card = append(part, 'dl', 'td-card');
  const paintVertical = createEntry(card, 'Vertical', SPEED);
  const paintHorizontal = createEntry(card, 'Horizontal', SPEED);
  const paintBounces = createEntry(card, 'Bounces', COUNT);
  const paintSlide = createEntry(card, 'Slide', DISTANCE);
  const paintSettle = createEntry(card, 'To rest', DURATION);
  const paintTilt = createEntry(card, 'Largest tilt', ANGLE);
  const paintShown = showPart(part);
  return ({ touchdown, touchdownShown }) => {
    paintShown(touchdownShown);
    if (!touchdownShown) return;
    paintVertical(touchdown.verticalSpeed);
    paintHorizontal(touchdown.horizontalSpeed);
    paintBounces(touchdown.bounces);
    paintSlide(touchdown.slideMetres);
    paintSettle(touchdown.settleSeconds);
    paintTilt(touchdown.largestTilt);
  };
}

function createEntry(card: Element, label: string, format: Format): (value: number) => void {
  const entry = append(card, 'div');
  append(entry, 'dt', '', label);
  return showNumber(append(entry, 'dd'), format);
}
