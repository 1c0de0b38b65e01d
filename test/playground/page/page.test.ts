/** The page's form, buttons and keys, against the real server. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_CHOICES } from '../../../src/playground/panels/choices';
import { all, attributes, fire, shownText } from '../../hud/pageInNode';
import { useGameClock } from '../game/openGame';
import { openPage, type OpenPage } from './openPage';

useGameClock();

/** A page on a demonstration, which begins with the workshop open. */
const openWorkshop = async (query = '?scenario=settle') => {
  const page = await openPage(query);
  page.play(0.5);
  return page;
};

const fieldsOf = (page: OpenPage) => all(page.part('panel'), 'field');
const labelOf = (field: Element) => shownText(field.querySelector('label')!);
const controlOf = (field: Element) => field.querySelector<HTMLSelectElement>('select, input')!;
const isDisabled = (element: Element) =>
  (element as HTMLButtonElement).disabled || element.hasAttribute('disabled');

describe('the form', () => {
  it('has these fields, and says where a value is invalid', async () => {
    const page = await openWorkshop();
    const lines = fieldsOf(page).map((field) => {
      const control = controlOf(field);
      const { min, max, step, maxLength, type } = control as unknown as HTMLInputElement;
      const options = all(control, 'option').map((option) => (option as HTMLOptionElement).value);
      const numbers = type === 'number' ? `number ${min} … ${max} by ${step}` : '';
      const text =
        type === 'text'
          ? `text ${attributes(control, 'placeholder')[0] ?? ''} ${maxLength > 0 ? maxLength : ''}`
          : '';
      return `${labelOf(field)}: ${options.join(' ')}${numbers}${text}, shows ${control.value}`;
    });
    await expect(`${lines.join('\n')}\n`).toMatchFileSnapshot('kept/fields.txt');
    const [first] = fieldsOf(page);
    expect(all(first!, 'wrong').map(({ hidden }) => hidden)).toEqual([true]);

    expect(page.choose('Delay, ms', '9000')).toBe('expected a number from 0 to 5000');
    const control = page.field('Delay, ms');
    expect(attributes(control, 'aria-invalid', 'aria-describedby')).toEqual(['true', `${control.id}-wrong`]);
    expect(page.query()).toBe('?scenario=settle');
    expect(page.choose('Delay, ms', '90')).toBe('');
    expect(attributes(control, 'aria-invalid', 'aria-describedby')).toEqual(['false', null]);
    expect(page.query()).toBe('?scenario=settle&delay=90');
  });

  it('writes every choice into the address', async () => {
    const page = await openWorkshop();
    const choices = [
      ['Mission', 'bounce', 'scenario'],
      ['Client', 'gravity', 'mode'],
      ['Network', 'custom', 'net'],
      ['Up jitter, ms', '4', 'upjitter'],
      ['Up stalled, %', '2.5', 'upstalled'],
      ['Speed', '0.5', 'slow'],
      ['Body', 'Mars', 'body'],
      ['Ship', 'cargo_hauler', 'ship'],
      ['Terrain', 'flat', 'terrain'],
      ['Surface normal', 'terrain', 'normal'],
      ['Tick rate, Hz', '2', 'rate'],
      ['Time scale', '3', 'scale'],
      ['Other ships', '2', 'fleet'],
      ['Seed', '7', 'seed'],
      ['Protocol', '1', 'legacy'],
      ['Your name', 'Ada', 'name'],
    ] as const;
    for (const [label, value, key] of choices) {
      expect(page.choose(label, value), label).toBe('');
      page.play(0.5);
      expect(new URLSearchParams(page.query()).get(key), label).toBe(value);
    }
    page.play(3);
    expect(page.text('textAlternative')).toContain('Mars');
    expect(page.text('hud')).toContain('Fleet 3');
  });

  it('shows the numbers of a network only for a network of one’s own, and any speed of a link', async () => {
    const page = await openWorkshop('?scenario=settle&slow=0.3');
    const custom = page.field('Delay, ms').parentElement!.parentElement!;
    expect(custom.hidden).toBe(true);
    page.choose('Network', 'custom');
    expect(custom.hidden).toBe(false);
    const speeds = () =>
      all(page.field('Speed'), 'option').map((option) => (option as HTMLOptionElement).value);
    expect([page.field('Speed').value, speeds()]).toEqual([
      '0.3',
      ['0.1', '0.25', '0.5', '1', '2', '4', '0.3'],
    ]);
    page.choose('Speed', '2');
    expect(speeds()).toHaveLength(7);
  });

  it('leaves to a real server what is a real server’s', async () => {
    const page = await openWorkshop();
    const disabled = () => [
      fieldsOf(page)
        .filter((field) => isDisabled(controlOf(field)))
        .map(labelOf),
      all(page.part('panel'), 'button').filter(isDisabled).map(shownText),
    ];
    expect(disabled()).toEqual([[], []]);
    page.choose('Server', 'tab:nobody');
    expect(disabled()).toEqual([
      [
        ...[
          'Mission',
          'Network',
          'Delay, ms',
          'Jitter, ms',
          'Stalled, %',
          'Stall, ms',
          'Speed',
          'Body',
          'Ship',
        ],
        ...['Terrain', 'Surface normal', 'Tick rate, Hz', 'Time scale', 'Other ships', 'Seed', 'Protocol'],
      ],
      [
        ...[
          'Restart',
          'Pause',
          'Fly together',
          'Step',
          'Snapshot',
          'Restore',
          'Move the ship',
          'Kick the ship',
        ],
        ...['Lag spike', 'Freeze the server', 'Drop the connection', 'Copy flight link'],
      ],
    ]);
    for (const key of ['p', 'r', 'o', ']']) {
      page.key(`Key${key}`, key);
      expect(page.text('banner'), key).toBe('Only available with the built-in server.');
      page.play(5, 1000);
      expect(page.text('banner'), key).not.toBe('Only available with the built-in server.');
    }
    page.choose('Server', '');
    expect(disabled()).toEqual([[], []]);
  });

  it('has a box for each overlay, and explains those that are on', async () => {
    const page = await openWorkshop('?scenario=settle&show=footprint');
    const boxes = all(page.part('panel'), 'input').filter(
      (input) => (input as HTMLInputElement).type === 'checkbox',
    ) as HTMLInputElement[];
    expect(boxes.map(({ checked }) => checked)).toEqual([false, false, false, true, false]);
    boxes[0]!.checked = true;
    fire(boxes[0]!, 'change');
    expect(page.query()).toBe('?scenario=settle&show=ghost%2Cfootprint');
    expect(all(page.part('panel'), 'li').filter(({ className }) => className !== '').length).toBe(0);
  });

  it('begins a demonstration with the workshop open, and a mission or free flight with it folded', async () => {
    const isOpen = async (query: string) => {
      const { document } = await openPage(query);
      return [
        document.querySelector<HTMLDetailsElement>('#panel details')!.open,
        document.body.classList.contains('workshop'),
      ];
    };
    expect(await isOpen('')).toEqual([false, false]);
    expect(await isOpen('?scenario=free-flight')).toEqual([false, false]);
    expect(await isOpen('?scenario=settle')).toEqual([true, true]);
    const page = await openPage('');
    const workshop = page.document.querySelector<HTMLDetailsElement>('#panel details')!;
    page.play(2);
    workshop.open = true;
    fire(workshop, 'toggle');
    expect(page.document.body.classList.contains('workshop')).toBe(true);
    await page.until(() => all(page.part('panel'), 'run')[0]);
    expect(page.field('Client').value).toBe('predicted');
    workshop.open = false;
    fire(workshop, 'toggle');
    expect(page.document.body.classList.contains('workshop')).toBe(false);
  });

  it('names the values of a link that are invalid', async () => {
    expect((await openPage('?seed=0.5')).text('notice')).toContain('got “0.5”');
    const page = await openPage('?scenario=nowhere&seed=-1');
    expect(page.text('notice')).toContain('Some values in this link are invalid and were ignored.');
    expect(page.text('notice')).toContain('scenario: expected one of first-landing, ');
    expect(page.text('notice')).toContain('seed: expected a whole number from 0 to 4294967295, got “-1”');
    expect(DEFAULT_CHOICES.scenario).toBe('first-landing');
    page.play(1);
    page.choose('Mission', 'settle');
    expect(page.text('notice')).not.toContain('invalid');
  });
});

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

  it('disturb the connection, and end the disturbance', async () => {
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

  it('open the keys, where one is changed', async () => {
    const page = await openPage('');
    page.click('Keys');
    await page.until(() => page.document.querySelector('dialog'));
    const dialog = page.document.querySelector('dialog')!;
    expect(dialog.open).toBe(true);
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
