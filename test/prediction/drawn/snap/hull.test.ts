import { describe, expect, it } from 'vitest';
import { loadShipClass, SHIP_CLASSES } from '../../../../src/dynamics';
import { hullOf, LEGS } from '../../../../src/prediction';
import { value } from '../../rig';

const shipClass = value(loadShipClass(SHIP_CLASSES.find(({ name }) => name === 'planetary_lander')!));
const hull = hullOf(shipClass);
const h = shipClass.groundContactOffset;

describe('the hull of a ship with its own contact offset', () => {
  it.each([0, 2.5, 7])('of %f m has its feet there and keeps the class’s shape', (own) => {
    const moved = hullOf(shipClass, own);
    for (let leg = 0; leg < LEGS; leg++) expect(moved.feet[leg * 3 + 2]).toBe(-own);
    for (let i = 2; i < hull.outline.length; i += 3)
      expect(moved.outline[i]! - hull.outline[i]!).toBeCloseTo(h - own, 12);
    expect(hullOf(shipClass, own)).toBe(moved);
  });

  it('stands on its legs’ circle at 45° to its axes, under a cylinder of half its height’s radius', () => {
    const polar = (points: Float64Array, i: number) => {
      const [x, y, z] = points.subarray(i * 3, i * 3 + 3) as unknown as [number, number, number];
      return [Math.sqrt(x * x + y * y), ((Math.atan2(y, x) * 180) / Math.PI + 360) % 360, z];
    };
    const expectAt = (points: Float64Array, i: number, place: readonly number[]) => {
      for (const [k, x] of polar(points, i).entries()) expect(x).toBeCloseTo(place[k]!, 9);
    };
    expect([hull.feet.length, hull.outline.length]).toEqual([12, 48]);
    for (let i = 0; i < 4; i++) expectAt(hull.feet, i, [shipClass.legRadius, 45 + 90 * i, -h]);
    for (let i = 0; i < 8; i++) {
      expectAt(hull.outline, i, [h / 2, 22.5 + 45 * i, -0.6 * h]);
      expectAt(hull.outline, i + 8, [h / 2, 22.5 + 45 * i, h]);
    }
    expect(hull.stroke).toBeCloseTo(0.2 * h, 12);
  });

  it('is kept for the last 16 offsets of a class', () => {
    const another = { ...shipClass };
    const first = hullOf(another, 100);
    for (let i = 1; i < 16; i++) hullOf(another, 100 + i);
    expect(hullOf(another, 100)).toBe(first);
    hullOf(another, 116);
    expect(hullOf(another, 100)).not.toBe(first);
  });

  it('differs from the class’s hull', () => {
    expect(hullOf(shipClass, h)).toBe(hull);
    expect(hullOf(shipClass, h + 1)).not.toBe(hull);
  });
});
