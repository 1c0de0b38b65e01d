import { type Action, isBoundByPlace, KEY_TABLE, type KeyMap } from './keyTable';

/** This keyboard's layout: KeyboardEvent.code → the character without modifiers. Unknown keys are those of a US keyboard. */
export type Layout = ReadonlyMap<string, string>;

const SIGNS: Readonly<Record<string, string>> = {
  BracketLeft: '[',
  BracketRight: ']',
  Semicolon: ';',
  Quote: "'",
  Comma: ',',
  Period: '.',
  Slash: '/',
  Backslash: '\\',
  Minus: '-',
  Equal: '=',
  Backquote: '`',
};

/** The character of a key position on a US keyboard; '' if it prints none. */
function usCharacter(code: string): string {
  if (/^Key[A-Z]$/.test(code)) return code.slice(3).toLowerCase();
  if (/^Digit\d$/.test(code)) return code.slice(5);
  return SIGNS[code] ?? '';
}

const US_CODES = new Map(
  [
    ...Array.from('ABCDEFGHIJKLMNOPQRSTUVWXYZ', (letter) => `Key${letter}`),
    ...Array.from('0123456789', (digit) => `Digit${digit}`),
    ...Object.keys(SIGNS),
  ].map((code) => [usCharacter(code), code] as const),
);

/** Places for a command whose letter and whose US place are both taken by others. */
const SPARE = ['Digit3', 'Digit4', 'Digit5', 'Digit6', 'Digit7', 'Digit8'];

/** Place → action on this keyboard. Flight keys have their places; a command sits where its letter is printed, if that is free. */
export function placesOf(map: KeyMap, layout: Layout): ReadonlyMap<string, Action> {
  const places = new Map<string, Action>();
  for (const { action } of KEY_TABLE)
    if (isBoundByPlace(action) && map[action] !== '') places.set(map[action], action);
  const printed = new Map<string, string>();
  for (const [code, character] of layout)
    if (!printed.has(character)) printed.set(character.toLowerCase(), code);
  const homeless: Action[] = [];
  for (const { action } of KEY_TABLE) {
    if (isBoundByPlace(action) || map[action] === '') continue;
    const code = printed.get(map[action]) ?? (printsLetters(layout) ? undefined : US_CODES.get(map[action]));
    if (code !== undefined && !places.has(code)) places.set(code, action);
    else homeless.push(action);
  }
  for (const action of homeless) {
    const candidates = [US_CODES.get(map[action]) ?? '', ...SPARE];
    const free = candidates.find((code) => code !== '' && !places.has(code));
    // A sign that needs Shift or AltGr ('?') is found by its character and needs no place.
    if (free !== undefined && US_CODES.has(map[action])) places.set(free, action);
  }
  return places;
}

/** A layout of another alphabet prints no Latin letters: commands then keep their US places. */
function printsLetters(layout: Layout): boolean {
  return layout.get('KeyR') !== undefined && /^[a-z]$/i.test(layout.get('KeyR')!);
}

/** The label of an action's key, for help and hints; '' if it has none. */
export function capOf(action: Action, map: KeyMap, layout: Layout): string {
  const key = map[action];
  if (key === '') return '';
  for (const [code, owner] of placesOf(map, layout))
    if (owner === action) return printedAt(code, layout).toUpperCase();
  return key.toUpperCase();
}

function printedAt(code: string, layout: Layout): string {
  return layout.get(code) ?? (usCharacter(code) || code);
}

interface KeyboardWithLayout {
  readonly keyboard?: { readonly getLayoutMap?: () => Promise<Iterable<[string, string]>> };
}

/** The layout as far as the browser reports it, completed by pressed keys. */
export interface LayoutSource {
  readonly layout: () => Layout;
  /** A key went down without modifiers: this reveals its printed character. */
  readonly learn: (code: string, key: string) => void;
}

/** @param changed called when a key turns out to print another character */
export function createLayout(navigator: Navigator, changed: () => void): LayoutSource {
  // Replaced and never changed: data derived from a layout is cached while it is the same object.
  let known: Layout = new Map();
  const keyboard = (navigator as Navigator & KeyboardWithLayout).keyboard;
  keyboard?.getLayoutMap?.().then(
    (map) => {
      known = new Map([...known, ...map]);
      changed();
    },
    // A page in an iframe may not query it; pressed keys show it.
    () => undefined,
  );
  return {
    layout: () => known,
    learn(code, key) {
      if (!/^.$/u.test(key) || code === '') return;
      const character = key.toLowerCase();
      if (printedAt(code, known) === character) return;
      // A place or a letter that is elsewhere now: another layout, of which nothing else is known.
      const hasChanged = known.has(code) || [...known.values()].includes(character);
      known = new Map([...(hasChanged ? [] : known), [code, character]]);
      changed();
    },
  };
}
