/** The dialog of keys: it lists them, rebinds them and switches them off. */
import { describe, expect, it } from 'vitest';
import { type Action, defaultKeys, KEY_TABLE } from '../../../src/playground/input/keyTable';
import { createHelp } from '../../../src/playground/panels/help';
import { all, createPage, fire, one, shownText } from '../../hud/pageInNode';

function openHelp() {
  let settings = defaultKeys();
  const opened: string[] = [];
  const members = {
    open: false,
    showModal(this: HTMLDialogElement) {
      this.open = true;
      opened.push('modal');
    },
    close(this: HTMLDialogElement) {
      this.open = false;
      fire(this, 'close');
    },
  };
  const { document } = createPage(null, members);
  const help = createHelp(
    document,
    () => settings,
    (next) => (settings = next),
    (action: Action) => settings.map[action].replace('Key', ''),
  );
  help.open();
  const dialog = one(document.body, 'dialog') as HTMLDialogElement;
  const cap = (about: string) => all(dialog, 'button').find((button) => button.dataset['about'] === about)!;
  const press = (key: string, code = '', more = {}) => {
    const done: string[] = [];
    const stop = { preventDefault: () => done.push('kept'), stopPropagation: () => done.push('stopped') };
    fire(dialog, 'keydown', { key, code, ...more, ...stop });
    return done;
  };
  return {
    ...{ help, dialog, opened, cap, press },
    settings: () => settings,
    status: () => shownText(dialog.querySelector('[role=status]')!),
    box: dialog.querySelector('input')!,
    button: (text: string) => all(dialog, 'button').find((button) => shownText(button) === text)!,
  };
}

describe('the dialog of keys', () => {
  it('lists every key once under its group, with its text, and opens once', () => {
    const { dialog, help, opened } = openHelp();
    const groups = [...new Set(KEY_TABLE.map(({ group }) => group))];
    expect(all(dialog, 'h3').map(shownText)).toEqual([...groups, 'Gamepad (standard mapping)']);
    const grids = all(dialog, 'div.keys');
    expect(grids.map((grid) => all(grid, 'button').map(shownText))).toEqual(
      groups.map((group) =>
        KEY_TABLE.filter((row) => row.group === group).map(({ key }) => key.replace('Key', '')),
      ),
    );
    expect(shownText(all(dialog, 'key')[0]!)).toBe('Tilt away W');
    help.open();
    expect([opened, dialog.open]).toEqual([['modal'], true]);
  });

  it('binds the next key to the one that was clicked, and swaps the keys of two', () => {
    const { cap, press, settings, status } = openHelp();
    expect(press('s', 'KeyS')).toEqual([]);
    fire(cap('Tilt away'), 'click');
    expect(status()).toBe('Press the new key for “Tilt away”, or Escape.');
    // The page behind must not fly by it.
    expect(press('s', 'KeyS')).toEqual(['kept', 'stopped']);
    expect([settings().map.pitchMinus, settings().map.pitchPlus, status()]).toEqual([
      ...['KeyS', 'KeyW', 'Changed to S.'],
    ]);
    expect([cap('Tilt away'), cap('Tilt towards you')].map(shownText)).toEqual(['S', 'W']);
    expect(cap('Tilt away').getAttribute('aria-label')).toBe('Tilt away: S. Change');
    // One key for each click.
    press('x', 'KeyX');
    expect(settings().map.pitchMinus).toBe('KeyS');
    // Commands by letter, in either case.
    fire(cap('Restart'), 'click');
    press('W', 'KeyZ');
    expect(settings().map.restart).toBe('w');
  });

  it('refuses keys that move focus or page, and combinations', () => {
    const { cap, press, settings, status } = openHelp();
    for (const [key, more] of [
      ['Enter', {}],
      ['w', { ctrlKey: true }],
      ['w', { altKey: true }],
      ['w', { metaKey: true }],
    ] as const) {
      fire(cap('Restart'), 'click');
      press(key, 'KeyW', more);
      expect(status(), key).toBe('That key cannot be used: use a letter, digit or symbol.');
    }
    expect(settings()).toEqual(defaultKeys());
  });

  it('keeps the key after Escape and after it was closed, and lets Tab through', () => {
    const { cap, press, settings, status, dialog } = openHelp();
    fire(cap('Restart'), 'click');
    expect(press('Tab')).toEqual([]);
    expect(status()).not.toBe('');
    expect(press('Escape')).toEqual(['kept', 'stopped']);
    expect([status(), settings()]).toEqual(['', defaultKeys()]);
    fire(cap('Restart'), 'click');
    dialog.close();
    expect([status(), press('q', 'KeyQ'), settings()]).toEqual(['', [], defaultKeys()]);
  });

  it('switches single keys off and restores all defaults', () => {
    const { box, button, cap, press, settings, dialog } = openHelp();
    expect(box.checked).toBe(true);
    box.checked = false;
    fire(box, 'change');
    expect([settings().enabled, settings().map]).toEqual([false, defaultKeys().map]);
    fire(cap('Restart'), 'click');
    press('9');
    expect([shownText(cap('Restart')), settings().map.restart, settings().enabled]).toEqual([
      '9',
      '9',
      false,
    ]);
    fire(button('Restore defaults'), 'click');
    expect([shownText(cap('Restart')), box.checked, settings()]).toEqual(['r', true, defaultKeys()]);
    fire(button('Close'), 'click');
    expect(dialog.open).toBe(false);
  });
});
