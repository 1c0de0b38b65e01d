import { append, appendButton } from './elements';
import {
  type Action,
  defaultKeys,
  isBindable,
  KEY_TABLE,
  keyCap,
  type KeyRow,
  type KeySettings,
  rebind,
} from '../input/keyTable';

export interface Help {
  readonly open: () => void;
}

const GROUPS: readonly KeyRow['group'][] = ['Turn', 'Push', 'Engine', 'Playground'];

/** The dialog of keys, made from the key table: it tells them, rebinds them and switches them off. */
export function createHelp(
  document: Document,
  settings: () => KeySettings,
  change: (next: KeySettings) => void,
): Help {
  const dialog = append(document.body, 'dialog');
  dialog.setAttribute('aria-labelledby', 'help-title');
  const title = append(dialog, 'h2', '', 'Keys');
  title.id = 'help-title';
  append(
    dialog,
    'p',
    'quiet',
    'Press a key’s button, then the new key. With the picture focused, arrows turn the view, + and − zoom, Home goes back.',
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
  const buttons = append(dialog, 'div', 'row');
  appendButton(buttons, 'As at first', () => change(defaultKeys()));
  const close = appendButton(buttons, 'Close', () => dialog.close());

  const paint = () => {
    const { map, enabled } = settings();
    box.checked = enabled;
    for (const [action, cap] of caps) {
      cap.textContent = map[action] === '' ? '–' : keyCap(map[action]);
      cap.setAttribute('aria-label', `${cap.dataset['about'] ?? ''}: ${cap.textContent}. Change`);
    }
  };
  box.addEventListener('change', () => {
    change({ ...settings(), enabled: box.checked });
    paint();
  });
  buttons.addEventListener('click', paint);
  dialog.addEventListener('keydown', (event) => {
    if (waiting === null) return;
    if (event.key === 'Tab') return;
    event.preventDefault();
    event.stopPropagation();
    const key = event.key.toLowerCase();
    if (key === 'escape') said.textContent = '';
    else if (event.ctrlKey || event.altKey || event.metaKey || !isBindable(key)) {
      said.textContent = 'That key cannot be used: letters, digits and signs can.';
      return;
    } else {
      change({ ...settings(), map: rebind(settings().map, waiting, key) });
      said.textContent = `Changed to ${keyCap(key)}.`;
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
      close.focus();
    },
  };
}
