import type { ScoreLine } from '../../scenarios';
import { append, appendButton } from './elements';

/** The result of a flight, and the next step. */
export interface CardText {
  readonly title: string;
  /** Under the title; '' for none. */
  readonly words: string;
  readonly lines: readonly ScoreLine[];
  readonly actions: readonly CardAction[];
}

export interface CardAction {
  readonly text: string;
  /** The label of its key; '' for none. */
  readonly cap: string;
  readonly act: () => void;
}

export interface MissionCard {
  readonly show: (text: CardText) => void;
  readonly hide: () => void;
}

/** The card after LANDED or CRASHED. It is announced and takes no focus: the pilot may fly on. */
export function createMissionCard(element: HTMLElement): MissionCard {
  return {
    hide() {
      element.hidden = true;
      element.replaceChildren();
    },
    show({ title, words, lines, actions }) {
      element.replaceChildren();
      append(element, 'h2', '', title);
      if (words !== '') append(element, 'p', '', words);
      // Before the score, which on a phone is longer than the card.
      const row = append(element, 'div', 'row');
      for (const { text, cap, act } of actions) {
        const button = appendButton(row, text, act);
        if (cap !== '') {
          button.append(' ');
          append(button, 'kbd', '', cap);
        }
      }
      if (lines.length > 0) appendLines(element, lines);
      element.scrollTop = 0;
      element.hidden = false;
    },
  };
}

function appendLines(element: HTMLElement, lines: readonly ScoreLine[]): void {
  const table = append(element, 'table', 'score');
  append(table, 'caption', 'unseen', 'Score, line by line');
  const body = append(table, 'tbody');
  for (const { what, measured, points, most, rule } of lines) {
    const row = append(body, 'tr');
    append(row, 'th', '', what).scope = 'row';
    append(row, 'td', 'measured', measured);
    append(row, 'td', 'points', most === 0 ? String(points).replace('-', '−') : `${points} of ${most}`);
    // A number and its unit stay on one line.
    append(row, 'td', 'quiet', rule.replaceAll(/(\d) (?=[a-z])/g, '$1\u00a0'));
  }
}
