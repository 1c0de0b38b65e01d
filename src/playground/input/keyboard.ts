import { type Action, KEY_TABLE, type KeySettings } from './keyTable';

export interface KeyboardListeners {
  readonly pressed: (action: Action) => void;
  readonly released: (action: Action) => void;
  /** Everything held is to be let go: the window lost the keyboard. */
  readonly letGo: () => void;
}

/** Turns key events into actions. Off while a form control or a dialog has the focus. */
export function listenToKeys(
  window: Window,
  settings: () => KeySettings,
  { pressed, released, letGo }: KeyboardListeners,
): () => void {
  const down = new Map<string, Action>();
  const onDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey || takesKeys(event.target)) return;
    const action = actionOf(settings(), event.key);
    if (action === null) return;
    event.preventDefault();
    if (event.repeat || down.has(event.code)) return;
    down.set(event.code, action);
    pressed(action);
  };
  // By the key's place: a letter that went down with Shift must come up without it.
  const onUp = (event: KeyboardEvent) => {
    const action = down.get(event.code);
    if (action === undefined) return;
    down.delete(event.code);
    released(action);
  };
  const onBlur = () => {
    down.clear();
    letGo();
  };
  const onFocus = (event: FocusEvent) => {
    if (takesKeys(event.target)) onBlur();
  };
  const onVisibility = () => {
    if (window.document.visibilityState === 'hidden') onBlur();
  };
  window.addEventListener('keydown', onDown);
  window.addEventListener('keyup', onUp);
  window.addEventListener('blur', onBlur);
  window.addEventListener('focusin', onFocus);
  window.document.addEventListener('visibilitychange', onVisibility);
  return () => {
    window.removeEventListener('keydown', onDown);
    window.removeEventListener('keyup', onUp);
    window.removeEventListener('blur', onBlur);
    window.removeEventListener('focusin', onFocus);
    window.document.removeEventListener('visibilitychange', onVisibility);
  };
}

export function actionOf({ map, enabled }: KeySettings, key: string): Action | null {
  if (!enabled) return null;
  const wanted = key.toLowerCase();
  return KEY_TABLE.find(({ action }) => map[action] === wanted)?.action ?? null;
}

/** Buttons keep their own keys (space, enter) but do not take letters; fields and lists do. */
function takesKeys(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  return target.closest('input, select, textarea, [contenteditable], dialog[open]') !== null;
}
