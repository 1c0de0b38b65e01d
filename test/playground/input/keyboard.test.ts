/** Key events: which count, and what they do. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { send } from './events';
import { listenToKeys, restoreFocus } from '../../../src/playground/input/keyboard';
import { defaultKeys } from '../../../src/playground/input/keyTable';

/** An element of which only ancestors and the type are known. */
class InPage extends EventTarget {
  constructor(
    readonly inside: string,
    readonly type = '',
  ) {
    super();
  }
  closest(selectors: string): InPage | null {
    return selectors.split(', ').includes(this.inside) ? this : null;
  }
}

const input = (type: string) => new InPage('input', type);

beforeEach(() => void vi.stubGlobal('Element', InPage));
afterEach(() => void vi.unstubAllGlobals());

const FREE = { ctrlKey: false, altKey: false, metaKey: false, shiftKey: false, repeat: false };
const stroke = (code: string, key: string, changes: object = {}) => ({
  ...FREE,
  ...{ code, key, target: null, getModifierState: () => false },
  ...changes,
});
const W = stroke('KeyW', 'w');
const ENTER = stroke('Enter', 'Enter');

function createKeyboard() {
  const document = Object.assign(new EventTarget(), { visibilityState: 'visible' });
  const window = Object.assign(new EventTarget(), { document });
  const done: string[] = [];
  listenToKeys(
    window as unknown as Window,
    defaultKeys,
    { layout: () => new Map(), learn: (code, key) => done.push(`learn ${code} ${key}`) },
    {
      pressed: (action) => done.push(`+${action}`),
      released: (action) => done.push(`-${action}`),
      confirmed: () => done.push('confirmed'),
      releaseAll: () => done.push('releaseAll'),
    },
  );
  const take = () => done.splice(0).filter((what) => !what.startsWith('learn'));
  return { window, document, done, take };
}

describe('the keyboard', () => {
  it('presses and releases an action once, however often a held key repeats', () => {
    const { window, take } = createKeyboard();
    expect(send(window, 'keydown', W)).toBe(true);
    expect(send(window, 'keydown', { ...W, repeat: true })).toBe(true);
    expect(send(window, 'keydown', W)).toBe(true);
    expect(take()).toEqual(['+pitchMinus']);
    send(window, 'keyup', stroke('KeyW', 'W'));
    send(window, 'keyup', W);
    expect(take()).toEqual(['-pitchMinus']);
    send(window, 'keydown', W);
    expect(take()).toEqual(['+pitchMinus']);
  });

  it('leaves keys without an action to the browser', () => {
    const { window, take } = createKeyboard();
    expect(send(window, 'keydown', stroke('Tab', 'Tab'))).toBe(false);
    expect(send(window, 'keydown', stroke('KeyW', 'w', { ctrlKey: true }))).toBe(false);
    expect(take()).toEqual([]);
  });

  it('confirms by Enter, unless it repeats or the focused element takes it', () => {
    const { window, take } = createKeyboard();
    expect(send(window, 'keydown', ENTER)).toBe(true);
    expect(take()).toEqual(['confirmed']);
    expect(send(window, 'keydown', { ...ENTER, repeat: true })).toBe(false);
    for (const inside of ['button', 'a', 'summary', 'select', 'input'])
      expect(send(window, 'keydown', { ...ENTER, target: new InPage(inside) }), inside).toBe(false);
    expect(take()).toEqual([]);
    send(window, 'keydown', { ...ENTER, target: new InPage('div') });
    expect(take()).toEqual(['confirmed']);
  });

  it('leaves all keys to text fields and dialogs, and none to lists, boxes and sliders', () => {
    const { window, take } = createKeyboard();
    const texts = ['text', 'number', 'search', 'email', 'url', 'tel', 'password', 'date', 'time', 'file'];
    const areas = ['textarea', '[contenteditable]', 'dialog[open]'].map((inside) => new InPage(inside));
    for (const target of [...texts.map(input), ...areas]) {
      expect(send(window, 'keydown', { ...W, target }), `${target.inside} ${target.type}`).toBe(false);
      send(window, 'focusin', { target });
      expect(take()).toEqual(['releaseAll']);
    }
    for (const target of [...['range', 'checkbox', 'radio', 'context'].map(input), new InPage('select')]) {
      send(window, 'focusin', { target });
      send(window, 'keydown', { ...W, target });
      send(window, 'keyup', W);
      expect(take(), `${target.inside} ${target.type}`).toEqual(['+pitchMinus', '-pitchMinus']);
    }
  });

  it.each(['blur', 'pagehide', 'freeze', 'visibilitychange', 'Meta'])(
    'releases everything at %s',
    (cause) => {
      const { window, document, take } = createKeyboard();
      send(window, 'keydown', W);
      take();
      if (cause === 'Meta') send(window, 'keydown', stroke('MetaLeft', 'Meta'));
      else if (cause === 'visibilitychange') {
        send(document, cause);
        expect(take()).toEqual([]);
        document.visibilityState = 'hidden';
        send(document, cause);
      } else send(cause === 'freeze' ? document : window, cause);
      expect(take()).toEqual(['releaseAll']);
      // Its key comes up unseen or later, and must go down again.
      send(window, 'keyup', W);
      send(window, 'keydown', W);
      expect(take()).toEqual(['+pitchMinus']);
      send(window, 'keyup', stroke('MetaLeft', 'Meta'));
      expect(take()).toEqual(['releaseAll']);
    },
  );

  it('learns what is printed from keys without modifiers', () => {
    const { window, done } = createKeyboard();
    const learnt = (changes: object) => {
      send(window, 'keydown', stroke('KeyJ', 'j', changes));
      send(window, 'keyup', stroke('KeyJ', 'j'));
      return done.splice(0).filter((what) => what.startsWith('learn'));
    };
    expect(learnt({})).toEqual(['learn KeyJ j']);
    for (const held of ['ctrlKey', 'altKey', 'metaKey', 'shiftKey'])
      expect(learnt({ [held]: true }), held).toEqual([]);
    expect(learnt({ getModifierState: (name: string) => name === 'AltGraph' })).toEqual([]);
  });
});

describe('the focus, after a choice in a form', () => {
  const home = { focus: vi.fn() };
  const choose = (events: readonly (readonly [string, object?])[], target = input('checkbox')) => {
    const form = new EventTarget();
    home.focus.mockClear();
    restoreFocus(form as HTMLElement, home as unknown as HTMLElement);
    for (const [type, members] of events) send(form, type, { target, ...members });
    return home.focus.mock.calls.length;
  };

  it.each([
    ['goes home after a choice by pointer', 1, [['pointerdown'], ['change']]],
    ['goes home once', 1, [['pointerdown'], ['change'], ['change']]],
    ['stays after a choice by key', 0, [['change']]],
    [
      'stays when keys follow the pointer',
      0,
      [['pointerdown'], ['keydown', { key: 'ArrowDown' }], ['change']],
    ],
    [
      'goes home when Enter ends a list opened by pointer',
      1,
      [['pointerdown'], ['keydown', { key: 'Enter' }], ['change']],
    ],
    ['stays when Enter alone chose', 0, [['keydown', { key: 'Enter' }], ['change']]],
  ] as const)('%s', (_what, times, events) => {
    expect(choose(events)).toBe(times);
  });

  it('stays in a text field, and does not scroll the page on its way', () => {
    expect(choose([['pointerdown'], ['change']], input('number'))).toBe(0);
    choose([['pointerdown'], ['change']]);
    expect(home.focus).toHaveBeenCalledWith({ preventScroll: true });
  });
});
