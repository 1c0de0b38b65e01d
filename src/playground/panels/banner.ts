/** One line over the picture: how the game stands, and for a few seconds what was just done. */
export interface Banner {
  /** How the game stands, until told otherwise; '' is nothing to say. */
  readonly state: (text: string) => void;
  /** What was done: goes by itself, and the state comes back. */
  readonly flash: (text: string) => void;
  /** Said while nothing else is. */
  readonly rest: (text: string) => void;
}

/** ms */
const FLASH = 4000;

export function createBanner(element: HTMLElement): Banner {
  let state = '';
  let flash = '';
  let rest = '';
  let timer: ReturnType<typeof setTimeout> | undefined;
  const paint = () => {
    const text = flash !== '' ? flash : state !== '' ? state : rest;
    if (element.textContent !== text) element.textContent = text;
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
