import { append, appendButton } from './elements';

/** Messages that stay until they are closed or no longer true, one below the other. */
export interface Notice {
  /** A fault, with advice. */
  readonly show: (text: string) => void;
  /** An invitation. */
  readonly tell: (text: string) => void;
  readonly clear: () => void;
  /** Removes a message that is no longer true; the others stay. */
  readonly withdraw: (text: string) => void;
  /** An address to copy by hand. */
  readonly showLink: (text: string, link: string) => void;
}

/** Most messages: more would cover the picture, so the oldest is removed. */
const MAX_NOTICES = 3;

export function createNotice(element: HTMLElement): Notice {
  const notices = new Map<string, HTMLElement>();
  const withdraw = (text: string) => {
    notices.get(text)?.remove();
    notices.delete(text);
    element.hidden = notices.size === 0;
  };
  const add = (text: string, kind = ''): HTMLElement => {
    withdraw(text);
    const row = append(element, 'div', `notice-row ${kind}`);
    append(row, 'span', '', text);
    notices.set(text, row);
    const [oldest] = notices.keys();
    if (notices.size > MAX_NOTICES && oldest !== undefined) withdraw(oldest);
    element.hidden = false;
    return row;
  };
  const close = (row: HTMLElement, text: string) => {
    row.append(' ');
    appendButton(row, 'Close', () => withdraw(text));
  };
  return {
    show(text) {
      if (!notices.has(text)) close(add(text, 'fault'), text);
    },
    tell(text) {
      close(add(text), text);
    },
    showLink(text, link) {
      const row = add(text);
      const field = append(row, 'input', 'notice-link');
      field.type = 'text';
      field.readOnly = true;
      field.value = link;
      field.setAttribute('aria-label', 'Link');
      close(row, text);
      field.focus();
      field.select();
    },
    clear() {
      for (const text of [...notices.keys()]) withdraw(text);
    },
    withdraw,
  };
}
