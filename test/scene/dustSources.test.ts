import { describe, expect, it } from 'vitest';
import type { Dust } from '../../src/scene/effects/dust';
import { createDustState, type DustyShip, raiseDust } from '../../src/scene/effects/dustSources';

interface Grain {
  readonly place: number[];
  readonly velocity: number[];
}

function counted(): { dust: Dust; grains: Grain[] } {
  const grains: Grain[] = [];
  const dust = {
    throwGrain: (place: ArrayLike<number>, velocity: ArrayLike<number>) =>
      grains.push({ place: Array.from(place), velocity: Array.from(velocity) }),
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
