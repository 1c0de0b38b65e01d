/**
 * A newcomer who goes by the texts on the screen alone: finds the controls in the goal's sentence, follows the words beside it, and
 * looks no more often than people do. Only text inside the window counts, and nothing is scrolled.
 */
import type { Page } from 'playwright-core';

/** ms between two looks at the screen: people are not faster. */
const REACTION = 500;

/** The texts on the screen at one look. */
interface Screen {
  /** Text of the goal over the picture. */
  readonly goal: string;
  /** The large word of the status slot. */
  readonly status: string;
  /** The card's text; '' while there is none. */
  readonly card: string;
}

/** How the newcomer moves the controls that the goal names. */
interface Controls {
  more(): Promise<void>;
  less(): Promise<void>;
  cut(): Promise<void>;
  /** Hands off. */
  rest(): Promise<void>;
}

function look(page: Page): Promise<Screen> {
  return page.evaluate(() => {
    const read = (selector: string) => {
      const element = document.querySelector<HTMLElement>(selector);
      if (element?.checkVisibility() !== true) return '';
      const { top, bottom, left, right } = element.getBoundingClientRect();
      const isInside = top >= 0 && left >= 0 && bottom <= innerHeight && right <= innerWidth;
      return isInside ? element.innerText.replace(/\s+/g, ' ') : '';
    };
    return { goal: read('#goal'), status: read('.td-landing .td-status'), card: read('#card') };
  });
}

/** The keys that the goal names. */
function keysOf(page: Page, goal: string): Controls {
  const named = (pattern: RegExp) => {
    const key = pattern.exec(goal)?.[1];
    if (key === undefined) throw new Error(`the goal names no key for ${pattern.source}: ${goal}`);
    return key.toLowerCase();
  };
  const [more, less, cut] = [/(\w+) more thrust/, /(\w+) less,/, /(\w+) cut the engine/].map(named);
  const tap = (key: string) => page.keyboard.press(key, { delay: 60 });
  return {
    more: () => tap(more!),
    less: () => tap(less!),
    cut: () => tap(cut!),
    rest: () => Promise.resolve(),
  };
}

interface Point {
  readonly x: number;
  readonly y: number;
}

/** px that a finger moves the lever at a time. */
const NUDGE = 6;
/** px: what a browser takes for a tap that shakes; a drag begins beyond it. */
const SLOP = 20;
/** CSS px from a slider's end to its knob's centre at that end. */
const KNOB = 8;

/** The lever and the button that the goal names: the finger stays on the lever until the cut. */
async function padsOf(page: Page, goal: string): Promise<Controls> {
  const [, lever] = /slide (\w+) for thrust/.exec(goal) ?? [];
  const [, cut] = /(\w+) stops it/.exec(goal) ?? [];
  if (lever === undefined || cut === undefined) throw new Error(`the goal names no lever: ${goal}`);
  const cdp = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: Point[]) =>
    cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
  const slider = page.getByRole('slider', { name: new RegExp(lever) });
  let finger: Point | null = null;
  const takeHold = async (): Promise<Point> => {
    const box = (await slider.boundingBox())!;
    const share = Number(await slider.inputValue()) / 100;
    const at = { x: box.x + KNOB + share * (box.width - 2 * KNOB), y: box.y + box.height / 2 };
    await touch('touchStart', [at]);
    await touch('touchMove', [{ ...at, x: at.x + SLOP }]);
    return at;
  };
  const slide = async (by: number) => {
    const from = finger ?? (await takeHold());
    finger = { ...from, x: from.x + by };
    await touch('touchMove', [finger]);
  };
  return {
    more: () => slide(NUDGE),
    less: () => slide(-NUDGE),
    async cut() {
      if (finger !== null) await touch('touchEnd', []);
      finger = null;
      await page.getByRole('button', { name: cut, exact: true }).tap();
    },
    async rest() {
      if (finger !== null) await touch('touchEnd', []);
      finger = null;
    },
  };
}

/** The outcome of one try, and the newcomer's readings and actions, for the first line of a failure. */
export interface Try {
  readonly card: string;
  readonly log: readonly string[];
}

/** Flies until a card is shown over the picture. */
export async function flyAsNewcomer(page: Page, isTouch: boolean): Promise<Try> {
  const first = await look(page);
  const controls = isTouch ? await padsOf(page, first.goal) : keysOf(page, first.goal);
  const log: string[] = [];
  let hasCut = false;
  for (;;) {
    const screen = await look(page);
    log.push(`${screen.status} | ${screen.goal.slice(-60)}`);
    // The score comes once the flight is checked.
    if (screen.card !== '' && !screen.card.includes('Checking')) {
      await controls.rest();
      return { card: screen.card, log };
    }
    if (/cut the engine now/i.test(screen.goal) && !hasCut) {
      await controls.cut();
      hasCut = true;
    } else if (/Too fast|More thrust/.test(screen.goal)) await controls.more();
    else if (/Too slow|Less thrust/.test(screen.goal)) await controls.less();
    await page.waitForTimeout(REACTION);
  }
}
