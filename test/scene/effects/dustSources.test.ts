import { describe, expect, it } from 'vitest';
import type { Dust, GrainLook } from '../../../src/scene/effects/dust';
import { createDustState, type DustyShip, raiseDust } from '../../../src/scene/effects/dustSources';

interface Grain {
  readonly place: number[];
  readonly velocity: number[];
  readonly look: GrainLook;
}

function counted(): { dust: Dust; grains: Grain[] } {
  const grains: Grain[] = [];
  const dust = {
    throwGrain: (place: ArrayLike<number>, velocity: ArrayLike<number>, look: GrainLook) =>
      grains.push({ place: Array.from(place), velocity: Array.from(velocity), look }),
  } as unknown as Dust;
  return { dust, grains };
}

const FLYING: DustyShip = {
  place: Float64Array.of(100, 14, -50),
  velocity: new Float64Array(3),
  groundY: 10,
  feetHeight: 0,
  legRadius: 3,
  grounded: false,
  impactSpeed: 0,
  thrust: 0,
  blows: Float64Array.of(0, -1, 0),
};

describe('dust', () => {
  it('is emitted once at a touch, from the feet, more and faster for a harder touch', () => {
    const thrown = [2, 12].map((impactSpeed) => {
      const { dust, grains } = counted();
      const state = createDustState();
      raiseDust(dust, state, FLYING, 1 / 60);
      expect(grains).toHaveLength(0);
      const touching = { ...FLYING, grounded: true, impactSpeed };
      for (let n = 0; n < 10; n++) raiseDust(dust, state, touching, 1 / 60);
      for (const { place, velocity } of grains) {
        const radius = Math.hypot(place[0]! - 100, place[2]! + 50);
        expect(Math.abs(radius - 3)).toBeLessThan(0.4);
        expect(place[1]! - 10).toBeGreaterThan(0);
        expect(velocity[1]).toBeGreaterThan(0);
      }
      const fastest = Math.max(...grains.map(({ velocity }) => Math.hypot(...velocity)));
      return { count: grains.length, fastest };
    });
    expect(thrown[1]!.count).toBeGreaterThan(thrown[0]!.count + 50);
    expect(thrown[1]!.fastest).toBeGreaterThan(4 * thrown[0]!.fastest);
  });

  it('is emitted along a slide, forward, as much in few frames as in many, and ends with it', () => {
    const ploughed = [10, 60].map((hz) => {
      const { dust, grains } = counted();
      const state = createDustState();
      const sliding = { ...FLYING, grounded: true, velocity: Float64Array.of(8, 0, 0) };
      for (let n = 0; n < hz; n++) raiseDust(dust, state, sliding, 1 / hz);
      for (const { velocity } of grains) expect(velocity[0]).toBeGreaterThan(0);
      const before = grains.length;
      raiseDust(dust, state, { ...sliding, velocity: Float64Array.of(0.3, 0, 0) }, 1);
      expect(grains).toHaveLength(before);
      return before;
    });
    expect(ploughed[0]).toBeGreaterThan(80);
    expect(Math.abs(ploughed[1]! - ploughed[0]!)).toBeLessThanOrEqual(1);
  });

  it('is blown outward where the exhaust meets the ground, and not from high above', () => {
    const { dust, grains } = counted();
    const burning = { ...FLYING, thrust: 45_000 };
    raiseDust(dust, createDustState(), burning, 0.5);
    expect(grains.length).toBeGreaterThan(10);
    for (const { place, velocity } of grains)
      expect((place[0]! - 100) * velocity[0]! + (place[2]! + 50) * velocity[2]!).toBeGreaterThan(0);
    const before = grains.length;
    raiseDust(dust, createDustState(), { ...burning, place: Float64Array.of(100, 400, -50) }, 0.5);
    expect(grains).toHaveLength(before);
  });
});

/** The range of a quantity over many grains: within these bounds, and near both. */
function expectRange(what: string, values: readonly number[], low: number, high: number): void {
  const [least, most, slack] = [Math.min(...values), Math.max(...values), 0.1 * (high - low)];
  expect(least, `least ${what}`).toBeGreaterThan(low - 1e-9);
  expect(least, `least ${what}`).toBeLessThan(low + slack);
  expect(most, `largest ${what}`).toBeLessThan(high + 1e-9);
  expect(most, `largest ${what}`).toBeGreaterThan(high - slack);
}

/** All grains of `seconds` of a ship, in frames of 1/60 s after it flew. */
function raised(ship: Partial<DustyShip>, seconds = 1 / 60): Grain[] {
  const { dust, grains } = counted();
  const state = createDustState();
  raiseDust(dust, state, { ...FLYING, thrust: 0 }, 1 / 60);
  for (let n = 0; n < Math.round(seconds * 60); n++) raiseDust(dust, state, { ...FLYING, ...ship }, 1 / 60);
  return grains;
}

describe('a grain', () => {
  it('of a touch is thrown from a foot, outward by the speed of the touch, and drifts with the ship', () => {
    const drifting = raised({ grounded: true, velocity: Float64Array.of(0.4, -3, -0.2) });
    expect(drifting).toHaveLength(40);
    for (const { velocity } of drifting)
      expect(velocity).toEqual([expect.closeTo(0.1, 9), 0, expect.closeTo(-0.05, 9)]);
    for (const [impactSpeed, hard] of [
      [20, 20],
      [90, 40],
    ] as const) {
      const grains = raised({ grounded: true, impactSpeed });
      expect(grains).toHaveLength(40 + 11 * hard);
      const of = (measure: (grain: Grain) => number) => grains.map(measure);
      expectRange(
        'speed outward',
        of(({ velocity: [x, , z] }) => Math.hypot(x!, z!)),
        0.12 * hard,
        0.62 * hard,
      );
      expectRange(
        'speed up',
        of(({ velocity }) => velocity[1]!),
        0.03 * hard,
        0.25 * hard,
      );
      expectRange(
        'direction',
        of(({ velocity: [x, , z] }) => Math.atan2(z!, x!)),
        -Math.PI,
        Math.PI,
      );
      expectRange(
        'way from the centre',
        of(({ place: [x, , z] }) => Math.hypot(x! - 100, z! + 50)),
        2.7,
        3.3,
      );
      expectRange(
        'lifetime',
        of(({ look }) => look.seconds),
        2.2,
        4.6,
      );
      expectRange(
        'size',
        of(({ look }) => look.size),
        0.5,
        0.5 + 0.022 * hard,
      );
      // Four feet between the axes, each a quarter of them.
      const feet = of(({ place: [x, , z] }) => Math.floor(Math.atan2(z! + 50, x! - 100) / (Math.PI / 2)));
      for (const foot of [-2, -1, 0, 1])
        expect(feet.filter((each) => each === foot).length).toBe(grains.length / 4);
      const off = of(({ place: [x, , z] }) => {
        const angle = Math.atan2(z! + 50, x! - 100);
        return angle - (Math.floor(angle / (Math.PI / 2)) + 0.5) * (Math.PI / 2);
      });
      expectRange('angle from the foot', off, -0.25, 0.25);
      expect(new Set(of(({ place }) => place[1]!))).toEqual(new Set([10.08]));
      expect(new Set(of(({ look }) => look.opacity))).toEqual(new Set([0.75]));
    }
  });

  it('of a slide goes along with the ship and aside, more the faster it slides', () => {
    for (const [vx, vz, perSecond] of [
      [3, -4, 90],
      [-15, 20, 260],
    ] as const) {
      const speed = Math.hypot(vx, vz);
      const all = raised({ grounded: true, velocity: Float64Array.of(vx, 0, vz) }, 5);
      const grains = all.slice(40);
      expect(Math.abs(grains.length - 5 * perSecond)).toBeLessThanOrEqual(1);
      const of = (measure: (grain: Grain) => number) => grains.map(measure);
      const along = ({ velocity: [x, , z] }: Grain) => (x! * vx + z! * vz) / speed;
      expectRange('speed along', of(along), 0.2 * speed, 0.95 * speed);
      const aside = ({ velocity: [x, , z] }: Grain) => (z! * vx - x! * vz) / speed;
      expectRange('speed aside', of(aside), -0.55 * speed, 0.55 * speed);
      expectRange(
        'speed up',
        of(({ velocity }) => velocity[1]!),
        0.04 * speed,
        0.24 * speed,
      );
      expectRange(
        'lifetime',
        of(({ look }) => look.seconds),
        1.8,
        3.4,
      );
      expect(new Set(grains.map(({ look }) => `${String(look.size)} ${String(look.opacity)}`))).toEqual(
        new Set(['1.1 0.75']),
      );
    }
    expect(raised({ grounded: true, velocity: Float64Array.of(0.6, 0, 0) }, 1)).toHaveLength(40);
  });

  it('of the exhaust is blown outward from where that meets the ground, weaker with height', () => {
    const blow = (height: number, thrust: number, blows = FLYING.blows) =>
      raised({ place: Float64Array.of(100, 10 + height, -50), thrust, blows }, 4);
    // 16 m above the ground and lower it has its full strength, of an engine of 150 kN 280 a second, but 220 at most.
    expect(blow(16, 75e3).length).toBeCloseTo(4 * 140, -0.5);
    expect(blow(8, 75e3).length).toBeCloseTo(4 * 140, -0.5);
    expect(blow(32, 75e3).length).toBeCloseTo(4 * 35, -0.5);
    expect(blow(8, 150e3).length).toBeCloseTo(4 * 220, -0.5);
    expect([blow(16, 0.029 * 150e3), blow(16, 0.03 * 150e3 + 1).length > 25]).toEqual([[], true]);
    expect(blow(16, 75e3, Float64Array.of(0.96, -0.28, 0))).toEqual([]);
    const grains = blow(12, 75e3, Float64Array.of(0.36, -0.8, -0.48));
    const of = (measure: (grain: Grain) => number) => grains.map(measure);
    // 12 m down along the exhaust: 15 m of it, so 5.4 m and −7.2 m aside.
    const away = ({ place: [x, , z] }: Grain) => Math.hypot(x! - 105.4, z! + 57.2);
    expectRange('way from the middle', of(away), 0.6, 0.6 + 1 + 0.15 * 12);
    expectRange(
      'speed outward',
      of(({ velocity: [x, , z] }) => Math.hypot(x!, z!)),
      9 * 0.8,
      25 * 0.8,
    );
    const steepness = of(({ velocity: [x, y, z] }) => y! / Math.hypot(x!, z!));
    expectRange('steepness', steepness, 0.03, 0.15);
    for (const {
      place: [x, y, z],
      velocity: [vx, , vz],
    } of grains) {
      expect(y).toBe(10.1);
      const [outX, outZ] = [x! - 105.4, z! + 57.2];
      expect((outX * vx! + outZ * vz!) / (Math.hypot(outX, outZ) * Math.hypot(vx!, vz!))).toBeCloseTo(1, 9);
    }
    expectRange(
      'lifetime',
      of(({ look }) => look.seconds),
      1.1,
      2.1,
    );
    expect(new Set(grains.map(({ look }) => `${String(look.size)} ${String(look.opacity)}`))).toEqual(
      new Set(['1.4 0.62']),
    );
  });
});
