/** Gamepads and thumbs: which of their movements count, and what they do. */
import { describe, expect, it, vi } from 'vitest';
import { all, createPage, fire, one } from '../../hud/pageInNode';
import { createGamepads, padName } from '../../../src/playground/input/gamepad';
import { createDeflection } from '../../../src/playground/input/stick';
import { createThumbs } from '../../../src/playground/input/thumbs';
import { send } from './events';

describe('a gamepad in the page', () => {
  const rest = { id: 'Pad', mapping: 'standard', axes: [0, 0, 0, 0], buttons: [] as object[] };
  const pressing = (...numbers: number[]) => ({
    ...rest,
    buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: numbers.includes(i), value: 0 })),
  });

  /** `plug` replaces what the browser returns; null forbids reading it. */
  function createPads() {
    let pads: readonly unknown[] | null = [];
    const reads = vi.fn(() => {
      if (pads === null) throw new Error('forbidden');
      return pads;
    });
    const window = Object.assign(new EventTarget(), { navigator: { getGamepads: reads } });
    const done: (string | null)[] = [];
    const deflection = createDeflection();
    const read = createGamepads(window as unknown as Window, () => deflection, {
      pressed: (action) => done.push(action),
      confirmed: () => done.push('confirmed'),
      changed: (name) => done.push(name),
    });
    const connect = () => send(window, 'gamepadconnected');
    return {
      read,
      reads,
      deflection,
      connect,
      plug: (next: typeof pads) => (pads = next),
      take: () => done.splice(0),
    };
  }

  it.each([
    ['Xbox 360 Controller (XInput STANDARD GAMEPAD)', 'Xbox 360 Controller'],
    ['045e-028e-Xbox 360 Controller', 'Xbox 360 Controller'],
    ['Pro Controller', 'Pro Controller'],
    ['(STANDARD GAMEPAD)', 'connected'],
    ['a'.repeat(50), 'a'.repeat(40)],
  ])('%s is %s by name', (id, name) => {
    expect(padName(id)).toBe(name);
  });

  it('is read only from its connection to its disconnection', () => {
    const { read, reads, connect, plug, take } = createPads();
    plug([rest]);
    expect([read(), reads.mock.calls.length]).toEqual([false, 0]);
    connect();
    plug([null, { ...rest, mapping: '', id: 'Wheel' }, rest]);
    read();
    read();
    expect([take(), reads.mock.calls.length]).toEqual([['Pad'], 2]);
    plug(null);
    expect(read()).toBe(false);
    expect(take()).toEqual([null]);
    read();
    expect([take(), reads.mock.calls.length]).toEqual([[], 3]);
    plug([rest]);
    connect();
    read();
    expect(take()).toEqual(['Pad']);
  });

  it('triggers a button’s action once per press', () => {
    const { read, connect, plug, take } = createPads();
    connect();
    plug([rest]);
    read();
    take();
    const actions: Record<number, (string | null)[]> = {};
    for (let i = 0; i < 17; i++) {
      for (const pad of [pressing(i), pressing(i), pressing()]) {
        plug([pad]);
        expect(read()).toBe(false);
      }
      actions[i] = take();
    }
    const named = Object.fromEntries(Object.entries(actions).filter(([, done]) => done.length > 0));
    expect(named).toEqual({
      0: ['confirmed'],
      1: ['throttleCut'],
      2: ['rateDamping'],
      3: ['autopilot'],
      8: ['restart'],
      9: ['pause'],
      12: ['modeUpright'],
      13: ['killRates'],
      14: ['modeRetrograde'],
      15: ['modeHold'],
    });
  });

  const analog = (held: number) =>
    Array.from({ length: 17 }, (_, k) => ({ pressed: false, value: k === held ? 1 : 0 }));

  it.each<readonly [moved: object, deflected: object]>([
    [{ axes: [0.58, 0, 0, 0] }, { tiltRight: 0.5 }],
    [{ axes: [0, 0.58, 0, 0] }, { tiltAway: -0.5 }],
    [{ axes: [0, 0, 0.58, 0] }, { pushRight: 0.5 }],
    [{ axes: [0, 0, 0, 0.58] }, { pushAway: -0.5 }],
    [{ buttons: analog(4) }, { turnLeft: 1 }],
    [{ buttons: analog(5) }, { turnLeft: -1 }],
    [{ buttons: analog(6) }, { lever: -1 }],
    [{ buttons: analog(7) }, { lever: 1 }],
    [{ buttons: analog(10) }, { pushUp: -1 }],
    [{ buttons: analog(11) }, { pushUp: 1 }],
  ])('of %o deflects %o, and leaves other sticks alone at rest', (moved, deflected) => {
    const { read, deflection, connect, plug } = createPads();
    connect();
    plug([{ ...rest, ...moved }]);
    expect(read()).toBe(true);
    expect(deflection).toEqual({ ...createDeflection(), ...deflected });
    plug([{ ...rest, axes: [0.15, -0.15, 0.1, 0, 1] }]);
    expect(read()).toBe(false);
    expect(deflection).toEqual(createDeflection());
    deflection.tiltAway = 0.3;
    read();
    expect(deflection.tiltAway).toBe(0.3);
  });
});

describe('the thumb sticks', () => {
  function createPads() {
    const { document, root } = createPage();
    const deflection = createDeflection();
    const done: unknown[] = [];
    const thumbs = createThumbs(root, {
      deflection: () => deflection,
      moved: () => done.push('moved'),
      lever: (throttle) => done.push(throttle),
      pressed: (action) => done.push(action),
    });
    const [tilt, lift, push] = all(root, 'thumb');
    const lever = one(root, 'input') as HTMLElement &
      Record<'min' | 'max' | 'step' | 'type' | 'value', string> & { valueAsNumber: number };
    return {
      document,
      root,
      deflection,
      thumbs,
      tilt: tilt!,
      lift: lift!,
      push: push!,
      lever,
      take: () => done.splice(0),
    };
  }
  const touch = (pad: HTMLElement, type: string, pointerId: number, clientX: number, clientY: number) => {
    Object.assign(pad, { setPointerCapture: () => undefined });
    fire(pad, type, { pointerId, clientX, clientY });
  };

  it('deflect by the thumb’s distance from its first touch, full at 44 px, in tenths', () => {
    const { tilt, lift, push, deflection, take } = createPads();
    touch(tilt, 'pointermove', 1, 44, 0);
    expect(take()).toEqual([]);
    touch(tilt, 'pointerdown', 1, 100, 100);
    touch(tilt, 'pointermove', 1, 100 + 22, 100 - 11);
    // 11 px are 0.25.
    expect([deflection.tiltRight, deflection.tiltAway, take()]).toEqual([0.5, 0.3, ['moved']]);
    expect(one(tilt, 'knob').style.translate).toBe('22px -11px');
    touch(tilt, 'pointermove', 1, 100 + 22.1, 100 - 11.1);
    expect(take()).toEqual([]);
    touch(tilt, 'pointermove', 2, 0, 0);
    touch(tilt, 'pointerdown', 2, 0, 0);
    expect([deflection.tiltRight, take()]).toEqual([0.5, []]);
    // Beyond the reach the direction counts: 3, 4 and 5.
    touch(tilt, 'pointermove', 1, 100 - 300, 100 + 400);
    expect([deflection.tiltRight, deflection.tiltAway]).toEqual([-0.6, -0.8]);
    const place = one(tilt, 'knob').style.translate.split('px');
    expect(place.map((part) => Number(part).toFixed(3))).toEqual(['-26.400', '35.200', '0.000']);
    touch(tilt, 'pointerup', 2, 0, 0);
    expect(deflection.tiltRight).toBe(-0.6);
    touch(tilt, 'pointerup', 1, 0, 0);
    expect(deflection).toEqual(createDeflection());
    touch(push, 'pointerdown', 1, 0, 0);
    touch(push, 'pointermove', 1, 44, -44);
    expect([deflection.pushRight, deflection.pushAway, deflection.tiltRight]).toEqual([0.7, 0.7, 0]);
    touch(push, 'lostpointercapture', 1, 0, 0);
    expect(deflection).toEqual(createDeflection());
    touch(lift, 'pointerdown', 1, 0, 0);
    touch(lift, 'pointermove', 1, 0, 22);
    expect(deflection).toEqual({ ...createDeflection(), pushUp: -0.5 });
    touch(lift, 'pointercancel', 1, 0, 0);
    expect(deflection).toEqual(createDeflection());
  });

  it('have a lever at the square root of the throttle, with the hover throttle marked', () => {
    const { document, root, lever, thumbs, take } = createPads();
    expect([lever.min, lever.max, lever.step, lever.type]).toEqual(['0', '100', '0.5', 'range']);
    lever.valueAsNumber = 50;
    fire(lever, 'input');
    expect(take()).toEqual([0.25]);
    const words = () => one(one(root, 'thumb-lever'), 'span').textContent;
    thumbs.show(0.25, 0.1);
    expect([words(), lever.getAttribute('aria-valuetext'), lever.value]).toEqual([
      ...['Engine 25 %, hover 10 %', 'Engine 25 %, hover 10 %', '50'],
    ]);
    thumbs.show(0.25, NaN);
    expect(words()).toBe('Engine 25 %');
    // A lever that a finger holds is not moved by its own rounding.
    Object.assign(document, { activeElement: lever });
    lever.valueAsNumber = 49;
    lever.value = 'held';
    thumbs.show(0.25, 0.2);
    expect([words(), lever.value]).toEqual(['Engine 25 %, hover 20 %', 'held']);
    thumbs.show(0.36, 0.2);
    expect([words(), lever.value]).toEqual(['Engine 36 %, hover 20 %', '60']);
    lever.value = 'kept';
    thumbs.show(0.361, 0.2);
    expect(lever.value).toBe('kept');
  });

  it('have buttons for the engine and the modes, which show what is on', () => {
    const { root, take, thumbs } = createPads();
    const pressed = () => all(root, 'button').map((button) => button.getAttribute('aria-pressed'));
    for (const mode of ['rateDamping', 'modeUpright', 'autopilot'] as const)
      thumbs.mark(mode, mode === 'modeUpright');
    expect(pressed()).toEqual([null, 'false', 'true', 'false']);
    const buttons = all(root, 'button').map((button) => {
      fire(button, 'click');
      return [button.textContent, take()];
    });
    expect(buttons).toEqual([
      ['Cut', ['throttleCut']],
      ['Damping', ['rateDamping']],
      ['Upright', ['modeUpright']],
      ['Auto', ['autopilot']],
    ]);
  });
});
