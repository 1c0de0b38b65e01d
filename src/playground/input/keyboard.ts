import type { Action, KeySettings } from './keyTable';
import { KEY_TABLE, isBoundByPlace } from './keyTable';
import { type Layout, type LayoutSource, placesOf } from './layout';

export interface KeyboardListeners {
  readonly pressed: (action: Action) => void;
  readonly released: (action: Action) => void;
  /** Enter, if no focused element takes it. */
  readonly confirmed: () => void;
  /** Everything held must be released. */
  readonly releaseAll: () => void;
}

/** The members of a KeyboardEvent that are used. */
export interface KeyStroke {
  readonly code: string;
  readonly key: string;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
  readonly altGraph: boolean;
}

/**
 * Turns key events into actions. Works with any focus but a text field's and a dialog's. A browser that misses a key's release never
 * reports it, so blur, a hidden or frozen page and Command (macOS sends no keyup under it) release everything.
 */
export function listenToKeys(
  window: Window,
  settings: () => KeySettings,
  source: LayoutSource,
  listeners: KeyboardListeners,
): void {
  const { document } = window;
  const down = new Map<string, Action>();
  const releaseAll = () => {
    down.clear();
    listeners.releaseAll();
  };
  window.addEventListener('keydown', (event) => {
    if (event.key === 'Meta') releaseAll();
    if (takesText(event.target)) return;
    const stroke = strokeOf(event);
    if (isPlain(stroke) && !event.shiftKey) source.learn(event.code, event.key);
    const action = actionOf(settings(), source.layout(), stroke);
    if (action === null) {
      if (event.key !== 'Enter' || event.repeat || takesEnter(event.target)) return;
      event.preventDefault();
      listeners.confirmed();
      return;
    }
    event.preventDefault();
    if (event.repeat || down.has(event.code)) return;
    down.set(event.code, action);
    listeners.pressed(action);
  });
  // By place: a letter that went down with Shift must come up without it.
  window.addEventListener('keyup', (event) => {
    if (event.key === 'Meta') releaseAll();
    const action = down.get(event.code);
    if (action === undefined) return;
    down.delete(event.code);
    listeners.released(action);
  });
  window.addEventListener('blur', releaseAll);
  window.addEventListener('pagehide', releaseAll);
  document.addEventListener('freeze', releaseAll);
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') releaseAll();
  });
  window.addEventListener('focusin', ({ target }) => {
    if (takesText(target)) releaseAll();
  });
}

function strokeOf(event: KeyboardEvent): KeyStroke {
  const { code, key, ctrlKey, altKey, metaKey } = event;
  return { code, key, ctrlKey, altKey, metaKey, altGraph: event.getModifierState('AltGraph') };
}

function isPlain({ ctrlKey, altKey, metaKey, altGraph }: KeyStroke): boolean {
  return !ctrlKey && !altKey && !metaKey && !altGraph;
}

let placed: { map: unknown; size: number; places: ReadonlyMap<string, Action> } | null = null;

/** The action of a key press, or null. AltGr types a sign (`]` is AltGr + 9 in Germany); Ctrl, Alt and Command are the browser's. */
export function actionOf({ map, enabled }: KeySettings, layout: Layout, stroke: KeyStroke): Action | null {
  if (!enabled || stroke.metaKey) return null;
  if (!stroke.altGraph && (stroke.ctrlKey || stroke.altKey)) return null;
  if (!stroke.altGraph) {
    if (placed?.map !== map || placed.size !== signature(layout))
      placed = { map, size: signature(layout), places: placesOf(map, layout) };
    const byPlace = placed.places.get(stroke.code);
    if (byPlace !== undefined) return byPlace;
  }
  const wanted = stroke.key.toLowerCase();
  return KEY_TABLE.find(({ action }) => !isBoundByPlace(action) && map[action] === wanted)?.action ?? null;
}

/** Changes when the layout does. */
function signature(layout: Layout): number {
  let sum = layout.size;
  for (const [code, character] of layout)
    sum = (sum * 31 + code.charCodeAt(code.length - 1) * 7 + (character.codePointAt(0) ?? 0)) | 0;
  return sum;
}

const TEXT_INPUTS = /^(text|number|search|email|url|tel|password|date|time|file)$/;

/** Text fields and open dialogs take every key; lists, boxes, sliders and buttons take only those that they use. */
function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest('textarea, [contenteditable], dialog[open]') !== null) return true;
  const input = target.closest('input');
  return input !== null && TEXT_INPUTS.test(input.type);
}

function takesEnter(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('button, a, summary, select, input') !== null;
}

/** A list or box that was chosen from with a pointer gives the focus back; one that is moved through by keys keeps it. */
export function restoreFocus(form: HTMLElement, home: HTMLElement): void {
  let byPointer = false;
  form.addEventListener('pointerdown', () => (byPointer = true));
  form.addEventListener('keydown', ({ key }) => (byPointer = key === 'Enter' && byPointer));
  form.addEventListener('change', ({ target }) => {
    if (byPointer && target instanceof Element && !takesText(target)) home.focus({ preventScroll: true });
    byPointer = false;
  });
}
