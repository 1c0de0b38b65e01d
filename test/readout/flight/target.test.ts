import { describe, expect, it } from 'vitest';
import { createLandingAids, createTargetReadout, updateTargetReadout } from '../../../src/readout';
import { makeView, NORMAL } from '../views';

describe('the beacon', () => {
  it('is given to the right and ahead in the screen’s axes, and the miss is measured from it', () => {
    const view = makeView({ clearance: 80 });
    const right = Float64Array.of(0.8, 0, -0.36);
    const length = Math.hypot(...right);
    for (let k = 0; k < 3; k++) right[k] = right[k]! / length;
    const [nx, ny, nz] = NORMAL;
    const away = [
      ny * right[2]! - nz * right[1]!,
      nz * right[0]! - nx * right[2]!,
      nx * right[1]! - ny * right[0]!,
    ];
    const screen = Float64Array.from([...right, ...away, ...NORMAL]);
    const ground = view.own.groundRadius;
    const place = Float64Array.from(
      [0, 1, 2].map((k) => NORMAL[k]! * ground + right[k]! * 30 - away[k]! * 40),
    );
    const aids = createLandingAids();
    aids.outcome = 'touch';
    aids.touchPlace.set(place);
    aids.touchPlace[0] = place[0]! + right[0]! * 5;
    aids.touchPlace[1] = place[1]! + right[1]! * 5;
    aids.touchPlace[2] = place[2]! + right[2]! * 5;
    const out = updateTargetReadout(createTargetReadout(), view, { place, radius: 20 }, screen, aids);
    expect([out.x, out.y]).toEqual([expect.closeTo(30, 3), expect.closeTo(-40, 3)]);
    expect(out.distance).toBeCloseTo(50, 3);
    expect([out.missX, out.missY]).toEqual([expect.closeTo(5, 3), expect.closeTo(0, 3)]);
    expect(out.scale).toBe(100);
    const scaleAt = (metres: number, radius = 1) => {
      const far = place.map((_, k) => view.own.position[k]! + right[k]! * metres);
      return updateTargetReadout(createTargetReadout(), view, { place: far, radius }, screen, aids).scale;
    };
    const scales = [10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 50_000];
    // The target stays a tenth off the rim.
    expect(scales.map((scale) => scaleAt(0.909 * scale))).toEqual(scales);
    expect(scales.map((scale) => scaleAt(0.91 * scale))).toEqual([...scales.slice(1), 50_000]);
    expect(scaleAt(0, 15)).toBe(20);
    const moving = makeView({ clearance: 80, east: 3, north: -2, up: -1 });
    const drifting = updateTargetReadout(
      createTargetReadout(),
      moving,
      { place, radius: 20 },
      screen,
      createLandingAids(),
    );
    const speed = moving.own.velocity.map((v, k) => v - view.own.velocity[k]!);
    const along = (axis: ArrayLike<number>) => speed.reduce((sum, v, k) => sum + v * axis[k]!, 0);
    expect(drifting.driftX).toBeCloseTo(along(right), 6);
    expect(drifting.driftY).toBeCloseTo(along(away), 6);
    expect([drifting.missX, drifting.missY]).toEqual([NaN, NaN]);
    expect(updateTargetReadout(createTargetReadout(), view, null, screen, aids).shown).toBe(false);
  });
});
