import './help.css';
import { append, appendButton, appendLicences } from './elements';
import { GAMEPAD_TEXT, KEY_TEXT } from './helpTexts';
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

/** The objects that the dialog reads and changes. */
interface HelpContext {
  readonly settings: () => KeySettings;
  readonly change: (next: KeySettings) => void;
  readonly capText: (action: Action) => string;
}

/** The dialog of keys, made from the key table: lists them, rebinds them and switches them off. */
export function createHelp(
  document: Document,
  settings: () => KeySettings,
  change: (next: KeySettings) => void,
  capText: (action: Action) => string,
): Help {
  const context: HelpContext = { settings, change, capText };
  const dialog = append(document.body, 'dialog');
  dialog.setAttribute('aria-labelledby', 'help-title');
  const title = append(dialog, 'h2', '', 'Keys');
  title.id = 'help-title';
  // The dialog focuses it, as the first that can be: a button at the end would scroll a small screen there.
  title.tabIndex = -1;
  append(dialog, 'p', 'quiet', INTRODUCTION);
  const off = append(dialog, 'label', 'row');
  const box = append(off, 'input');
  box.type = 'checkbox';
  append(off, 'span', '', 'Use single-key shortcuts');
  const paintKeys = appendKeys(dialog, context);
  appendGamepad(dialog);
  const buttons = append(dialog, 'div', 'row');
  appendButton(buttons, 'Restore defaults', () => {
    change(defaultKeys());
    paint();
  });
  appendButton(buttons, 'Close', () => dialog.close());
  appendLicences(append(dialog, 'p', 'quiet'));
  const paint = () => {
    box.checked = settings().enabled;
    paintKeys();
  };
  box.addEventListener('change', () => {
    change({ ...settings(), enabled: box.checked });
    paint();
  });
  return {
    open() {
      paint();
      if (!dialog.open) dialog.showModal();
      // At its beginning, wherever it was left.
      dialog.scrollTop = 0;
    },
  };
}

const INTRODUCTION =
  'To change a key, click it and press the new one. Flight keys are bound by position on the keyboard, the others by letter. While the picture has the focus, the arrow keys turn the view, + and − zoom, and Home resets it.';

/** The keys by group; a key's button waits for the new key. Returns a function that shows the present keys. */
function appendKeys(dialog: HTMLDialogElement, context: HelpContext): () => void {
  const status = append(dialog, 'p');
  status.setAttribute('role', 'status');
  const caps = new Map<Action, HTMLButtonElement>();
  let waiting: Action | null = null;
  for (const group of GROUPS) {
    append(dialog, 'h3', '', group);
    const grid = append(dialog, 'div', 'keys');
    for (const { action } of KEY_TABLE.filter((row) => row.group === group)) {
      const about = KEY_TEXT[action];
      const row = append(grid, 'div', 'key');
      append(row, 'span', '', about);
      const cap = appendButton(row, '', () => {
        waiting = action;
        status.textContent = `Press the new key for “${about}”, or Escape.`;
      });
      cap.dataset['about'] = about;
      caps.set(action, cap);
    }
  }
  const paint = () => {
    const { map } = context.settings();
    for (const [action, cap] of caps) {
      cap.textContent = map[action] === '' ? '–' : context.capText(action);
      cap.setAttribute('aria-label', `${cap.dataset['about'] ?? ''}: ${cap.textContent}. Change`);
    }
  };
  dialog.addEventListener('keydown', (event) => {
    if (waiting === null || event.key === 'Tab') return;
    event.preventDefault();
    event.stopPropagation();
    status.textContent = rebindBy(event, waiting, context);
    waiting = null;
    paint();
  });
  dialog.addEventListener('close', () => {
    waiting = null;
    status.textContent = '';
  });
  return paint;
}

/** Binds the pressed key. Returns a message about it. */
function rebindBy(event: KeyboardEvent, action: Action, { settings, change, capText }: HelpContext): string {
  if (event.key === 'Escape') return '';
  const key = isBoundByPlace(action) ? event.code : event.key.toLowerCase();
  if (event.ctrlKey || event.altKey || event.metaKey || !isBindable(action, key))
    return 'That key cannot be used: use a letter, digit or symbol.';
  change({ ...settings(), map: rebind(settings().map, action, key) });
  return `Changed to ${capText(action)}.`;
}

function appendGamepad(dialog: Element): void {
  append(dialog, 'h3', '', 'Gamepad (standard mapping)');
  const pads = append(dialog, 'dl', 'keys');
  for (const [control, about] of GAMEPAD_TEXT) {
    const row = append(pads, 'div', 'key');
    append(row, 'dt', '', about);
    append(row, 'dd', '', control);
  }
}
