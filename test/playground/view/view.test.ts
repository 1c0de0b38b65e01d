/** Frames and sizes of the page: when it draws, when it is ready, and how fine. */
import { describe, expect, it } from 'vitest';
import { createFrameLoop } from '../../../src/playground/view/frameLoop';
import { createCameraSwitch } from '../../../src/playground/view/cameraSwitch';
import { pixelRatioOf, watchSize } from '../../../src/playground/view/pageSize';
import type { SceneView } from '../../../src/scene';
import { makeView } from '../../readout/views';

describe('the size of the picture', () => {
  it.each([
    // Device pixels per CSS pixel, width, share of them that the machine keeps up with.
    [1, 1200, 1, 1],
    [1, 1200, 0.8, 0.8],
    [1, 1200, 0.5, 0.5],
    [1, 800, 0.5, 0.75],
    [1, 600, 0.5, 1],
    [1, 300, 0.5, 1],
    [3, 1200, 1, 2],
    [1.5, 1200, 0.8, 1.2],
  ])(
    'of %d device pixels, %d px wide, drawn with %d of them has a ratio of %d',
    (devicePixelRatio, width, share, ratio) => {
      expect(pixelRatioOf({ devicePixelRatio } as Window, width, share)).toBeCloseTo(ratio, 12);
    },
  );

  it('is read again when the canvas or the screen changes', () => {
    const queries: string[] = [];
    const heard: { listener: () => void; options: unknown }[] = [];
    let seen = 0;
    const canvas = {};
    const observed: unknown[] = [];
    class ResizeObserver {
      constructor(readonly changed: () => void) {}
      observe(element: unknown) {
        observed.push(element);
        this.changed();
      }
    }
    const window = {
      ...{ ResizeObserver, devicePixelRatio: 1 },
      matchMedia: (query: string) => {
        queries.push(query);
        return {
          addEventListener: (_: string, listener: () => void, options: unknown) =>
            heard.push({ listener, options }),
        };
      },
    };
    watchSize(window as unknown as Window & typeof globalThis, canvas as Element, () => (seen += 1));
    expect([observed, seen, queries]).toEqual([[canvas], 1, ['(resolution: 1dppx)']]);
    window.devicePixelRatio = 2;
    heard[0]!.listener();
    expect([seen, queries.at(-1), heard.length]).toEqual([2, '(resolution: 2dppx)', 2]);
    expect(heard.map(({ options }) => options)).toEqual([{ once: true }, { once: true }]);
  });
});

describe('the frame loop', () => {
  /** A page whose frames the test requests one by one. */
  function createPage(search = '', { hasScene = true } = {}) {
    const done: string[] = [];
    const state = { ready: true, loading: false, drawn: 0, share: false, seconds: 0 };
    let next: ((milliseconds: number) => void) | null = null;
    const window = { location: { search }, requestAnimationFrame: (frame: typeof next) => (next = frame) };
    const root = { dataset: {} as Record<string, string> };
    const sceneView = {
      draw: () => done.push(`draw ${String(++state.drawn)}`),
      // Of the second picture on: the first begins to build the ground.
      hasDrawn: () => state.drawn >= 2,
    };
    const loop = createFrameLoop(window as unknown as Window, root as unknown as HTMLElement, {
      sceneView: hasScene ? (sceneView as unknown as SceneView) : null,
      nextView: () => ({
        view: { ...makeView(), ready: state.ready, tick: state.seconds, sinceTick: 0 },
        now: 0,
      }),
      paint: (_view, _now, isFast) => done.push(isFast ? 'paint fast' : 'paint'),
      viewForScene: (view) => view,
      opened: () => done.push('opened'),
      isLoading: () => state.loading,
      resolution: { measure: (now) => (done.push(`measure ${String(now)}`), state.share), share: () => 1 },
      fit: () => done.push('fit'),
    });
    loop.start();
    const frame = (milliseconds: number) => {
      const drawn = next!;
      next = null;
      drawn(milliseconds);
      return done.splice(0);
    };
    return { frame, state, loop, root, isAsked: () => next !== null };
  }

  it('draws once to build the ground, opens when that is done, and is ready a frame later', () => {
    const { frame, state, loop, root } = createPage();
    state.ready = false;
    expect(frame(0)).toEqual(['paint']);
    state.ready = true;
    expect(frame(16)).toEqual(['paint fast', 'measure 0.016', 'draw 1']);
    expect([frame(40), loop.isWarm()]).toEqual([['paint fast', 'measure 0.04'], false]);
    state.drawn = 2;
    expect([frame(65), loop.isWarm()]).toEqual([['paint', 'measure 0.065', 'opened'], true]);
    expect(root.dataset).toEqual({});
    state.loading = true;
    frame(80);
    expect(root.dataset).toEqual({});
    state.loading = false;
    expect(frame(90)).toEqual(['paint fast', 'measure 0.09', 'draw 4']);
    expect(root.dataset).toEqual({ ready: 'true' });
  });

  it('fits the picture once after a resize, or when the pixel ratio changes', () => {
    const { frame, state, loop } = createPage();
    loop.resized();
    expect(frame(0)).toContain('fit');
    expect(frame(10)).not.toContain('fit');
    state.share = true;
    expect(frame(20)).toEqual(['paint fast', 'measure 0.02', 'fit']);
    state.ready = false;
    expect(frame(30)).toEqual(['paint fast']);
  });

  it('counts as warm at once without a picture', () => {
    const { frame, loop } = createPage('', { hasScene: false });
    expect([frame(0), loop.isWarm()]).toEqual([['paint', 'measure 0', 'opened'], true]);
  });

  it('stops at the game second of ?freeze=, unmeasured', () => {
    const { frame, state, root, isAsked } = createPage('?freeze=12');
    state.drawn = 2;
    frame(0);
    for (const seconds of [0, 11.9]) {
      state.seconds = seconds;
      expect(frame(10)).not.toContain('measure 0.01');
      expect([root.dataset, isAsked()]).toEqual([{}, true]);
    }
    state.seconds = 12;
    frame(20);
    expect([root.dataset, isAsked()]).toEqual([{ frozen: 'true', ready: 'true' }, true]);
    frame(30);
    expect(isAsked()).toBe(false);
  });
});

it('the camera key cycles through all views and names each', () => {
  const done: string[] = [];
  const scene = { setCamera: (view: string) => done.push(view) } as unknown as SceneView;
  const banner = { flash: (text: string) => done.push(text) };
  const next = createCameraSwitch(scene, banner as never);
  for (let i = 0; i < 6; i++) next();
  expect(done.filter((_, i) => i % 2 === 0)).toEqual([
    'chase',
    'cockpit',
    'above',
    'free',
    'follow',
    'chase',
  ]);
  expect(done[1]).toBe('Camera: behind the ship.');
  createCameraSwitch(null, banner as never)();
  expect(done.at(-1)).toBe('Camera: behind the ship.');
});
