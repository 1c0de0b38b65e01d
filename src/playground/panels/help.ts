import { append, appendButton } from './elements';
import { GAMEPAD_WORDS } from '../input/gamepad';
import {
  type Action,
  defaultKeys,
  isBindable,
  isBoundByPlace,
  KEY_TABLE,
  type KeyRow,
  type KeySettings,
  rebind,
} from '../input/keyTable';

export interface Help {
  readonly open: () => void;
}

const GROUPS: readonly KeyRow['group'][] = ['Turn', 'Push', 'Engine', 'Modes', 'Playground'];

/** The dialog of keys, made from the key table: it tells them, rebinds them and switches them off. */
export function createHelp(
  document: Document,
  settings: () => KeySettings,
  change: (next: KeySettings) => void,
  capText: (action: Action) => string,
): Help {
  const dialog = append(document.body, 'dialog');
  dialog.setAttribute('aria-labelledby', 'help-title');
  const title = append(dialog, 'h2', '', 'Keys');
  title.id = 'help-title';
  title.tabIndex = -1;
  append(
    dialog,
    'p',
    'quiet',
    'Press a key’s button, then the new key. Flight keys go by their place on the keyboard, the others by letter. With the picture focused, arrows turn the view, + and − zoom, Home resets it.',
  );
  const off = append(dialog, 'label', 'row');
  const box = append(off, 'input');
  box.type = 'checkbox';
  append(off, 'span', '', 'Use single-key shortcuts');
  const said = append(dialog, 'p');
  said.setAttribute('role', 'status');
  const caps = new Map<Action, HTMLButtonElement>();
  let waiting: Action | null = null;

  for (const group of GROUPS) {
    append(dialog, 'h3', '', group);
    const grid = append(dialog, 'div', 'keys');
    for (const { action, about } of KEY_TABLE.filter((row) => row.group === group)) {
      const row = append(grid, 'div', 'key');
      append(row, 'span', '', about);
      const cap = appendButton(row, '', () => {
        waiting = action;
        said.textContent = `Press the new key for “${about}”, or Escape.`;
      });
      cap.dataset['about'] = about;
      caps.set(action, cap);
    }
  }
  append(dialog, 'h3', '', 'Gamepad (standard mapping)');
  const pads = append(dialog, 'dl', 'keys');
  for (const [control, about] of GAMEPAD_WORDS) {
    const row = append(pads, 'div', 'key');
    append(row, 'dt', '', about);
    append(row, 'dd', '', control);
  }
  const buttons = append(dialog, 'div', 'row');
  appendButton(buttons, 'Restore defaults', () => change(defaultKeys()));
  appendButton(buttons, 'Close', () => dialog.close());

  const paint = () => {
    const { map, enabled } = settings();
    box.checked = enabled;
    for (const [action, cap] of caps) {
      cap.textContent = map[action] === '' ? '–' : capText(action);
      cap.setAttribute('aria-label', `${cap.dataset['about'] ?? ''}: ${cap.textContent}. Change`);
    }
  };
  box.addEventListener('change', () => {
    change({ ...settings(), enabled: box.checked });
    paint();
  });
  buttons.addEventListener('click', paint);
  dialog.addEventListener('keydown', (event) => {
    if (waiting === null || event.key === 'Tab') return;
    event.preventDefault();
    event.stopPropagation();
    const key = isBoundByPlace(waiting) ? event.code : event.key.toLowerCase();
    if (event.key === 'Escape') said.textContent = '';
    else if (event.ctrlKey || event.altKey || event.metaKey || !isBindable(waiting, key)) {
      said.textContent = 'That key cannot be used: use a letter, digit or symbol.';
    } else {
      change({ ...settings(), map: rebind(settings().map, waiting, key) });
      said.textContent = `Changed to ${capText(waiting)}.`;
    }
    waiting = null;
    paint();
  });
  dialog.addEventListener('close', () => {
    waiting = null;
    said.textContent = '';
  });

  return {
    open() {
      paint();
      if (!dialog.open) dialog.showModal();
      // At its beginning: the last button would scroll a small screen to the end.
      title.focus();
      dialog.scrollTop = 0;
    },
  };
}
