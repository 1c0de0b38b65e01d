import { ANGLE, FINE_SPEED, type Format, type Gate, type Gates, SPIN } from '../../readout';
import { append } from '../elements';
import { showAttribute, showNumber, showPart, showText } from '../shown';

/**
 * Why not landed yet: value, limit and ✓ or ✗ of the law's settle gates, while in contact (HUD).
 * On a slope also whether the ground holds the ship: it slides, or its weight is outside its feet.
 */
export function createGatesPanel(parent: Element): (gates: Gates) => void {
  const table = append(parent, 'table', 'td-gates');
  append(table, 'caption', '', 'To count as landed, meet all of these at once');
  const head = append(append(table, 'thead', 'td-unseen'), 'tr');
  for (const title of ['Gate', 'Now', 'Limit', 'Met']) append(head, 'th', '', title).scope = 'col';
  const body = append(table, 'tbody');
  const paintTilt = createGate(body, 'Tilt', ANGLE);
  const paintSpin = createGate(body, 'Spin', SPIN);
  const paintVertical = createGate(body, 'Vertical', FINE_SPEED);
  const paintHorizontal = createGate(body, 'Horizontal', FINE_SPEED);
  const slope = createSlopeGate(body, 'Slope', 'it slides');
  const balance = createSlopeGate(body, 'Lean', 'it topples');
  const paintShown = showPart(table);
  return (gates) => {
    paintShown(gates.shown);
    if (!gates.shown) return;
    paintTilt(gates.tilt);
    paintSpin(gates.spin);
    paintVertical(gates.vertical);
    paintHorizontal(gates.horizontal);
    slope(gates.onSlope, gates.slope);
    balance(gates.onSlope, gates.balance);
  };
}

/** A gate that is shown only on a slope, with the consequence of missing it: "38.9° of 38.7°: it slides". */
function createSlopeGate(body: Element, label: string, miss: string): (shown: boolean, gate: Gate) => void {
  const paintGate = createGate(body, label, ANGLE, miss);
  const paintShown = showPart(body.lastElementChild as HTMLElement);
  return (shown, gate) => {
    paintShown(shown);
    if (shown) paintGate(gate);
  };
}

function createGate(body: Element, label: string, format: Format, miss = ''): (gate: Gate) => void {
  const row = append(body, 'tr');
  append(row, 'th', '', label).scope = 'row';
  const paintValue = showNumber(append(row, 'td', 'td-now'), format);
  const paintLimit = showNumber(append(row, 'td', 'td-limit'), format);
  const met = append(row, 'td', 'td-met');
  const mark = append(met, 'span', 'td-tick');
  mark.setAttribute('role', 'img');
  const paintMark = showText(mark);
  const paintLabel = showAttribute(mark, 'aria-label');
  const paintMet = showAttribute(row, 'data-met');
  return (gate) => {
    paintValue(gate.value);
    paintLimit(gate.limit);
    paintMark(gate.met ? '✓' : miss === '' ? '✗' : `✗ ${miss}`);
    paintLabel(gate.met ? 'met' : miss === '' ? 'not met' : `not met: ${miss}`);
    paintMet(gate.met ? 'true' : 'false');
  };
}
