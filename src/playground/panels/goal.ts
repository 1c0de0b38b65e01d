import { append, appendButton } from './elements';

/** The goal over the picture, and how to fly with the pilot's device. */
export interface GoalPanel {
  readonly show: (title: string, goal: string) => void;
  /** What the button beside the title does; null: there is none. */
  readonly offerSkip: (skip: (() => void) | null) => void;
  /** Pieces of text; those in braces are keys. */
  readonly how: (text: string) => void;
  /** What to do now; '' for nothing. */
  readonly advise: (text: string) => void;
  readonly hide: () => void;
}

export function createGoalPanel(element: HTMLElement): GoalPanel {
  const head = append(element, 'p', 'goal-title');
  const title = append(head, 'span');
  let skip: (() => void) | null = null;
  const skipButton = appendButton(head, 'Skip', () => skip?.());
  skipButton.hidden = true;
  const goal = append(element, 'p', 'goal-words');
  const how = createKeyedText(append(element, 'p', 'goal-how'));
  const advise = createKeyedText(append(element, 'p', 'goal-advice'));
  return {
    show(text, words) {
      title.textContent = text;
      goal.textContent = words;
      element.hidden = false;
    },
    offerSkip(next) {
      skip = next;
      skipButton.hidden = next === null;
    },
    how,
    advise,
    hide: () => (element.hidden = true),
  };
}

/**
 * Text with its keys in braces, set only where it changes. Lines break between its parts first: a word and its keys stay together. A dot
 * between two parts is for screen readers only, because it could end a line; on the screen a wider gap separates the parts.
 */
function createKeyedText(element: HTMLElement): (text: string) => void {
  let shown = '';
  return (text) => {
    if (text === shown) return;
    shown = text;
    element.replaceChildren();
    const items = text.split(' · ');
    for (const [i, item] of items.entries()) {
      if (i > 0) append(element, 'span', 'unseen', ' · ');
      for (const [k, part] of item.replaceAll(', {', ',\n{').split('\n').entries()) {
        if (k > 0) element.append(' ');
        appendKeyed(append(element, 'span', items.length > 1 ? 'goal-item' : 'goal-part'), part);
      }
    }
  };
}

/** No line begins with the dot or comma after a key. */
function appendKeyed(host: HTMLElement, text: string): void {
  for (const [, key, mark, words] of text.matchAll(/(?:\{([^}]+)\}([.,:]?))?([^{]*)/g)) {
    if (key !== undefined) {
      const unbroken = append(host, 'span', 'unbroken');
      append(unbroken, 'kbd', '', key);
      unbroken.append(mark!);
    }
    host.append(words!);
  }
}
