import { describe, expect, it } from 'vitest';
import {
  createEase,
  type Ease,
  advanceEase,
  restartEase,
  springsOf,
} from '../../../src/prediction/drawn/ease';
import type { ServerFrame } from '../../../src/wire';
import type { Vec3 } from '../../../src/dynamics';
import { createRig } from '../rig';
import { angleBetween, distance } from '../samples';

const UP = Float64Array.of(0, 0, 1);

function corrected(offset: readonly number[], turn: readonly number[] = [0, 0, 0]): Ease {
  const ease = createEase();
  ease.offset.set(offset);
  ease.turn.set(turn);
  restartEase(ease);
  return ease;
}

function run(ease: Ease, seconds: number, hz: number, springs = springsOf()): number[][] {
  const path = [[...ease.offset, ...ease.turn]];
  for (let i = 0; i < Math.round(seconds * hz); i++) {
    advanceEase(ease, UP, 1 / hz, springs);
    path.push([...ease.offset, ...ease.turn]);
  }
  return path;
}

const raised = ([x, y, z]: Vec3): Vec3 => [x, y + 2, z];

/** The same frame with each ship 2 m off. */
function shifted(frame: ServerFrame): ServerFrame {
  const ships = frame.ships.map((ship) => ({
    ...ship,
    position: raised(ship.position),
    relativePosition: raised(ship.relativePosition!),
  }));
  return { ...frame, ships };
}

const size = (v: readonly number[]) => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));

describe('the drawn offset', () => {
  it.each([1, 0.5, 3])(
    'follows a critically damped spring while it is slow, settling in %d times the usual',
    (times) => {
      const springs = springsOf({ alongGround: 0.3 * times, alongNormal: 0.15 * times, angle: 0.25 * times });
      const ease = corrected([1e-3, -2e-3, 3e-3], [2e-3, 0, -1e-3]);
      for (const share of [0.2, 0.5, 1]) {
        const before = share === 0.2 ? 0 : share === 0.5 ? 0.2 : 0.5;
        advanceEase(ease, UP, 0.15 * times * (share - before), springs);
        const t = 0.15 * share;
        // x (1 + w t) e^(−w t), and its rate −x w² t e^(−w t), in units of the usual time.
        const left = (w: number) => (1 + w * t) * Math.exp(-w * t);
        const rate = (w: number) => (-w * w * t * Math.exp(-w * t)) / times;
        const along = (of: (w: number) => number) => [1e-3 * of(20), -2e-3 * of(20), 3e-3 * of(60)];
        for (const [k, x] of along(left).entries()) expect(ease.offset[k]).toBeCloseTo(x, 12);
        for (const [k, x] of along(rate).entries()) expect(ease.rate[k]).toBeCloseTo(x, 12);
        for (const [k, x] of [2e-3, 0, -1e-3].entries()) {
          expect(ease.turn[k]).toBeCloseTo(x * left(30), 12);
          expect(ease.turnRate[k]).toBeCloseTo(x * rate(30), 12);
        }
      }
    },
  );

  it.each([
    { what: 'a small offset', offset: [0, 0, 0.2], fastest: 1.15 },
    { what: 'a large one', offset: [0, 5, 0], fastest: 22 },
    { what: 'a small turn', turn: [0.08, 0, 0], fastest: 0.47 },
    { what: 'a large one', turn: [0, 0, 0.8], fastest: 3.52 },
    { what: 'an offset in half the time', offset: [5, 0, 0], given: { alongGround: 0.15 }, fastest: 46.2 },
    { what: 'in a third of the time', offset: [0, 0, 5], given: { alongNormal: 0.05 }, fastest: 69.3 },
    { what: 'a turn in half the time', turn: [0, 0.8, 0], given: { angle: 0.125 }, fastest: 7.392 },
  ])('is no faster than its cap: $what', ({ offset = [0, 0, 0], turn, given, fastest }) => {
    const path = run(corrected(offset, turn), 0.3, 960, springsOf(given));
    const speeds = path.slice(1).map((p, i) => size(p.map((x, k) => x - path[i]![k]!)) * 960);
    expect(Math.max(...speeds)).toBeCloseTo(fastest, 6);
  });

  it('does not change while no time passes, and is cleared after more than 2 s or once negligible', () => {
    const after = (seconds: number, offset: number, given = {}) => {
      const ease = corrected([offset, 0, 0], [0, 0, offset]);
      advanceEase(ease, UP, seconds, springsOf(given));
      return [ease.offset[0], ease.turn[2], ease.active, ease.size];
    };
    for (const seconds of [0, -1, Number.NaN]) expect(after(seconds, 1e-3)).toEqual([1e-3, 1e-3, true, 1e-3]);
    const slow = { alongGround: 2, angle: 2 };
    expect(after(2, 1e-3, slow).slice(2)).toEqual([true, 1e-3]);
    expect(after(2.001, 1e-3, slow)).toEqual([0, 0, false, 0]);
    // At 3 s⁻¹ (1 + 3) e^−3 = 0.2 of each is left after 1 s, and rates of 3² e^−3 = 0.45 and, at 3.75 s⁻¹, 0.33.
    expect(after(1, 1.1e-9, slow)[2]).toBe(true);
    expect(after(1, 0.8e-9, slow)[2]).toBe(false);
  });

  it('is within 5 % after 300 ms along the ground and 250 ms in angle', () => {
    for (const metres of [0.01, 0.3, 2, 20]) {
      const ease = corrected([metres, 0, 0]);
      run(ease, 0.3, 60);
      expect(size([...ease.offset])).toBeLessThan(0.05 * metres);
    }
    for (const radians of [0.01, 0.3, 1]) {
      const ease = corrected([0, 0, 0], [0, radians, 0]);
      run(ease, 0.25, 60);
      expect(size([...ease.turn])).toBeLessThan(0.05 * radians);
    }
  });

  it('is within 5 % after 150 ms along the normal up to 15 cm, and after 240 ms beyond', () => {
    const small = corrected([0, 0, 0.15]);
    run(small, 0.15, 60);
    expect(size([...small.offset])).toBeLessThan(0.05 * 0.15);
    const large = corrected([0, 0, 3]);
    run(large, 0.24, 120);
    expect(size([...large.offset])).toBeLessThan(0.05 * 3);
  });

  it.each([0.1, 0.2, 0.3, 1, 2])('settles within the configured times: %s s', (settle) => {
    const springs = springsOf({ alongGround: settle, alongNormal: settle, angle: settle });
    const ease = corrected([0.15, 0, 0.1], [0.2, 0, 0]);
    const before = size([0.15, 0.1]);
    run(ease, settle / 4, 240, springs);
    expect(size([...ease.offset])).toBeGreaterThan(0.05 * before);
    run(ease, settle * 0.75, 240, springs);
    expect(size([...ease.offset])).toBeLessThan(0.05 * before);
    expect(size([...ease.turn])).toBeLessThan(0.05 * 0.2);
  });

  it('fades in the drawn pose as the option says', () => {
    /** The largest offset 0.4 s after a state 2 m off. */
    const left = (settle: number): number => {
      const smoothing = { alongGround: settle, alongNormal: settle };
      const rig = createRig({ scenario: 'opening', predictor: { smoothing } });
      rig.tamper = (message) => [message.kind === 'frame' && message.tick >= 1 ? shifted(message) : message];
      let largest = 0;
      let came = Number.NaN;
      let last = 0;
      rig.fly(2, ({ diagnosis }) => {
        if (!(rig.now > came + 0.4)) last = diagnosis.offsetPosition;
        if (diagnosis.offsetPosition > 1 && Number.isNaN(came)) came = rig.now;
        largest = Math.max(largest, diagnosis.offsetPosition);
      });
      expect(largest).toBeGreaterThan(1);
      return last / largest;
    };
    expect(left(2)).toBeGreaterThan(0.5);
    expect(left(0.3)).toBeLessThan(0.05);
  });

  it.each([30, 60, 144])('moves by at most 8 % of the correction or 2 cm in 1/60 s, at %i Hz', (hz) => {
    for (const metres of [0.05, 0.5, 5, 24]) {
      const path = run(corrected([metres * 0.6, 0, metres * 0.8]), 0.6, hz);
      const steps = path.slice(1).map((p, i) => distance(p, path[i]!) * (hz / 60));
      expect(Math.max(...steps)).toBeLessThanOrEqual(Math.max(0.02, 0.08 * metres));
    }
  });

  it('starts without a jump in rate and never changes side', () => {
    const path = run(corrected([1, 0, 0]), 1, 240).map(([x]) => x!);
    expect(path[0]! - path[1]!).toBeLessThan(0.005);
    expect(Math.min(...path)).toBeGreaterThanOrEqual(-1e-9);
  });

  it('follows the same path at any frame rate', () => {
    const at = (hz: number) => {
      const ease = corrected([1, 0.5, -2], [0.2, 0, 0.1]);
      run(ease, 0.2, hz);
      return [...ease.offset, ...ease.turn];
    };
    const [coarse, fine] = [at(20), at(240)];
    for (const [k, value] of coarse.entries()) expect(value).toBeCloseTo(fine[k]!, 9);
  });

  it('takes a second correction during the first without a jump in rate', () => {
    const ease = corrected([1, 0, 0]);
    run(ease, 0.1, 60);
    const rate = [...ease.rate];
    ease.offset[1] = ease.offset[1]! + 0.5;
    restartEase(ease);
    expect([...ease.rate]).toEqual(rate);
    advanceEase(ease, UP, 1 / 240, springsOf());
    expect(Math.abs(ease.rate[1]!)).toBeLessThan(1);
  });

  it('also eases the law’s own uprighting, which is not counted as an error', () => {
    const rig = createRig({ scenario: 'opening' });
    let touched = Number.NaN;
    let largest = 0;
    let before: number[] | null = null;
    let tiltLeft = 0;
    rig.fly(3, ({ own }) => {
      if (own === null) return;
      const drawn = [...own.meshAttitude];
      if (Number.isNaN(touched) && own.surfaceContactState === 'contact') {
        touched = rig.now;
        tiltLeft = angleBetween(drawn, [...own.attitude]);
      }
      if (before !== null) largest = Math.max(largest, angleBetween(before, drawn));
      before = drawn;
    });
    expect(tiltLeft).toBeGreaterThan(0.1);
    // 8° of uprighting at once would be 0.14 rad; eased, 8 % of it and the spin before.
    expect(largest).toBeLessThan(0.08 * 0.16 + 0.003);
    expect(rig.view().diagnosis.correctionsMismatch).toBe(0);
    expect(rig.view().diagnosis.snaps).toBe(0);
  });
});
