/** The workshop's figures, its plots' axes, and the network's last seconds. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { createFigures } from '../../../../src/playground/panels/workshop/figures';
import { createNetStrip } from '../../../../src/playground/panels/workshop/netStrip';
import { axisRange } from '../../../../src/playground/panels/workshop/plots';
import type { Samples } from '../../../../src/playground/game/samples';
import type { Diagnosis } from '../../../../src/prediction';
import { all, attributes, createPage, layOut, one, shownText } from '../../../hud/pageInNode';

it('figures have each gauge’s digits, and dashes for unknown values', () => {
  const { root } = createPage();
  const show = createFigures(root);
  const values = [1.236, 3.456];
  show({ values: (gauge: number) => (gauge === 1 ? [] : values) } as unknown as Samples);
  const [head, ...rows] = all(root, 'tr').map(shownText);
  expect(head).toBe('Last 30 s last mean p95 max');
  expect(rows.slice(0, 2)).toEqual(['Round trip, ms 3.5 2.3 3.5 3.5', 'Jitter, ms – – – –']);
  expect(rows.slice(4, 7)).toEqual([
    'Clock rate, × 3.4560 2.3460 3.4560 3.4560',
    'Position error, m 3.456 2.346 3.456 3.456',
    'Attitude error, ° 3.46 2.35 3.46 3.46',
  ]);
  const scopes = all(root, 'th').map((each) => (each as unknown as { scope: string }).scope);
  expect([
    scopes.filter((scope) => scope === 'col').length,
    scopes.filter((scope) => scope === 'row').length,
  ]).toEqual([5, 9]);
});

it.each([
  // Its base and least length; the values; the axis, with a twentieth above.
  [
    [0, 0.001],
    [0, 0],
    [0, 0.00105],
  ],
  [
    [0, 10],
    [2, 30],
    [0, 31.5],
  ],
  [
    [0, 10],
    [-4, 6],
    [-4, 10.7],
  ],
  [
    [1, 0.001],
    [0.9, 1.2],
    [0.9, 1.215],
  ],
  [
    [0, 10],
    [Infinity, -Infinity],
    [0, 10.5],
  ],
] as const)('an axis %j of values %j is %j', ([base, least], [low, high], [from, to]) => {
  const [bottom, top] = axisRange({ base, least }, low, high);
  expect([bottom, top]).toEqual([from, expect.closeTo(to, 9)]);
});

describe('the strip of frames', () => {
  afterEach(() => void vi.unstubAllGlobals());

  function createStrip() {
    const drawn: (string | number)[][] = [];
    const pen = {
      fillStyle: '',
      clearRect: () => void (drawn.length = 0),
      fillRect: (...box: number[]) =>
        drawn.push([pen.fillStyle, ...box.map((x) => Math.round(x * 100) / 100)]),
    };
    const { root } = createPage(null, { getContext: () => pen, clientWidth: 403 });
    let look = () => undefined as unknown;
    class ResizeObserver {
      observe = () => undefined;
      constructor(resized: () => void) {
        look = resized;
      }
    }
    vi.stubGlobal('ResizeObserver', ResizeObserver);
    const strip = createNetStrip(root);
    layOut(one(root, 'canvas'), { clientHeight: 20 });
    look();
    return { strip, drawn, words: () => [...one(root, 'legend').children].map(shownText), root };
  }
  const none = {
    ...{ framesAccepted: 0, framesDuplicate: 0, framesOutOfOrder: 0, framesTooOld: 0 },
    ...{ framesFromFuture: 0, framesRefused: 0, lastMismatch: '' },
    ...{ correctionsLateInput: 0, correctionsLostInput: 0, correctionsOtherPilot: 0, correctionsMismatch: 0 },
  };
  const diagnosis = (changes: Partial<Diagnosis>) => ({ ...none, ...changes }) as unknown as Diagnosis;

  it('draws one mark per frame by its outcome, the newest at the right, for twenty seconds', () => {
    const { strip, drawn, root } = createStrip();
    expect(attributes(one(root, 'canvas'), 'aria-hidden')).toEqual(['true']);
    strip.watch(diagnosis({ framesAccepted: 1 }), 100);
    strip.watch(diagnosis({ framesAccepted: 2, framesRefused: 1 }), 110);
    strip.watch(diagnosis({ framesAccepted: 2, framesRefused: 1 }), 111);
    strip.paint(diagnosis({}), 110);
    const line = ['rgba(128,144,160,0.35)', 0, 19, 403, 1];
    expect(drawn).toEqual([
      line,
      ['#58b8ff', 198.5, 9, 3, 11],
      ['#58b8ff', 400, 9, 3, 11],
      ['#ff6a5e', 400, 0, 3, 20],
    ]);
    strip.paint(diagnosis({}), 119.9);
    expect(drawn).toHaveLength(4);
    strip.paint(diagnosis({}), 120);
    expect(drawn).toHaveLength(3);
    strip.clear();
    strip.paint(diagnosis({}), 120);
    expect(drawn).toEqual([line]);
    strip.watch(diagnosis({ framesAccepted: 80 }), 120);
    strip.paint(diagnosis({}), 120);
    // A page that was hidden has no place for what it missed.
    expect(drawn).toHaveLength(1 + 50);
    strip.paint(diagnosis({}), 119);
    expect(drawn).toEqual([line]);
  });

  it('has a shape and a colour of its own for every outcome, and counts in words', () => {
    const { strip, drawn, words } = createStrip();
    const counters = ['Accepted', 'Duplicate', 'OutOfOrder', 'TooOld', 'FromFuture', 'Refused'] as const;
    const every = diagnosis(Object.fromEntries(counters.map((name, i) => [`frames${name}`, i + 1])));
    strip.watch(diagnosis(Object.fromEntries(counters.map((name) => [`frames${name}`, 1]))), 7);
    strip.paint(every, 7);
    expect(drawn.slice(1).map((mark) => mark.at(-1))).toEqual([11, 6, 16, 18, 18, 20]);
    expect(new Set(drawn.map(([colour]) => colour)).size).toBe(7);
    expect(words()).toEqual([
      '1 accepted · 2 duplicate · 3 out of order · 4 too old · 5 from the future · 6 refused',
      'Corrections: none',
    ]);
    const corrections = { correctionsLateInput: 1, correctionsLostInput: 2, correctionsOtherPilot: 3 };
    strip.paint(diagnosis({ ...corrections, correctionsMismatch: 4, lastMismatch: 'position' }), 7);
    expect(words()).toEqual([
      '0 accepted',
      'Corrections: 1 late input, 2 lost input, 3 other pilot, 4 mismatch (position)',
    ]);
  });
});
