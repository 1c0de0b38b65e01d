import { append } from './elements';

/** The goal over the picture, and how to fly with what the pilot uses. */
export interface GoalPanel {
  readonly show: (title: string, goal: string) => void;
  /** Pieces of text; those in braces are keys. */
  readonly how: (text: string) => void;
  readonly hide: () => void;
}

export function createGoalPanel(element: HTMLElement): GoalPanel {
  const head = append(element, 'p', 'goal-title');
  const goal = append(element, 'p', 'goal-words');
  const how = append(element, 'p', 'goal-how');
  let shown = '';
  return {
    show(title, words) {
      head.textContent = title;
      goal.textContent = words;
      element.hidden = false;
    },
    how(text) {
      if (text === shown) return;
      shown = text;
      how.replaceChildren();
      for (const [i, part] of text.split(/[{}]/).entries()) {
        if (part === '') continue;
        if (i % 2 === 1) append(how, 'kbd', '', part);
        else how.append(part);
      }
    },
    hide: () => (element.hidden = true),
  };
}
