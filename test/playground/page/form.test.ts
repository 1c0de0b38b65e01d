/** The page's form, against the real server. */
import { describe, expect, it } from 'vitest';
import { all, attributes, fire, shownText } from '../../hud/pageInNode';
import { useGameClock } from '../game/openGame';
import { openPage, type OpenPage, openWorkshop } from './openPage';

useGameClock();

const fieldsOf = (page: OpenPage) => all(page.part('panel'), 'field');
const labelOf = (field: Element) => shownText(field.querySelector('label')!);
const controlOf = (field: Element) => field.querySelector<HTMLSelectElement>('select, input')!;
const isDisabled = (element: Element) =>
  (element as HTMLButtonElement).disabled || element.hasAttribute('disabled');

describe('the form', () => {
  it('has the fields of the golden file, and reports an invalid value below its field', async () => {
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
    await expect(`${lines.join('\n')}\n`).toMatchFileSnapshot('golden/fields.txt');
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

  it('shows network numbers for a custom network only, and offers any speed that a link sets', async () => {
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

  it('slows the world down and speeds it up', async () => {
    const page = await openWorkshop();
    const recorded = () => Number(/Recorded (\d+) s/.exec(page.text('dock'))![1]);
    page.choose('Speed', '0.1');
    page.play(5);
    expect(recorded()).toBe(1);
    page.choose('Speed', '4');
    page.play(1);
    expect(recorded()).toBe(5);
  });

  it('disables what only the built-in server can change', async () => {
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
          'Up delay, ms',
          'Up jitter, ms',
          'Up stalled, %',
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
          'Flight school',
          'Free flight',
          'Fly together',
          'Tip over, then right the ship with the key shown',
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

  it('has a check box for each overlay, and a legend of those that are on', async () => {
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

  it('opens the workshop for a demonstration, and closes it for a mission or free flight', async () => {
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

  it('names the invalid values of a link', async () => {
    expect((await openPage('?seed=0.5')).text('notice')).toContain('got “0.5”');
    const page = await openPage('?scenario=nowhere&seed=-1');
    expect(page.text('notice')).toContain('Some values in this link are invalid and were ignored.');
    expect(page.text('notice')).toContain(
      'scenario: expected the name of a mission, a lesson or a scenario, got ',
    );
    expect(page.text('notice')).toContain('seed: expected a whole number from 0 to 4294967295, got “-1”');
    page.play(1);
    page.choose('Mission', 'settle');
    expect(page.text('notice')).not.toContain('invalid');
  });
});
