import { DASHES, type Format } from '../readout';

/**
 * Painters that remember what they show and touch the DOM only where it changes; strings are built only then.
 */

/** Shows a number in a format; NaN as dashes. */
export function showNumber(parent: Element, format: Format): (value: number) => void {
  const text = parent.ownerDocument.createTextNode(DASHES);
  parent.append(text);
  let shown = NaN;
  return (value) => {
    const key = format.key(value);
    if (Object.is(key, shown)) return;
    shown = key;
    text.data = format.text(key);
  };
}

/** Shows a text. */
export function showText(parent: Element): (text: string) => void {
  const node = parent.ownerDocument.createTextNode('');
  parent.append(node);
  let shown = '';
  return (text) => {
    if (text === shown) return;
    shown = text;
    node.data = text;
  };
}

/** Shows or hides an element that is there from the start. */
export function showPart(element: HTMLElement): (visible: boolean) => void {
  element.hidden = true;
  let shown = false;
  return (visible) => {
    if (visible === shown) return;
    shown = visible;
    element.hidden = !visible;
  };
}

/** Sets an attribute that style rules or a screen reader read. */
export function showAttribute(element: Element, name: string): (value: string) => void {
  let shown: string | null = null;
  return (value) => {
    if (value === shown) return;
    shown = value;
    element.setAttribute(name, value);
  };
}

/** Sets an attribute made from numbers; `digits` decimals of each decide whether it changed. */
export function showFigures(
  element: Element,
  name: string,
  perUnit: number,
  make: (a: number, b: number) => string,
): (a: number, b?: number) => void {
  let shownA = NaN;
  let shownB = NaN;
  return (a, b = 0) => {
    const keyA = Math.round(a * perUnit);
    const keyB = Math.round(b * perUnit);
    if (Object.is(keyA, shownA) && Object.is(keyB, shownB)) return;
    shownA = keyA;
    shownB = keyB;
    element.setAttribute(name, make(keyA / perUnit, keyB / perUnit));
  };
}
