import type { Choices } from './choices';
import { appendField } from './elements';

/** Form fields that show the choices and report changes. */
export interface Form {
  readonly field: (
    parent: Element,
    title: string,
    name: keyof Choices,
    control: HTMLInputElement | HTMLSelectElement,
  ) => void;
  /** Something else that follows the choices. */
  readonly also: (show: (choices: Choices) => void) => void;
  readonly change: (name: keyof Choices, text: string) => string | null;
  readonly show: (choices: Choices) => void;
  /** Shows the present choices in fields that were added since. */
  readonly showAgain: () => void;
}

/** Choices that do not apply to a real server, which has its own world. */
const BUILT_IN_ONLY = new Set<keyof Choices>([
  'scenario',
  'body',
  'shipClass',
  'terrain',
  'surfaceNormal',
  'tickRate',
  'timeScale',
  'network',
  'delay',
  'jitter',
  'stalled',
  'stall',
  'upDelay',
  'upJitter',
  'upStalled',
  'slow',
  'fleet',
  'seed',
  'legacy',
]);

export function createForm(change: (name: keyof Choices, text: string) => string | null): Form {
  const shows: ((choices: Choices) => void)[] = [];
  let latest: Choices | null = null;
  return {
    change,
    also: (show) => shows.push(show),
    show(choices) {
      latest = choices;
      shows.forEach((show) => show(choices));
    },
    showAgain() {
      if (latest !== null) shows.forEach((show) => show(latest!));
    },
    field(parent, title, name, control) {
      const made = appendField(parent, title, control);
      control.addEventListener('change', () => made.complain(change(name, control.value) ?? ''));
      shows.push((choices) => {
        const text = String(choices[name]);
        if (control.value !== text) control.value = text;
        control.disabled = choices.server !== '' && BUILT_IN_ONLY.has(name);
        made.complain('');
      });
    },
  };
}
