/** The page's buttons, against the real server. */
import { describe, expect, it } from 'vitest';
import { all, attributes, fire, shownText } from '../../hud/pageInNode';
import { useGameClock } from '../game/openGame';
import { openPage, openWorkshop } from './openPage';

useGameClock();

describe('the buttons', () => {
  it('pause, step and restart the server', async () => {
    const page = await openWorkshop();
    const run = () => page.document.documentElement.dataset['run'];
    page.click('Pause');
    expect(page.text('banner')).toBe('Paused: the server stops at its next tick. O steps one substep.');
    expect(attributes(page.button('Resume'), 'aria-pressed')).toEqual(['true']);
    page.play(3);
    const paused = run();
    page.play(3);
    expect(run()).toBe(paused);
    page.click('Resume');
    expect([page.text('banner'), attributes(page.button('Pause'), 'aria-pressed')]).toEqual(['', ['false']]);
    page.play(3);
    expect(run()).not.toBe(paused);
    page.click('Step');
    expect(attributes(page.button('Resume'), 'aria-pressed')).toEqual(['true']);
    page.click('Restart');
    expect(attributes(page.button('Pause'), 'aria-pressed')).toEqual(['false']);
    page.play(2);
    expect(page.text('panel')).toMatch(/State hash at tick [12]: \d+/);
  });

  it('disturb the connection and restore it', async () => {
    const page = await openWorkshop();
    page.click('Lag spike');
    expect(page.text('banner')).toBe('Lag spike: nothing arrives for 1.5 s.');
    page.click('Freeze the server');
    expect(attributes(page.button('Freeze the server'), 'aria-pressed')).toEqual(['true']);
    page.click('Freeze the server');
    expect(attributes(page.button('Freeze the server'), 'aria-pressed')).toEqual(['false']);
    page.click('Drop the connection');
    page.play(5);
    expect(attributes(page.button('Reconnect'), 'aria-pressed')).toEqual(['true']);
    expect(page.text('banner')).toContain('Connection lost');
    page.click('Reconnect');
    page.play(2);
    expect([page.text('banner'), attributes(page.button('Drop the connection'), 'aria-pressed')]).toEqual([
      '',
      ['false'],
    ]);
    page.click('Hide for a minute');
    page.play(10.5);
    expect(page.text('banner')).toBe('Simulating a hidden tab: nothing received or drawn for 50 s.');
    expect(attributes(page.button('Back now (50 s)'), 'aria-pressed')).toEqual(['true']);
    page.play(50);
    expect([page.text('banner'), attributes(page.button('Hide for a minute'), 'aria-pressed')]).toEqual([
      '',
      ['false'],
    ]);
    page.click('Hide for a minute');
    page.play(2);
    page.click('Back now (58 s)');
    expect(page.text('banner')).toBe('');
  });

  it('copy links', async () => {
    const page = await openWorkshop();
    page.play(1);
    page.click('Copy link');
    await page.until(() => page.text('banner') === 'Link copied.');
    page.click('Fly together');
    await page.until(() => page.copied.length === 2);
    expect(page.copied[0]).toBe('https://page.test/?scenario=settle');
    expect(page.copied[1]).toMatch(/^https:\/\/page\.test\/\?server=tab:[a-z0-9]{4,6}$/);
    page.click('Fly together');
    await page.until(() => page.copied.length === 3);
    expect(page.copied[2]).toBe(page.copied[1]);
  });

  it('fly together under the name entered beside them; in a game alone a new name does not restart the flight', async () => {
    const page = await openPage('?scenario=sidestep');
    page.play(3);
    const height = () => Number(/AGL ([\d.]+)/.exec(page.text('hud'))![1]);
    const before = height();
    page.choose('Your name', 'Ann');
    page.play(1);
    expect([height() < before, page.text('hud').includes('Ann')]).toEqual([true, false]);
    page.click('Fly together');
    await page.until(() => page.copied.length === 1);
    page.choose('Your name', 'Ada');
    page.play(1);
    expect([height() > before, page.text('hud').includes('Ada')]).toEqual([true, true]);
  });

  it('open the list of keys, in which a key is rebound', async () => {
    const page = await openPage('');
    page.click('Keys');
    await page.until(() => page.document.querySelector('dialog'));
    const dialog = page.document.querySelector('dialog')!;
    const title = dialog.querySelector('h2')! as HTMLElement;
    expect([dialog.open, title.id, title.tabIndex]).toEqual([true, 'help-title', -1]);
    expect(attributes(dialog, 'aria-labelledby')).toEqual(['help-title']);
    const cap = all(dialog, 'button').find((button) =>
      attributes(button, 'aria-label')[0]?.startsWith('Pause'),
    )!;
    expect(shownText(cap)).toBe('P');
    fire(cap, 'click');
    fire(dialog, 'keydown', { key: 'Escape' });
    expect(shownText(cap)).toBe('P');
    fire(cap, 'click');
    fire(dialog, 'keydown', { key: '0', code: 'Digit0' });
    expect(shownText(cap)).toBe('0');
    page.click('Close', dialog);
    expect(dialog.open).toBe(false);
    page.key('Digit0', '0');
    expect(page.text('banner')).toContain('Paused');
  });
});
