/** The panels between which the ship is kept. */
import { expect, it } from 'vitest';
import type { SceneView } from '../../../src/scene';
import { coveredBy, watchMargins } from '../../../src/playground/view/margins';

type Edges = readonly [left: number, top: number, right: number, bottom: number];

/** An element with its place in the window, px, and its parts by class. */
function box([left, top, right, bottom]: Edges, inner: Readonly<Record<string, Edges>> = {}): HTMLElement {
  return {
    getBoundingClientRect: () => ({ left, top, right, bottom }),
    querySelector: (name: string) => (inner[name] === undefined ? null : box(inner[name])),
  } as unknown as HTMLElement;
}

const NOWHERE: Edges = [0, 0, 0, 0];
const WIDE = {
  picture: box([0, 0, 1280, 720]),
  goal: box([400, 12, 880, 140], { '.goal-how': [410, 60, 870, 110], '.goal-words': [410, 30, 870, 58] }),
  card: box(NOWHERE),
  foot: box([344, 510, 960, 708]),
  pads: box(NOWHERE, { '.thumb-middle': NOWHERE }),
};

function windowWith(position: string, changed: (() => void)[] = []) {
  return {
    getComputedStyle: () => ({ position }),
    ResizeObserver: class {
      constructor(call: () => void) {
        changed.push(call);
      }
      observe = () => undefined;
    },
  } as unknown as Window & typeof globalThis;
}

const covered = (parts: Readonly<Record<string, HTMLElement>>, position = 'absolute') =>
  coveredBy(windowWith(position), (id) => parts[id]!);

it('are the goal without its advice at the top, and the instruments or the lever at the bottom', () => {
  expect(covered(WIDE)).toEqual({ top: 110, bottom: 210 });
  const thumbs = box([0, 600, 1280, 710], { '.thumb-middle': [500, 430, 800, 700] });
  expect(covered({ ...WIDE, pads: thumbs })).toEqual({ top: 110, bottom: 290 });
});

it('include a card where the ship has room below it', () => {
  // A fifth of 720 px above the instruments.
  expect(covered({ ...WIDE, card: box([400, 120, 880, 366]) }).top).toBe(366);
  expect(covered({ ...WIDE, card: box([400, 120, 880, 367]) }).top).toBe(110);
  expect(covered({ ...WIDE, card: box([900, 120, 1280, 300]) }).top).toBe(110);
});

it('are the goal’s own words where it has no keys', () => {
  const ended = box([400, 12, 880, 70], { '.goal-how': NOWHERE, '.goal-words': [410, 30, 870, 58] });
  expect(covered({ ...WIDE, goal: ended }).top).toBe(58);
});

it('are zero for panels that are hidden, beside the middle or below the picture', () => {
  expect(covered({ ...WIDE, goal: box(NOWHERE, { '.goal-how': NOWHERE }), foot: box(NOWHERE) })).toEqual({
    top: 0,
    bottom: 0,
  });
  const aside = box([10, 10, 600, 400], { '.goal-how': [10, 60, 600, 300] });
  expect(covered({ ...WIDE, goal: aside }, 'static')).toEqual({ top: 0, bottom: 0 });
});

it('reach the scene, and the cards above them, whenever a panel changes its size', () => {
  const changed: (() => void)[] = [];
  const told: number[][] = [];
  const below: string[][] = [];
  const top = { style: { setProperty: (...set: string[]) => below.push(set) } } as unknown as HTMLElement;
  const sceneView = { setMargins: (...margins: number[]) => told.push(margins) } as unknown as SceneView;
  const parts: Record<string, HTMLElement> = { ...WIDE, top };
  watchMargins(windowWith('absolute', changed), (id) => parts[id]!, sceneView);
  changed[0]!();
  parts['foot'] = box([344, 310, 960, 708]);
  changed[0]!();
  expect(told).toEqual([
    [110, 210],
    [110, 410],
  ]);
  expect(below).toEqual([
    ['--below', '210px'],
    ['--below', '410px'],
  ]);
});
