/** Ships that are not predicted: interpolated, or held at the newest server state. */
import { describe, expect, it } from 'vitest';
import { POSITION } from '../../../src/dynamics';
import type { ShipView } from '../../../src/prediction';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import { createRig } from '../rig';
import { rowAt } from '../truth';

const SHIP = 'ship-1';
const distance = (a: ArrayLike<number>, b: ArrayLike<number>) =>
  Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
/** The height above the body's centre, m. */
const radius = ({ position }: ShipView) => Math.hypot(...position);

/** The bounce at `tickRate`, its ship under `policy` from the start. */
function flown(policy: 'interpolate' | 'hold', tickRate: number) {
  const rig = createRig({ scenario: 'bounce', tickRate, network: NETWORK_PRESETS.lan });
  rig.predictor.setPolicy(SHIP, policy);
  rig.fly(2);
  return rig;
}

describe('policy hold', () => {
  it('shows the newest server state, turning with its body, as confirmed', () => {
    const rig = flown('hold', 5);
    let told = 0;
    rig.fly(3, ({ own }) => {
      const { serverPosition, position, provenance } = own!;
      // The Moon's ground moves at 4.6 m/s, for at most a send interval and the lead.
      expect(distance(serverPosition, position)).toBeLessThan(2);
      expect(Math.abs(radius(own!) - Math.hypot(...serverPosition))).toBeLessThan(1e-6);
      expect(provenance).toBe('confirmed');
      told += 1;
    });
    expect(told).toBeGreaterThan(100);
    expect(rig.notices.filter(({ kind }) => kind === 'predicted')).toEqual([]);
    expect(rig.view().diagnosis.steppedSubsteps).toBe(0);
  });
});

describe('policy interpolate', () => {
  it.each([1, 5, 20])('at %d Hz stays on the server’s trajectory, at most two sends behind', (rate) => {
    const rig = flown('interpolate', rate);
    rig.fly(1);
    let worst = 0;
    let seen = 0;
    let checked = 0;
    rig.fly(2.5, ({ own, tick, sinceTick }) => {
      seen += 1;
      if (seen % 4 > 0 || own!.surfaceContactState !== '') return;
      // The true height at any instant of the last two send intervals.
      const present = tick / rate + sinceTick;
      let nearest = Infinity;
      for (let back = 0; back <= 2 / rate + 0.3; back += 0.005) {
        const off = Math.abs(radius(own!) - truthRadius(rig, present - back));
        if (off < nearest) nearest = off;
      }
      worst = Math.max(worst, nearest);
      checked += 1;
    });
    expect(checked).toBeGreaterThan(5);
    expect(worst).toBeLessThan(0.05);
  });

  it('moves from frame to frame at its velocity', () => {
    const rig = flown('interpolate', 5);
    rig.fly(1);
    let before: ShipView | null = null;
    let place: number[] = [];
    let checked = 0;
    rig.fly(1.5, ({ own }) => {
      if (before !== null && own!.surfaceContactState === '') {
        const moved = distance(own!.position, place);
        const speed = Math.hypot(...own!.velocity);
        expect(Math.abs(moved * 60 - speed)).toBeLessThan(0.35 + speed * 0.1);
        checked += 1;
      }
      before = own;
      place = [...own!.position];
    });
    expect(checked).toBeGreaterThan(30);
  });
});

describe('a change of policy', () => {
  it.each([
    ['interpolate', 'predict'],
    ['hold', 'predict'],
    ['predict', 'interpolate'],
    ['predict', 'hold'],
  ] as const)('from %s to %s causes no jump of the drawn ship', (from, to) => {
    const rig = createRig({ scenario: 'bounce', tickRate: 10, network: NETWORK_PRESETS.lan });
    rig.predictor.setPolicy(SHIP, from);
    rig.fly(2);
    let place = [...rig.view().own!.easedPosition];
    rig.predictor.setPolicy(SHIP, to);
    for (let i = 0; i < 6; i++) {
      const { easedPosition, velocity } = rig.frame().own!;
      const step = to === 'hold' || from === 'hold' ? 0.1 : 1 / 60;
      // Its motion in a frame (or in a send interval, on hold), and the largest step of a correction.
      expect(distance(place, easedPosition)).toBeLessThan(Math.hypot(...velocity) * step * 1.2 + 0.3);
      place = [...easedPosition];
    }
    rig.fly(25);
    expect([rig.view().own!.shownState, rig.view().own!.provenance]).toEqual(['landed', 'confirmed']);
    expect(rig.view().diagnosis.correctionsMismatch).toBe(0);
  });

  it('before the ship exists applies once it appears, also after a reset', () => {
    const rig = flown('hold', 5);
    rig.predictor.reset();
    rig.fly(3);
    expect(rig.view().diagnosis.steppedSubsteps).toBe(0);
    expect(rig.predictor.snapshot(rig.now).policies).toEqual({ [SHIP]: 'hold' });
  });

  it('keeps the pending inputs of the player’s ship', () => {
    const rig = flown('interpolate', 5);
    rig.fly(2);
    expect(rig.sentInputs.length).toBeGreaterThan(0);
  });
});

/** The simulated distance from the body's centre at game second `game`, from the server's rows. */
function truthRadius(rig: ReturnType<typeof createRig>, game: number): number {
  const { tickRate } = rig.view();
  const tick = Math.floor(game * tickRate + 1e-9);
  const interval = rig.truth.interval(tick);
  if (interval === undefined) return Number.NaN;
  const { timing, shipIds } = interval;
  const substeps = Math.min(timing.substeps, (game - tick / tickRate) / timing.dt);
  const before = Math.min(timing.substeps - 1, Math.floor(substeps));
  const radiusAt = (boundary: number) =>
    Math.hypot(...rowAt(interval, boundary, shipIds.indexOf(SHIP)).subarray(POSITION, POSITION + 3));
  const [a, b] = [radiusAt(before), radiusAt(before + 1)];
  return a + (b - a) * (substeps - before);
}
