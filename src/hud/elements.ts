/** Building blocks of the DOM. Text is never parsed as markup. */

const SVG = 'http://www.w3.org/2000/svg';

export function append<K extends keyof HTMLElementTagNameMap>(
  parent: Element,
  tag: K,
  className = '',
  text = '',
): HTMLElementTagNameMap[K] {
  const element = parent.ownerDocument.createElement(tag);
  if (className !== '') element.className = className;
  if (text !== '') element.textContent = text;
  parent.append(element);
  return element;
}

export function appendSvg<K extends keyof SVGElementTagNameMap>(
  parent: Element,
  tag: K,
  attributes: Readonly<Record<string, string | number>> = {},
): SVGElementTagNameMap[K] {
  const element = parent.ownerDocument.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  parent.append(element);
  return element;
}

/** A picture that a text beside it, or its parent's aria-valuetext, describes. */
export function appendPicture(parent: Element, className: string, viewBox: string): SVGSVGElement {
  return appendSvg(parent, 'svg', { class: className, viewBox, 'aria-hidden': 'true', focusable: 'false' });
}

/** A label over a value, as on an instrument. */
export function appendReading(parent: Element, label: string, name: string): HTMLElement {
  const reading = append(parent, 'div', `td-reading td-reading-${name}`);
  append(reading, 'span', 'td-label', label);
  return append(reading, 'span', 'td-value');
}
