import { append, appendButton } from './elements';

/** One place for what went wrong and what to do about it; stays until closed or replaced. */
export interface Notice {
  readonly tell: (text: string) => void;
  readonly clear: () => void;
  /** What this text said holds no longer; another's stays. */
  readonly withdraw: (text: string) => void;
}

export function createNotice(element: HTMLElement): Notice {
  const words = append(element, 'span');
  const clear = () => {
    element.hidden = true;
    words.textContent = '';
  };
  element.append(' ');
  appendButton(element, 'Close', clear);
  return {
    tell(text) {
      if (!element.hidden && words.textContent === text) return;
      words.textContent = text;
      element.hidden = false;
    },
    clear,
    withdraw(text) {
      if (words.textContent === text) clear();
    },
  };
}
