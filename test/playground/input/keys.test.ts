import { describe, expect, it } from 'vitest';
import { actionOf, type KeyStroke } from '../../../src/playground/input/keyboard';
import {
  type Action,
  defaultKeys,
  firstDuplicate,
  isBindable,
  KEY_TABLE,
  loadKeys,
  rebind,
  saveKeys,
} from '../../../src/playground/input/keyTable';
import { capOf, type Layout, placesOf } from '../../../src/playground/input/layout';

/** A store in memory. */
function storeWith(text: string | null): Storage {
  let kept = text;
  return {
    getItem: () => kept,
    setItem: (_: string, value: string) => {
      kept = value;
    },
  } as unknown as Storage;
}

describe('key table', () => {
  it('has the game’s keys, each once, without modifiers', () => {
    const { map } = defaultKeys();
    expect(firstDuplicate(map)).toBeNull();
    expect(KEY_TABLE.every(({ action, key }) => isBindable(action, key))).toBe(true);
    const throttle = [map.throttleUp, map.throttleDown, map.throttleFull, map.throttleCut];
    expect(throttle).toEqual(['KeyF', 'KeyV', 'KeyZ', 'KeyX']);
    expect([map.rateDamping, map.restart, map.pause, map.stepSubstep]).toEqual(['KeyT', 'r', 'p', 'o']);
    expect([map.previousScenario, map.nextScenario, map.hide, map.help]).toEqual(['[', ']', 'h', '?']);
    const turns = ['pitchPlus', 'pitchMinus', 'yawPlus', 'yawMinus', 'rollPlus', 'rollMinus'] as const;
    expect(turns.map((action) => map[action].slice(3)).sort()).toEqual(['A', 'D', 'E', 'Q', 'S', 'W']);
  });

  it('is remapped by swapping, saved and read again', () => {
    const { map } = defaultKeys();
    const next = rebind(map, 'pitchPlus', 'KeyW');
    expect([next.pitchPlus, next.pitchMinus]).toEqual(['KeyW', 'KeyS']);
    const store = storeWith(null);
    saveKeys(store, { map: next, enabled: false });
    expect(loadKeys(store)).toEqual({ map: next, enabled: false });
    const none: Layout = new Map();
    expect(actionOf({ map: next, enabled: true }, none, stroke('KeyW', 'W'))).toBe('pitchPlus');
    expect(actionOf({ map: next, enabled: false }, none, stroke('KeyW', 'w'))).toBeNull();
  });

  it.each([
    ['not JSON', '{'],
    ['no object', '7'],
    ['a map of nonsense', '{"map":{"pitchPlus":"Enter","yawPlus":9,"nothing":"k","restart":"KeyR"}}'],
    ['two actions on a key', '{"map":{"pitchPlus":"KeyW"}}'],
    ['no map', '{"map":null}'],
  ])('%s in the store: the defaults apply', (_, text) => {
    expect(loadKeys(storeWith(text))).toEqual(defaultKeys());
  });

  it('works if the browser refuses storage', () => {
    const refusing = {
      getItem: () => {
        throw new Error('forbidden');
      },
      setItem: () => {
        throw new Error('full');
      },
    } as unknown as Storage;
    expect(loadKeys(refusing)).toEqual(defaultKeys());
    saveKeys(refusing, defaultKeys());
    expect(loadKeys(null)).toEqual(defaultKeys());
  });
});

function stroke(code: string, key: string, changes: Partial<KeyStroke> = {}): KeyStroke {
  return { code, key, ctrlKey: false, altKey: false, metaKey: false, altGraph: false, ...changes };
}

/** The characters that keyboard layouts have at the keys used, in the order of PLACES. */
const PLACES = [
  ...'QWERTYUIOP'.split('').map((letter) => `Key${letter}`),
  ...'ASDFGHJKL'.split('').map((letter) => `Key${letter}`),
  'Semicolon',
  ...'ZXCVBNM'.split('').map((letter) => `Key${letter}`),
  ...['Comma', 'Period', 'Slash', 'BracketLeft', 'BracketRight', 'Minus'],
];
const LAYOUTS: Readonly<Record<string, string>> = {
  us: 'qwertyuiopasdfghjkl;zxcvbnm,./[]-',
  qwertz: 'qwertzuiopasdfghjklöyxcvbnm,.-ü+ß',
  azerty: 'azertyuiopqsdfghjklmwxcvbn,;:!^$)',
  dvorak: "',.pyfgcrlaoeuidhtns;qjkxbmwvz/=[",
  colemak: 'qwfpgjluy;arstdhneiozxcvbkm,./[]-',
  cyrillic: 'йцукенгшщзфывапролджячсмитьбю.хъ-',
};

describe.each(Object.keys(LAYOUTS))('on a %s keyboard', (name) => {
  const layout: Layout = new Map(PLACES.map((code, i) => [code, LAYOUTS[name]!.charAt(i)]));
  const keys = defaultKeys();
  const typed = (code: string) => actionOf(keys, layout, stroke(code, layout.get(code) ?? ''));

  it('flies by key position', () => {
    const asdw = ['KeyW', 'KeyA', 'KeyS', 'KeyD', 'KeyF', 'KeyX'];
    expect(asdw.map(typed)).toEqual([
      'pitchMinus',
      'yawPlus',
      'pitchPlus',
      'yawMinus',
      'throttleUp',
      'throttleCut',
    ]);
  });

  it('has a key for every command, and names that key', () => {
    for (const action of ['restart', 'pause', 'stepSubstep', 'hide'] as const) {
      const cap = capOf(action, keys.map, layout);
      const code = [...placesOf(keys.map, layout)].find(([, owner]) => owner === action)?.[0];
      expect(code, action).toBeDefined();
      expect(typed(code!), action).toBe(action);
      expect(cap.length, action).toBeGreaterThan(0);
      if (layout.has(code!)) expect(cap).toBe(layout.get(code!)!.toUpperCase());
    }
  });
});

describe('letters and modifiers', () => {
  const keys = defaultKeys();
  const qwertz: Layout = new Map(PLACES.map((code, i) => [code, LAYOUTS['qwertz']!.charAt(i)]));
  const layout: Layout = new Map();
  it('AltGr types a character, whether or not the browser reports it as Ctrl + Alt', () => {
    const altGr = { ctrlKey: true, altKey: true, altGraph: true };
    expect(actionOf(keys, qwertz, stroke('Digit9', ']', altGr))).toBe('nextScenario');
    expect(actionOf(keys, qwertz, stroke('Digit9', ']', { altGraph: true }))).toBe('nextScenario');
    expect(actionOf(keys, qwertz, stroke('KeyE', '€', altGr))).toBeNull();
  });
  it('Shift makes the question mark', () => {
    expect(actionOf(keys, qwertz, stroke('Minus', '?'))).toBe('help');
    expect(actionOf(keys, layout, stroke('Slash', '?'))).toBe('help');
  });
  it.each([{ ctrlKey: true }, { altKey: true }, { metaKey: true }])('%o belongs to the browser', (held) => {
    const wanted: (Action | null)[] = [
      actionOf(keys, layout, stroke('KeyW', 'w', held)),
      actionOf(keys, layout, stroke('KeyR', 'r', held)),
    ];
    expect(wanted).toEqual([null, null]);
  });
});
