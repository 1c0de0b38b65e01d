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
  readonly about: string;
  readonly group: KeyGroup;
}

/** The one table of keys: flying, help, remapping and hints all read it. Directions are as seen on the screen. */
export const KEY_TABLE: readonly KeyRow[] = [
  { action: 'pitchMinus', key: 'KeyW', about: 'Tilt away', group: 'Turn' },
  { action: 'pitchPlus', key: 'KeyS', about: 'Tilt towards you', group: 'Turn' },
  { action: 'yawPlus', key: 'KeyA', about: 'Tilt left', group: 'Turn' },
  { action: 'yawMinus', key: 'KeyD', about: 'Tilt right', group: 'Turn' },
  { action: 'rollPlus', key: 'KeyQ', about: 'Turn left about the thrust axis', group: 'Turn' },
  { action: 'rollMinus', key: 'KeyE', about: 'Turn right about the thrust axis', group: 'Turn' },
  { action: 'translateYPlus', key: 'KeyI', about: 'Push away', group: 'Push' },
  { action: 'translateYMinus', key: 'KeyK', about: 'Push towards you', group: 'Push' },
  { action: 'translateXMinus', key: 'KeyJ', about: 'Push left', group: 'Push' },
  { action: 'translateXPlus', key: 'KeyL', about: 'Push right', group: 'Push' },
  { action: 'translateZPlus', key: 'KeyU', about: 'Push up', group: 'Push' },
  { action: 'translateZMinus', key: 'KeyM', about: 'Push down', group: 'Push' },
  { action: 'throttleUp', key: 'KeyF', about: 'More thrust', group: 'Engine' },
  { action: 'throttleDown', key: 'KeyV', about: 'Less thrust', group: 'Engine' },
  { action: 'throttleFull', key: 'KeyZ', about: 'Full thrust', group: 'Engine' },
  { action: 'throttleCut', key: 'KeyX', about: 'Cut the engine', group: 'Engine' },
  { action: 'rateDamping', key: 'KeyT', about: 'Rate damping on or off', group: 'Modes' },
  { action: 'modeHold', key: 'KeyC', about: 'Hold this attitude', group: 'Modes' },
  { action: 'modeUpright', key: 'KeyN', about: 'Upright (radial)', group: 'Modes' },
  { action: 'modeRetrograde', key: 'KeyB', about: 'Surface retrograde', group: 'Modes' },
  { action: 'killRates', key: 'KeyG', about: 'Stop turning', group: 'Modes' },
  { action: 'autopilot', key: 'KeyY', about: 'Autopilot: land, or give back', group: 'Modes' },
  { action: 'restart', key: 'r', about: 'Restart', group: 'Playground' },
  { action: 'pause', key: 'p', about: 'Pause or resume', group: 'Playground' },
  { action: 'stepSubstep', key: 'o', about: 'Step one substep', group: 'Playground' },
  { action: 'stepBack', key: ',', about: 'Replay: one substep back', group: 'Playground' },
  { action: 'previousScenario', key: '[', about: 'Previous mission or scenario', group: 'Playground' },
  { action: 'nextScenario', key: ']', about: 'Next mission or scenario', group: 'Playground' },
  { action: 'landingAids', key: '1', about: 'Landing aids on or off', group: 'Playground' },
  { action: 'mute', key: '2', about: 'Sound on or off', group: 'Playground' },
  { action: 'nextCamera', key: '3', about: 'Next camera', group: 'Playground' },
  { action: 'hide', key: 'h', about: 'Hide or show the panels', group: 'Playground' },
  { action: 'help', key: '?', about: 'Keys', group: 'Playground' },
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

/** The second edition's: the first kept letters for everything. */
const PLACE = 'touchdown.keys.2';

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
  if (firstDoubled(map) !== null) return { ...defaults, enabled: saved['enabled'] !== false };
  return { map, enabled: saved['enabled'] !== false };
}

export function saveKeys(store: Storage | null, settings: KeySettings): void {
  try {
    store?.setItem(PLACE, JSON.stringify(settings));
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

export function firstDoubled(map: KeyMap): string | null {
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
    const value: unknown = JSON.parse(store?.getItem(PLACE) ?? 'null');
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}
