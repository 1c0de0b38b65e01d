/** The texts of the page's panels: notices, the goal, cards and the legend. */
import { describe, expect, it } from 'vitest';
import { createGoalPanel } from '../../../src/playground/panels/goal';
import { createMissionCard } from '../../../src/playground/panels/missionCard';
import { createNotice } from '../../../src/playground/panels/notice';
import { DEFAULT_CHOICES } from '../../../src/playground/panels/choices';
import { createPanel } from '../../../src/playground/panels/panel';
import { createOverlayLegend } from '../../../src/playground/panels/overlayLegend';
import { OVERLAY_COLOURS } from '../../../src/scene';
import { all, attributes, createPage, fire, one, shownText } from '../../hud/pageInNode';

const click = (button: HTMLElement) => fire(button, 'click');

/** An element that a panel fills. */
function createPart(members = {}) {
  const { root } = createPage(null, members);
  return { root, part: root };
}

describe('notices', () => {
  const createNotices = (members = {}) => {
    const { root, part } = createPart(members);
    root.hidden = true;
    return { root, notice: createNotice(part), rows: () => all(root, 'notice-row').map(shownText) };
  };

  it('stay until they are closed or no longer true, each once, the last three', () => {
    const { root, notice, rows } = createNotices();
    notice.show('A');
    notice.show('A');
    expect([root.hidden, rows()]).toEqual([false, ['A Close']]);
    for (const text of ['B', 'C']) notice.show(text);
    expect(rows()).toEqual(['A Close', 'B Close', 'C Close']);
    notice.show('D');
    expect(rows()).toEqual(['B Close', 'C Close', 'D Close']);
    click(all(root, 'button')[1]!);
    expect([root.hidden, rows()]).toEqual([false, ['B Close', 'D Close']]);
    notice.withdraw('B');
    notice.withdraw('not shown');
    expect([root.hidden, rows()]).toEqual([false, ['D Close']]);
    notice.withdraw('D');
    expect([root.hidden, rows()]).toEqual([true, []]);
    notice.show('E');
    notice.show('F');
    notice.clear();
    expect([root.hidden, rows()]).toEqual([true, []]);
  });

  it('are marked where they are faults, not where they invite', () => {
    const { root, notice } = createNotices({ focus: () => undefined, select: () => undefined });
    notice.tell('Race');
    notice.showLink('The link is', 'https://one');
    expect(all(root, 'fault')).toEqual([]);
    notice.show('Refused');
    expect(all(root, 'fault').map(shownText)).toEqual(['Refused Close']);
  });

  it('with a link have it selected in a field, to be copied by hand', () => {
    const done: string[] = [];
    const { root, notice, rows } = createNotices({
      focus: () => done.push('focus'),
      select: () => done.push('select'),
    });
    for (const link of ['https://one', 'https://two']) notice.showLink('The link is', link);
    const field = one(root, 'notice-link');
    expect(field).toMatchObject({ type: 'text', readOnly: true, value: 'https://two' });
    expect(attributes(field, 'aria-label')).toEqual(['Link']);
    expect([rows(), done]).toEqual([['The link is Close'], ['focus', 'select', 'focus', 'select']]);
    click(one(root, 'button'));
    expect(rows()).toEqual([]);
  });
});

it('the goal has keys in its words, and breaks lines between its parts', () => {
  const { root, part } = createPart();
  const goal = createGoalPanel(part);
  goal.show('Hover', 'Stay at 20 m.');
  expect([one(root, 'goal-title'), one(root, 'goal-words')].map(shownText)).toEqual([
    'Hover',
    'Stay at 20 m.',
  ]);
  goal.how('{F} {V} engine · tilt {W}');
  const how = one(root, 'goal-how');
  expect(shownText(how)).toBe('F V engine · tilt W');
  expect(all(how, 'kbd').map(shownText)).toEqual(['F', 'V', 'W']);
  expect([...how.children].map(({ textContent }) => textContent)).toEqual(['F V engine', ' · ', 'tilt W']);
  // A dot that is seen would end a line.
  expect(one(how, 'unseen').textContent).toBe(' · ');
  expect(how.textContent).toBe('F V engine · tilt W');
  goal.how('You fly: {F} more, {V} less.');
  expect([...how.children].map(({ textContent }) => textContent)).toEqual(['You fly: F more,', 'V less.']);
  expect(how.textContent).toBe('You fly: F more, V less.');
  // Nor does a dot begin one.
  goal.how('Left with {Push left}. Stop.');
  expect(one(how, 'unbroken').textContent).toBe('Push left.');
  expect(how.textContent).toBe('Left with Push left. Stop.');
  const skipped: string[] = [];
  goal.offerSkip(() => skipped.push('skipped'));
  expect(shownText(one(root, 'goal-title'))).toBe('Hover Skip');
  click(one(root, 'button'));
  goal.offerSkip(null);
  expect([skipped, shownText(one(root, 'goal-title'))]).toEqual([['skipped'], 'Hover']);
  goal.advise('More thrust');
  expect(shownText(one(root, 'goal-advice'))).toBe('More thrust');
  goal.advise('');
  expect(shownText(one(root, 'goal-advice'))).toBe('');
  goal.hide();
  expect(root.hidden).toBe(true);
  goal.show('Land', 'On the pad.');
  expect(root.hidden).toBe(false);
});

it('a card has a title, buttons with their keys, and a score line by line', () => {
  const { root, part } = createPart();
  const card = createMissionCard(part);
  const done: string[] = [];
  const actions = [
    { text: 'Next', cap: 'Enter', act: () => done.push('next') },
    { text: 'Copy', cap: '', act: () => done.push('copy') },
  ];
  const line = { what: 'Fuel' as const, measured: '12 kg', points: 80, most: 100, rule: 'none from 9 kg' };
  card.show({ title: 'Landed', words: 'Soft.', lines: [line, { ...line, points: -30, most: 0 }], actions });
  expect(shownText(root)).toBe(
    'Landed Soft. Next Enter Copy Score, line by line Fuel 12 kg 80 of 100 none from 9\u00a0kg Fuel 12 kg −30 none from 9\u00a0kg',
  );
  all(root, 'button').forEach(click);
  expect(done).toEqual(['next', 'copy']);
  expect(all(root, 'kbd').map(shownText)).toEqual(['Enter']);
  expect(all(root, 'th').map((head) => (head as unknown as { scope: string }).scope)).toEqual(['row', 'row']);
  root.scrollTop = 40;
  card.show({ title: 'Crashed', words: '', lines: [], actions: [] });
  expect([shownText(root), root.scrollTop, all(root, 'p'), all(root, 'table')]).toEqual([
    'Crashed',
    0,
    [],
    [],
  ]);
  card.hide();
  expect([root.hidden, root.children]).toEqual([true, []]);
  card.show({ title: 'Landed', words: '', lines: [line], actions: [] });
  expect([root.hidden, all(root, 'tr').length]).toEqual([false, 1]);
});

it('the legend names the overlays that are on, each colour with its meaning', () => {
  const { root, part } = createPart();
  const show = createOverlayLegend(part);
  show(['ghost', 'forces']);
  expect(all(root, 'li').map((row) => shownText(row).split(':')[0])).toEqual([
    'Hull',
    'Arrow',
    'Arrow',
    'Arrow',
  ]);
  const { ghost, thrust, weight, support } = OVERLAY_COLOURS;
  const painted = all(root, 'swatch').map(({ style }) => parseInt(style.background.slice(1), 16));
  expect(painted).toEqual([ghost, thrust, weight, support]);
  expect(one(root, 'ul').hidden).toBe(false);
  show([]);
  expect([one(root, 'ul').hidden, all(root, 'li')]).toEqual([true, []]);
});

describe('the panel', () => {
  it('disables what another page’s server refuses, and does not describe its world', () => {
    const { root, part } = createPart();
    const listeners = { change: () => null, action: () => undefined, workshop: () => undefined };
    const panel = createPanel(part, { workshopOpen: false }, { ...listeners, failed: () => undefined });
    // linkedom's lists cannot be set.
    Object.defineProperty(all(root, 'select')[0]!, 'value', { value: '', writable: true });
    const offered = (server: string) => {
      panel.show({ ...DEFAULT_CHOICES, server });
      return all(root, 'button')
        .filter((button) => !button.hasAttribute('disabled'))
        .map(shownText);
    };
    const own = ['Restart', 'Pause', 'Keys', 'Sound', 'Flight school', 'Free flight', 'Fly together'];
    expect(offered('')).toEqual(own);
    expect(shownText(all(root, 'quiet')[0]!)).toMatch(/^Two hundred metres above/);
    for (const server of ['ws://127.0.0.1:8787', 'tab:abc'])
      expect(offered(server), server).toEqual(['Keys', 'Sound']);
    expect(shownText(all(root, 'quiet')[0]!)).toMatch(/^Two hundred metres above/);
    offered('wss://host');
    expect(shownText(all(root, 'quiet')[0]!)).toBe('');
  });
});
