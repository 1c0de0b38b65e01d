import { append } from './elements';

/** The goal over the picture, and how to fly with the pilot's device. */
export interface GoalPanel {
  readonly show: (title: string, goal: string) => void;
  /** Pieces of text; those in braces are keys. */
  readonly how: (text: string) => void;
  /** What to do now; '' for nothing. */
  readonly advise: (text: string) => void;
  readonly hide: () => void;
}

export function createGoalPanel(element: HTMLElement): GoalPanel {
  const head = append(element, 'p', 'goal-title');
  const goal = append(element, 'p', 'goal-words');
  const how = createKeyedText(append(element, 'p', 'goal-how'));
  const advise = createKeyedText(append(element, 'p', 'goal-advice'));
  return {
    show(title, words) {
      head.textContent = title;
      goal.textContent = words;
      element.hidden = false;
    },
    how,
    advise,
    hide: () => (element.hidden = true),
  };
}

/** Text with its keys in braces, set only where it changes. Lines break between its parts first: a word and its keys stay together. */
function createKeyedText(element: HTMLElement): (text: string) => void {
  let shown = '';
  return (text) => {
    if (text === shown) return;
    shown = text;
    element.replaceChildren();
    for (const group of text.replaceAll(' · ', ' ·\n').replaceAll(', {', ',\n{').split('\n')) {
      if (element.hasChildNodes()) element.append(' ');
      const words = append(element, 'span');
      for (const [i, part] of group.split(/[{}]/).entries()) {
        if (part === '') continue;
        if (i % 2 === 1) append(words, 'kbd', '', part);
        else words.append(part);
      }
    }
  };
}
