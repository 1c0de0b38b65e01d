import type { RotationAction, TranslationAction } from '../../readout';

/** The actions of keys, gamepads and buttons. */
export type Action =
  | RotationAction
  | TranslationAction
  | 'throttleUp'
  | 'throttleDown'
  | 'throttleFull'
  | 'throttleCut'
  | 'rateDamping'
  | 'modeHold'
  | 'modeRetrograde'
  | 'modeUpright'
  | 'killRates'
  | 'autopilot'
  | 'restart'
  | 'pause'
  | 'stepSubstep'
  | 'stepBack'
  | 'previousScenario'
  | 'nextScenario'
  | 'landingAids'
  | 'mute'
  | 'nextCamera'
  | 'hide'
  | 'help';

export type KeyGroup = 'Turn' | 'Push' | 'Engine' | 'Modes' | 'Playground';

export interface KeyRow {
  readonly action: Action;
  /**
   * Flight keys: KeyboardEvent.code, the key's place, the same under every layout. Commands: the letter that the key prints. Neither
   * takes Ctrl, Alt or Command: Ctrl+W closes the tab.
   */
  readonly key: string;
  readonly group: KeyGroup;
}

/** The one table of keys: flying, help, remapping and hints all read it. Directions are as seen on the screen. */
export const KEY_TABLE: readonly KeyRow[] = [
  { action: 'pitchMinus', key: 'KeyW', group: 'Turn' },
  { action: 'pitchPlus', key: 'KeyS', group: 'Turn' },
  { action: 'yawPlus', key: 'KeyA', group: 'Turn' },
  { action: 'yawMinus', key: 'KeyD', group: 'Turn' },
  { action: 'rollPlus', key: 'KeyQ', group: 'Turn' },
  { action: 'rollMinus', key: 'KeyE', group: 'Turn' },
  { action: 'translateYPlus', key: 'KeyI', group: 'Push' },
  { action: 'translateYMinus', key: 'KeyK', group: 'Push' },
  { action: 'translateXMinus', key: 'KeyJ', group: 'Push' },
  { action: 'translateXPlus', key: 'KeyL', group: 'Push' },
  { action: 'translateZPlus', key: 'KeyU', group: 'Push' },
  { action: 'translateZMinus', key: 'KeyM', group: 'Push' },
  { action: 'throttleUp', key: 'KeyF', group: 'Engine' },
  { action: 'throttleDown', key: 'KeyV', group: 'Engine' },
  { action: 'throttleFull', key: 'KeyZ', group: 'Engine' },
  { action: 'throttleCut', key: 'KeyX', group: 'Engine' },
  { action: 'rateDamping', key: 'KeyT', group: 'Modes' },
  { action: 'modeHold', key: 'KeyC', group: 'Modes' },
  { action: 'modeUpright', key: 'KeyN', group: 'Modes' },
  { action: 'modeRetrograde', key: 'KeyB', group: 'Modes' },
  { action: 'killRates', key: 'KeyG', group: 'Modes' },
  { action: 'autopilot', key: 'KeyY', group: 'Modes' },
  { action: 'restart', key: 'r', group: 'Playground' },
  { action: 'pause', key: 'p', group: 'Playground' },
  { action: 'stepSubstep', key: 'o', group: 'Playground' },
  { action: 'stepBack', key: ',', group: 'Playground' },
  { action: 'previousScenario', key: '[', group: 'Playground' },
  { action: 'nextScenario', key: ']', group: 'Playground' },
  { action: 'landingAids', key: '1', group: 'Playground' },
  { action: 'mute', key: '2', group: 'Playground' },
  { action: 'nextCamera', key: '3', group: 'Playground' },
  { action: 'hide', key: 'h', group: 'Playground' },
  { action: 'help', key: '?', group: 'Playground' },
];

/** Key of each action; '' = none. */
export type KeyMap = Record<Action, string>;

export interface KeySettings {
  readonly map: KeyMap;
  /** Single-key shortcuts can be switched off (WCAG 2.1.4). */
  readonly enabled: boolean;
}

const FLIGHT_GROUPS: readonly KeyGroup[] = ['Turn', 'Push', 'Engine', 'Modes'];
const FLIGHT_KEYS = new Set(
  KEY_TABLE.filter(({ group }) => FLIGHT_GROUPS.includes(group)).map(({ action }) => action),
);

/** Flight keys are bound by place, commands by letter. */
export function isBoundByPlace(action: Action): boolean {
  return FLIGHT_KEYS.has(action);
}

/** The item in localStorage. Version 1 had letters for flight keys too. */
const STORAGE_KEY = 'touchdown.keys.2';

export function defaultKeys(): KeySettings {
  const map = Object.fromEntries(KEY_TABLE.map(({ action, key }) => [action, key])) as KeyMap;
  return { map, enabled: true };
}

/** Saved keys that are valid; the others have their defaults. A store that cannot be read counts as empty. */
export function loadKeys(store: Storage | null): KeySettings {
  const defaults = defaultKeys();
  const saved = readSaved(store);
  if (saved === null) return defaults;
  const map = { ...defaults.map };
  const given: unknown = saved['map'];
  if (typeof given === 'object' && given !== null) {
    for (const { action } of KEY_TABLE) {
      const key: unknown = Object.hasOwn(given, action) ? (given as Record<string, unknown>)[action] : null;
      if (typeof key === 'string' && isBindable(action, key)) map[action] = key;
    }
  }
  // Two actions on one key would both fire: such a map is not taken.
  if (firstDuplicate(map) !== null) return { ...defaults, enabled: saved['enabled'] !== false };
  return { map, enabled: saved['enabled'] !== false };
}

export function saveKeys(store: Storage | null, settings: KeySettings): void {
  try {
    store?.setItem(STORAGE_KEY, JSON.stringify(settings));
  } catch {
    // The store is full or forbidden: the keys last until the page closes.
  }
}

/** The map with `key` on `action`; the action that had the key gets the old one. */
export function rebind(map: KeyMap, action: Action, key: string): KeyMap {
  const owner = KEY_TABLE.find((row) => map[row.action] === key)?.action;
  const next = { ...map, [action]: key };
  if (owner !== undefined && owner !== action) next[owner] = map[action];
  return next;
}

/** A key position that prints a character, or a single character: no key that moves focus or page. */
export function isBindable(action: Action, key: string): boolean {
  if (isBoundByPlace(action))
    return /^(Key[A-Z]|Digit\d|Bracket(Left|Right)|Semicolon|Quote|Comma|Period|Slash|Backslash|Minus|Equal|Backquote|Intl\w+|Numpad\w+)$/.test(
      key,
    );
  return /^[^\s]$/u.test(key) && key === key.toLowerCase();
}

export function firstDuplicate(map: KeyMap): string | null {
  const seen = new Set<string>();
  for (const { action } of KEY_TABLE) {
    const key = map[action];
    if (key === '') continue;
    if (seen.has(key)) return key;
    seen.add(key);
  }
  return null;
}

function readSaved(store: Storage | null): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(store?.getItem(STORAGE_KEY) ?? 'null');
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}
