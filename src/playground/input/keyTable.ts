import type { RotationAction, TranslationAction } from '../../readout';

/** What a key can do. */
export type Action =
  | RotationAction
  | TranslationAction
  | 'throttleUp'
  | 'throttleDown'
  | 'throttleFull'
  | 'throttleCut'
  | 'rateDamping'
  | 'restart'
  | 'pause'
  | 'stepSubstep'
  | 'previousScenario'
  | 'nextScenario'
  | 'hide'
  | 'help';

export interface KeyRow {
  readonly action: Action;
  /** KeyboardEvent.key, lower case, without Ctrl, Shift or Alt: Ctrl+W closes the tab. */
  readonly key: string;
  readonly about: string;
  readonly group: 'Turn' | 'Push' | 'Engine' | 'Playground';
}

/** The one table of keys: flying, help, remapping and hints all read it. */
export const KEY_TABLE: readonly KeyRow[] = [
  { action: 'pitchMinus', key: 'w', about: 'Pitch forward (−x)', group: 'Turn' },
  { action: 'pitchPlus', key: 's', about: 'Pitch back (+x)', group: 'Turn' },
  { action: 'yawPlus', key: 'a', about: 'Yaw left (+y)', group: 'Turn' },
  { action: 'yawMinus', key: 'd', about: 'Yaw right (−y)', group: 'Turn' },
  { action: 'rollMinus', key: 'q', about: 'Roll left (−z)', group: 'Turn' },
  { action: 'rollPlus', key: 'e', about: 'Roll right (+z)', group: 'Turn' },
  { action: 'rateDamping', key: 't', about: 'Rate damping on or off', group: 'Turn' },
  { action: 'translateYPlus', key: 'i', about: 'Thrusters along +y', group: 'Push' },
  { action: 'translateYMinus', key: 'k', about: 'Thrusters along −y', group: 'Push' },
  { action: 'translateXMinus', key: 'j', about: 'Thrusters along −x', group: 'Push' },
  { action: 'translateXPlus', key: 'l', about: 'Thrusters along +x', group: 'Push' },
  { action: 'translateZPlus', key: 'u', about: 'Thrusters along +z', group: 'Push' },
  { action: 'translateZMinus', key: 'm', about: 'Thrusters along −z', group: 'Push' },
  { action: 'throttleUp', key: 'f', about: 'Throttle up', group: 'Engine' },
  { action: 'throttleDown', key: 'v', about: 'Throttle down', group: 'Engine' },
  { action: 'throttleFull', key: 'z', about: 'Full throttle', group: 'Engine' },
  { action: 'throttleCut', key: 'x', about: 'Cut the engine', group: 'Engine' },
  { action: 'restart', key: 'r', about: 'Restart', group: 'Playground' },
  { action: 'pause', key: 'p', about: 'Pause or go on', group: 'Playground' },
  { action: 'stepSubstep', key: 'o', about: 'Step one substep', group: 'Playground' },
  { action: 'previousScenario', key: '[', about: 'Scenario before', group: 'Playground' },
  { action: 'nextScenario', key: ']', about: 'Scenario after', group: 'Playground' },
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

const PLACE = 'touchdown.keys';

export function defaultKeys(): KeySettings {
  const map = Object.fromEntries(KEY_TABLE.map(({ action, key }) => [action, key])) as KeyMap;
  return { map, enabled: true };
}

/** What was saved, as far as it is sound; the rest is default. A store that is not to be had is an empty one. */
export function loadKeys(store: Storage | null): KeySettings {
  const defaults = defaultKeys();
  const saved = readSaved(store);
  if (saved === null) return defaults;
  const map = { ...defaults.map };
  const given: unknown = saved['map'];
  if (typeof given === 'object' && given !== null) {
    for (const { action } of KEY_TABLE) {
      const key: unknown = Object.hasOwn(given, action) ? (given as Record<string, unknown>)[action] : null;
      if (typeof key === 'string' && isBindable(key)) map[action] = key;
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
    // A full or forbidden store: the keys hold until the page closes.
  }
}

/** The map with `key` on `action`; whoever had the key gets the action's old one. */
export function rebind(map: KeyMap, action: Action, key: string): KeyMap {
  const owner = KEY_TABLE.find((row) => map[row.action] === key)?.action;
  const next = { ...map, [action]: key };
  if (owner !== undefined && owner !== action) next[owner] = map[action];
  return next;
}

/** A single printable character that moves neither focus nor page. */
export function isBindable(key: string): boolean {
  return /^[^\s]$/u.test(key) && key === key.toLowerCase();
}

/** A key's label in help and hints. */
export function keyCap(key: string): string {
  return key.toUpperCase();
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
