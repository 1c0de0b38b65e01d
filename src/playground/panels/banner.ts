/** One line over the picture: the state of the game, and for a few seconds the last action. */
export interface Banner {
  /** The state of the game, until changed; '' for none. */
  readonly state: (text: string) => void;
  /** The last action: disappears by itself, and the state is shown again. */
  readonly flash: (text: string) => void;
  /** Shown if there is no other message. */
  readonly rest: (text: string) => void;
}

/** ms */
const FLASH = 4000;

const withoutDigits = (text: string) => text.replaceAll(/\d/g, '');

export function createBanner(element: HTMLElement): Banner {
  let state = '';
  let flash = '';
  let rest = '';
  let timer: ReturnType<typeof setTimeout> | undefined;
  const paint = () => {
    const text = flash !== '' ? flash : state !== '' ? state : rest;
    const before = element.textContent;
    if (before === text) return;
    // A countdown is announced once, not every second.
    element.setAttribute('aria-live', withoutDigits(before) === withoutDigits(text) ? 'off' : 'polite');
    element.textContent = text;
  };
  return {
    state(text) {
      state = text;
      paint();
    },
    flash(text) {
      flash = text;
      clearTimeout(timer);
      timer = setTimeout(() => {
        flash = '';
        paint();
      }, FLASH);
      paint();
    },
    rest(text) {
      rest = text;
      paint();
    },
  };
}
