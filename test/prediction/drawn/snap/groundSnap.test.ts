import { describe, expect, it } from 'vitest';
import { loadShipClass, SHIP_CLASSES } from '../../../../src/dynamics';
import {
  createGroundedPose,
  type DrawnGround,
  type GroundPose,
  hullOf,
  LEGS,
  snapToGround,
} from '../../../../src/prediction';
import { rotate } from '../../../../src/prediction/drawn/rotation';
import { drawnClearance } from '../../../../src/prediction/drawn/snap/groundSnap';
import { snapToLevel } from '../../../../src/prediction/drawn/snap/levelSnap';
import { flyAndMeasure } from '../../measure';
import { createRig, value } from '../../rig';

const RADIUS = 1_737_400;
const shipClass = value(loadShipClass(SHIP_CLASSES.find(({ name }) => name === 'planetary_lander')!));
const hull = hullOf(shipClass);
const h = shipClass.groundContactOffset;
const groundWith = (terrainHeight: (nx: number) => number): DrawnGround => ({
  bodyName: 'Moon',
  radius: RADIUS,
  terrainHeight: (_, nx) => terrainHeight(nx),
});
const level = groundWith(() => 0);
/** A slope of 1 in 5 along x, above the pole of z. */
const slope = groundWith((nx) => 0.2 * nx * RADIUS);

/** At `height` of the centre of mass above the sphere, tilted about y. */
function pose(height: number, degrees: number, grounded: boolean, groundOffset = 0): GroundPose {
  const half = (degrees * Math.PI) / 360;
  return {
    position: Float64Array.of(0, 0, RADIUS + height),
    attitude: Float64Array.of(0, Math.sin(half), 0, Math.cos(half)),
    grounded,
    groundOffset,
  };
}

/** Heights of all points above the ground, with legs compressed. */
function heights(given: GroundPose, ground: DrawnGround): number[] {
  const out = createGroundedPose(LEGS);
  snapToGround(out, given, hull, ground);
  const points: number[][] = [];
  for (let leg = 0; leg < LEGS; leg++) {
    const [x, y, z] = hull.feet.subarray(leg * 3, leg * 3 + 3);
    points.push([x!, y!, z! + out.legCompression[leg]!]);
  }
  for (let i = 0; i < hull.outline.length; i += 3) points.push([...hull.outline.subarray(i, i + 3)]);
  const [, qy, , qw] = given.attitude as unknown as [number, number, number, number];
  const [cos, sin] = [1 - 2 * qy * qy, 2 * qy * qw];
  return points.map(([x, y, z]) => {
    const px = out.position[0]! + cos * x! + sin * z!;
    const py = out.position[1]! + y!;
    const pz = out.position[2]! + cos * z! - sin * x!;
    const far = Math.sqrt(px * px + py * py + pz * pz);
    return far - RADIUS - ground.terrainHeight('Moon', px / far, 0, 0);
  });
}

/** A plane with a slope in degrees along x, through the sphere at the pole of z. */
function planeOf(degrees: number): DrawnGround {
  const tangent = Math.tan((degrees * Math.PI) / 180);
  return {
    bodyName: 'Moon',
    radius: RADIUS,
    // Points p with p_z − tangent p_x = RADIUS.
    terrainHeight: (_, nx, _ny, nz) => RADIUS / (nz - tangent * nx) - RADIUS,
  };
}

describe('a ship flush on a slope', () => {
  it.each([0, 10, 25])('of %i° has all four feet on it', (degrees) => {
    const out = createGroundedPose(LEGS);
    // The dynamics put the centre of mass h above the ground, along the local up.
    const given = pose(h, -degrees, true);
    snapToGround(out, given, hull, planeOf(degrees));
    const half = (-degrees * Math.PI) / 360;
    const [cos, sin] = [1 - 2 * Math.sin(half) ** 2, 2 * Math.sin(half) * Math.cos(half)];
    for (let leg = 0; leg < LEGS; leg++) {
      const [x, , z] = hull.feet.subarray(leg * 3, leg * 3 + 3);
      const pressed = z! + out.legCompression[leg]!;
      const px = out.position[0]! + cos * x! + sin * pressed;
      const pz = out.position[2]! + cos * pressed - sin * x!;
      const off = (pz - RADIUS) * cos + px * sin;
      expect(Math.abs(off), `leg ${String(leg)}`).toBeLessThan(2e-3);
    }
  });
});

describe('snapToGround', () => {
  const tilts = [0, 5, 20, 36, 60, 80, 90, 120, 180];

  it.each(tilts)('tilted by %i°, grounded: the lowest point touches and none is below', (tilt) => {
    for (const height of [h, h - 0.02, h - 3.4, h + 0.05]) {
      for (const ground of [level, slope]) {
        expect(Math.abs(Math.min(...heights(pose(height, tilt, true), ground)))).toBeLessThan(2e-3);
      }
    }
  });

  it.each(tilts)('tilted by %i°, flying: never below, and unchanged high up', (tilt) => {
    for (const height of [h - 2, h + 0.3, h + 5])
      expect(Math.min(...heights(pose(height, tilt, false), slope))).toBeGreaterThan(-2e-3);
    const out = createGroundedPose(LEGS);
    expect(snapToGround(out, pose(h + 20, tilt, false), hull, level).lift).toBe(0);
  });

  it('compresses the legs before it lifts the ship', () => {
    const out = createGroundedPose(LEGS);
    snapToGround(out, pose(h - 0.5, 0, true), hull, level);
    expect(out.lift).toBeCloseTo(0, 3);
    for (const pressed of out.legCompression) expect(pressed).toBeCloseTo(0.5, 3);
    snapToGround(out, pose(h - 3.4, 0, true), hull, level);
    for (const pressed of out.legCompression) expect(pressed).toBe(hull.stroke);
    expect(out.lift).toBeCloseTo(3.4 - hull.stroke, 3);
    expect(out.feetHeight).toBeCloseTo(-3.4, 3);
  });

  it.each([
    [1, [0.48, 0.6, 0.64]],
    [-1, [-0.6, 0.64, -0.48]],
  ] as const)('lifts along the local up in any attitude at any place: %d', (sign, up) => {
    const attitude = Float64Array.of(0.1, -0.5 * sign, 0.7, sign * 0.5);
    const position = Float64Array.from(up, (x) => x * (RADIUS + h - 1));
    const given: GroundPose = { position, attitude, grounded: true, groundOffset: 0 };
    const out = createGroundedPose(LEGS);
    snapToGround(out, given, hull, level);
    for (const [k, x] of up.entries()) expect(out.position[k]! - position[k]!).toBeCloseTo(x * out.lift, 8);
    const points: Float64Array[] = [];
    for (let i = 0; i < hull.outline.length; i += 3) points.push(hull.outline.slice(i, i + 3));
    for (let leg = 0; leg < LEGS; leg++) {
      points.push(hull.feet.slice(leg * 3, leg * 3 + 3));
      points.at(-1)![2] = points.at(-1)![2]! + out.legCompression[leg]!;
    }
    const far = points.map((p) => {
      rotate(p, attitude, p);
      return Math.sqrt(p.reduce((sum, x, k) => sum + (x + out.position[k]!) ** 2, 0));
    });
    expect(Math.abs(Math.min(...far) - RADIUS)).toBeLessThan(1e-4);
    const quick = createGroundedPose(LEGS);
    snapToLevel(quick, given, hull, { radius: RADIUS });
    expect(quick.lift).toBeCloseTo(out.lift, 3);
    expect(quick.feetHeight).toBeCloseTo(out.feetHeight, 4);
    for (let k = 0; k < 3; k++) expect(quick.position[k]).toBeCloseTo(out.position[k]!, 3);
  });

  it.each([
    { what: 'is 0 below the ground', clearance: -0.1, height: -0.1, offset: 0, drawn: 0 },
    { what: 'is its own upright', clearance: 0.3, height: 0.3, offset: 0, drawn: 0.3 },
    { what: 'is its own above a metre', clearance: 2.5, height: 1, offset: 0, drawn: 2.5 },
    { what: 'grows from 0 to that', clearance: 2, height: 0.25, offset: 0, drawn: 2 - 1.75 * 0.75 },
    { what: 'is 0 while the centre is lower', clearance: 2, height: -0.25, offset: 0, drawn: 0 },
    { what: 'is 0 on higher ground', clearance: 0.5, height: 0.5, offset: 0.5, drawn: 0 },
    // At a quarter of eight offsets the smoothstep is 5/32, at half of them 1/2.
    { what: 'fades to its own', clearance: 1.5, height: 1.5, offset: 0.5, drawn: 1 + (0.5 * 5) / 32 },
    { what: 'has faded at eight offsets', clearance: 4.5, height: 4.5, offset: 0.5, drawn: 4.5 },
    { what: 'fades over a metre at least', clearance: 0.6, height: 0.6, offset: 0.1, drawn: 0.55 },
    { what: 'is above lower ground', clearance: 1.5, height: 1.5, offset: -0.5, drawn: 2 - 0.25 },
    // Over 2.5 m of 4 the smoothstep is 175/256.
    { what: 'nears lower ground', clearance: 0.2, height: 2, offset: -0.5, drawn: 0.7 - (0.5 * 175) / 256 },
    { what: 'is never below the ground', clearance: -0.4, height: 3.5, offset: -0.5, drawn: 0 },
  ])('a flying ship’s clearance $what', ({ clearance, height, offset, drawn }) => {
    expect(drawnClearance(clearance, height, offset)).toBeCloseTo(drawn, 12);
  });

  it('rises smoothly when a tipped ship leaves the ground', () => {
    const lift = (height: number, grounded: boolean) =>
      snapToGround(createGroundedPose(LEGS), pose(h + height, 90, grounded), hull, level).lift;
    expect(lift(0, true)).toBeLessThan(-1);
    expect(lift(0, false)).toBeCloseTo(lift(0, true), 6);
    expect(lift(0.5, false)).toBeCloseTo(lift(0, true) / 2, 1);
    expect(lift(1, false)).toBe(0);
  });

  it('matches the point-by-point result on level ground', () => {
    const [exact, quick] = [createGroundedPose(LEGS), createGroundedPose(LEGS)];
    for (const tilt of tilts) {
      for (const [height, grounded] of [
        [h, true],
        [h - 1.5, true],
        [h + 0.4, false],
      ] as const) {
        snapToGround(exact, pose(height, tilt, grounded), hull, level);
        snapToLevel(quick, pose(height, tilt, grounded), hull, { radius: RADIUS });
        // Curvature of the ground over the ship's extent.
        expect(quick.lift).toBeCloseTo(exact.lift, 3);
        expect(quick.feetHeight).toBeCloseTo(exact.feetHeight, 4);
        for (let leg = 0; leg < LEGS; leg++)
          expect(quick.legCompression[leg]).toBeCloseTo(exact.legCompression[leg]!, 3);
      }
    }
  });

  it.each([1, 0.3, -0.3, -1])(
    'follows the drawn ground without a jump when the predicted one is %d m above it, and is unchanged high up',
    (offset) => {
      const out = createGroundedPose(LEGS);
      const clearance = (height: number, grounded: boolean) =>
        Math.min(...heights(pose(h + offset + height, 0, grounded, offset), level));
      expect(clearance(0, true)).toBeCloseTo(0, 3);
      expect(clearance(1e-6, false)).toBeCloseTo(0, 3);
      // No jump on the way up, and at most a fifth faster or slower than predicted.
      for (let height = 0; height < 12; height += 0.05) {
        const rise = clearance(height + 0.05, false) - clearance(height, false);
        expect(rise).toBeGreaterThan(0.05 * 0.8 - 2e-4);
        expect(rise).toBeLessThan(0.05 * 1.2 + 2e-4);
      }
      expect(snapToGround(out, pose(h + offset + 12, 0, false, offset), hull, level).lift).toBe(0);
      expect(out.feetHeight).toBeCloseTo(12, 4);
    },
  );

  it('keeps every drawn point of a whole landing above ground', () => {
    const rig = createRig({ scenario: 'bounce' });
    let sunk = 0;
    let lowest = Number.POSITIVE_INFINITY;
    flyAndMeasure(rig, 24, ({ own }) => {
      if (own === null) return;
      sunk = Math.min(sunk, own.feetHeight);
      const centre = Math.sqrt(own.meshPosition.reduce((sum, x) => sum + x * x, 0));
      lowest = Math.min(lowest, centre - own.groundRadius - h + Math.max(...own.legCompression));
    });
    expect(sunk).toBeLessThan(-1);
    expect(lowest).toBeGreaterThan(-2e-3);
  });
});
