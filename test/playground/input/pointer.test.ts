/** Pointers, wheel and arrow keys in the picture: how they turn and zoom the camera, or move the ship. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { steerCamera } from '../../../src/playground/input/pointer';
import { createShipDrag, type ShipDrag } from '../../../src/playground/input/shipDrag';
import type { SceneView } from '../../../src/scene';
import { send } from './events';

const near = (x: number): unknown => expect.closeTo(x, 9);

/** A canvas whose pointers and keys steer a camera, and what was done to it. */
function createCanvas(isOn = false) {
  const done: unknown[][] = [];
  const note =
    (what: string) =>
    (...given: unknown[]) =>
      done.push([what, ...given]);
  const canvas = Object.assign(new EventTarget(), { tabIndex: -1, setPointerCapture: note('capture') });
  const scene = { turnCamera: note('turn'), zoomCamera: note('zoom'), resetCamera: note('reset') };
  const drag = { isOn: () => isOn, begin: note('begin'), move: note('move'), end: note('end') };
  steerCamera(
    canvas as unknown as HTMLCanvasElement,
    scene as unknown as SceneView,
    drag as unknown as ShipDrag,
  );
  const pointer = (type: string, pointerId: number, clientX: number, clientY: number) => {
    send(canvas, `pointer${type}`, { pointerId, clientX, clientY });
    return done.splice(0);
  };
  return { canvas, pointer, take: () => done.splice(0) };
}

describe('the camera', () => {
  it('turns by 0.006 rad per pixel of one finger’s drag, captured, until it is lifted', () => {
    const { canvas, pointer } = createCanvas();
    expect(canvas.tabIndex).toBe(0);
    expect(pointer('move', 1, 50, 50)).toEqual([]);
    expect(pointer('down', 1, 100, 50)).toEqual([['capture', 1]]);
    expect(pointer('move', 1, 110, 70)).toEqual([['turn', near(0.06), near(0.12)]]);
    expect(pointer('move', 1, 105, 70)).toEqual([['turn', near(-0.03), near(0)]]);
    expect(pointer('move', 2, 0, 0)).toEqual([]);
    expect(pointer('up', 1, 105, 70)).toEqual([['end']]);
    expect(pointer('move', 1, 0, 0)).toEqual([]);
    pointer('down', 1, 100, 50);
    expect(pointer('cancel', 1, 100, 50)).toEqual([['end']]);
    expect(pointer('move', 1, 0, 0)).toEqual([]);
  });

  it('zooms by the spread of two fingers, and turns again with the remaining one', () => {
    const { pointer } = createCanvas();
    pointer('down', 1, 0, 0);
    pointer('down', 2, 30, 40);
    expect(pointer('move', 2, 30, 40)).toEqual([]);
    expect(pointer('move', 2, 60, 80)).toEqual([['zoom', near(0.5)]]);
    expect(pointer('move', 1, 30, 40)).toEqual([['zoom', near(2)]]);
    // Fingers on one spot are no scale.
    expect(pointer('move', 1, 60, 80)).toEqual([]);
    expect(pointer('move', 1, 30, 40)).toEqual([]);
    pointer('down', 3, 0, 0);
    expect(pointer('move', 3, 5, 5)).toEqual([]);
    pointer('up', 3, 5, 5);
    expect(pointer('move', 1, 60, 40)).toEqual([]);
    pointer('up', 2, 60, 80);
    expect(pointer('move', 1, 70, 40)).toEqual([['turn', near(0.06), near(0)]]);
  });

  it('leaves one finger to the ship while it can be moved', () => {
    const { pointer } = createCanvas(true);
    expect(pointer('down', 1, 10, 10)).toEqual([['capture', 1], ['begin']]);
    expect(pointer('move', 1, 13, 6)).toEqual([['move', 3, -4]]);
    expect(pointer('down', 2, 10, 10)).toEqual([['capture', 2]]);
    expect(pointer('move', 1, 20, 6).filter(([what]) => what !== 'zoom')).toEqual([]);
  });

  it.each([
    ['ArrowLeft', ['turn', -0.09, 0]],
    ['ArrowRight', ['turn', 0.09, 0]],
    ['ArrowUp', ['turn', 0, 0.09]],
    ['ArrowDown', ['turn', 0, -0.09]],
    ['+', ['zoom', 0.88]],
    ['=', ['zoom', 0.88]],
    ['-', ['zoom', 1 / 0.88]],
    ['Home', ['reset']],
    ['toString', null],
    ['Tab', null],
  ])('on %s does %o', (key, what) => {
    const { canvas, take } = createCanvas();
    expect(send(canvas, 'keydown', { key })).toBe(what !== null);
    expect(take()).toEqual(what === null ? [] : [what]);
  });

  it.each([
    [150, 0.5],
    [-150, -0.5],
    [5000, 1],
    [-5000, -1],
  ])('zooms at a wheel’s %d by e to the %d, and keeps the page from scrolling', (deltaY, power) => {
    const { canvas, take } = createCanvas();
    expect(send(canvas, 'wheel', { deltaY })).toBe(true);
    expect(take()).toEqual([['zoom', near(Math.exp(power))]]);
  });
});

describe('a ship moved by the pointer', () => {
  afterEach(() => void vi.useRealTimers());

  it('follows it in the plane of the screen, in a command at each end and every 100 ms between', () => {
    vi.useFakeTimers();
    const put: unknown[] = [];
    let isKnown = false;
    const scene = {
      // Right, away and up in ICRF.
      screenAxes: (out: Float64Array) => (out.set([1, 0, 0, 0, 1, 0, 0, 0, 1]), isKnown),
      pixelSize: () => 0.5,
    };
    const drag = createShipDrag(scene as unknown as SceneView, (offset, begins) =>
      put.push([offset, begins]),
    );
    expect([drag.isOn(), drag.toggle(), drag.isOn(), drag.toggle()]).toEqual([false, true, true, false]);
    for (let i = 0; i < 2; i++) {
      drag.begin();
      drag.move(10, 4);
      drag.end();
      expect(put).toEqual([]);
    }
    isKnown = true;
    drag.begin();
    expect(put.splice(0)).toEqual([[[0, 0, 0], true]]);
    vi.advanceTimersByTime(99);
    drag.move(10, 4);
    expect(put).toEqual([]);
    vi.advanceTimersByTime(1);
    drag.move(10, 4);
    expect(put.splice(0)).toEqual([[[10, 0, -4], false]]);
    drag.move(-2, -2);
    drag.end();
    expect(put.splice(0)).toEqual([[[9, 0, -3], false]]);
    drag.move(10, 4);
    drag.end();
    expect(put).toEqual([]);
    drag.begin();
    expect(put).toEqual([[[0, 0, 0], true]]);
  });
});
