/** Small pieces of DOM. Text is never parsed as markup. */

export function append<Tag extends keyof HTMLElementTagNameMap>(
  parent: Element,
  tag: Tag,
  className = '',
  text = '',
): HTMLElementTagNameMap[Tag] {
  const element = parent.ownerDocument.createElement(tag);
  if (className !== '') element.className = className;
  if (text !== '') element.textContent = text;
  parent.append(element);
  return element;
}

export function appendButton(parent: Element, text: string, onClick: () => void): HTMLButtonElement {
  const button = append(parent, 'button', '', text);
  button.type = 'button';
  button.addEventListener('click', onClick);
  return button;
}

/** A section that opens and closes. */
export function appendDetails(parent: Element, title: string, open: boolean): HTMLDetailsElement {
  const details = append(parent, 'details');
  details.open = open;
  append(details, 'summary', '', title);
  return details;
}

/** A link to the licences of the bundled libraries. */
export function appendLicences(parent: Element): void {
  const link = append(parent, 'a', '', 'Licences of the bundled libraries');
  link.href = './notices.txt';
  // In a new tab: in this one it would end the flight.
  link.target = '_blank';
}

let fields = 0;

/** A label and its control side by side; `complain` shows a fault below it, '' for none. */
export function appendField<Control extends HTMLInputElement | HTMLSelectElement>(
  parent: Element,
  title: string,
  control: Control,
): { readonly control: Control; readonly complain: (reason: string) => void } {
  const row = append(parent, 'div', 'field');
  const label = append(row, 'label', '', title);
  control.id = `field-${fields++}`;
  label.htmlFor = control.id;
  row.append(control);
  const wrong = append(row, 'p', 'wrong');
  wrong.hidden = true;
  wrong.id = `${control.id}-wrong`;
  return {
    control,
    complain(reason) {
      wrong.textContent = reason;
      wrong.hidden = reason === '';
      if (reason === '') control.removeAttribute('aria-describedby');
      else control.setAttribute('aria-describedby', wrong.id);
      control.setAttribute('aria-invalid', String(reason !== ''));
    },
  };
}

export function createSelect(
  document: Document,
  options: readonly (readonly [value: string, text: string])[],
): HTMLSelectElement {
  const select = document.createElement('select');
  for (const [value, text] of options) {
    const option = document.createElement('option');
    option.value = value;
    option.textContent = text;
    select.append(option);
  }
  return select;
}

/** A text field. Enter takes the focus from it, so that the keys fly again. */
export function createText(document: Document, placeholder: string): HTMLInputElement {
  const input = document.createElement('input');
  input.type = 'text';
  input.placeholder = placeholder;
  input.addEventListener('keydown', ({ key }) => {
    if (key === 'Enter') input.blur();
  });
  return input;
}

export function createNumber(document: Document, low: number, high: number, step: number): HTMLInputElement {
  const input = document.createElement('input');
  input.type = 'number';
  input.min = String(low);
  input.max = String(high);
  input.step = String(step);
  return input;
}
