import { ANGLE, FINE_SPEED, type Format, type Gate, type Gates, SPIN } from '../readout';
import { append } from './elements';
import { showAttribute, showNumber, showPart, showText } from './shown';

/** Why not landed yet: value, limit and ✓ or ✗ of the law's four settle gates, while in contact (HUD). */
export function createGatesPanel(parent: Element): (gates: Gates) => void {
  const table = append(parent, 'table', 'td-gates');
  append(table, 'caption', '', 'To count as landed, meet all four at once');
  const head = append(append(table, 'thead', 'td-unseen'), 'tr');
  for (const title of ['Gate', 'Now', 'Limit', 'Met']) append(head, 'th', '', title).scope = 'col';
  const body = append(table, 'tbody');
  const paintTilt = createGate(body, 'Tilt', ANGLE);
  const paintSpin = createGate(body, 'Spin', SPIN);
  const paintVertical = createGate(body, 'Vertical', FINE_SPEED);
  const paintHorizontal = createGate(body, 'Horizontal', FINE_SPEED);
  const paintShown = showPart(table);
  return (gates) => {
    paintShown(gates.shown);
    if (!gates.shown) return;
    paintTilt(gates.tilt);
    paintSpin(gates.spin);
    paintVertical(gates.vertical);
    paintHorizontal(gates.horizontal);
  };
}

function createGate(body: Element, label: string, format: Format): (gate: Gate) => void {
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
    paintMark(gate.met ? '✓' : '✗');
    paintLabel(gate.met ? 'met' : 'not met');
    paintMet(gate.met ? 'true' : 'false');
  };
}
