import { describe, expect, it } from 'vitest';
import { BODIES, type Body, type BodyMotion, flatTerrain, SHIP_CLASSES } from '../../src/dynamics';
import {
  fromBodyRelative,
  type Ground,
  type LocalState,
  siteToIcrf,
  toBodyRelative,
} from '../../src/scenarios';

/** A body whose axes lie along ICRF's: Y is its pole. */
const untilted = (body: string, spin: number): Body & BodyMotion => ({
  ...BODIES.find(({ name }) => name === body)!,
  attitude: [0, 0, 0, 1] as const,
  angularVelocity: [0, spin, 0] as const,
});
const MOON = untilted('Luna', 2.6617e-6);
const EARTH = untilted('Earth', 7.2921e-5);
const LANDER = SHIP_CLASSES.find(({ name }) => name === 'planetary_lander')!;
const CRAFT = { shipClass: LANDER, fuel: 100, surfaceContactState: '', contactImpactSpeed: 0 } as const;
const STILL: LocalState = {
  height: 0,
  velocity: [0, 0, 0],
  tilt: 0,
  leanTo: 0,
  heading: 0,
  spin: [0, 0, 0],
};

function ground(latitude: number, longitude: number, body = MOON): Ground {
  return { body, site: { latitude, longitude }, terrainHeight: flatTerrain };
}

function expectClose(given: readonly number[], expected: readonly number[], digits = 9): void {
  expect(given).toHaveLength(expected.length);
  for (const [i, value] of given.entries()) expect(value).toBeCloseTo(expected[i]!, digits);
}

describe('a site', () => {
  it('follows the game’s axes: Y pole, Z prime meridian, X 90° E', () => {
    const reach = MOON.radius + LANDER.groundContactOffset;
    const at = (latitude: number, longitude: number) =>
      toBodyRelative(STILL, CRAFT, ground(latitude, longitude)).relativePosition;
    expectClose(at(0, 0), [0, 0, reach], 6);
    expectClose(at(0, 90), [reach, 0, 0], 6);
    expectClose(at(90, 0), [0, reach, 0], 6);
    expectClose(at(-90, 123), [0, -reach, 0], 6);
  });

  it('has east, north and up as a right-handed frame', () => {
    const here = ground(0, 0);
    expectClose(siteToIcrf([1, 0, 0], here), [1, 0, 0]);
    expectClose(siteToIcrf([0, 1, 0], here), [0, 1, 0]);
    expectClose(siteToIcrf([0, 0, 1], here), [0, 0, 1]);
    expectClose(siteToIcrf([0, 1, 0], ground(40, 70)), [
      -Math.sin((40 / 180) * Math.PI) * Math.sin((70 / 180) * Math.PI),
      Math.cos((40 / 180) * Math.PI),
      -Math.sin((40 / 180) * Math.PI) * Math.cos((70 / 180) * Math.PI),
    ]);
  });

  it('moves with the rotating ground: 465 m/s east on Earth’s equator', () => {
    const ship = toBodyRelative(STILL, CRAFT, ground(0, 0, EARTH));
    expectClose(ship.relativeVelocity, [7.2921e-5 * (EARTH.radius + LANDER.groundContactOffset), 0, 0], 9);
    expectClose(ship.angularVelocity, [0, 7.2921e-5, 0], 15);
  });

  it('tilts a ship toward its lean direction', () => {
    const east = toBodyRelative({ ...STILL, tilt: 30, leanTo: 90 }, CRAFT, ground(0, 0));
    const seen = fromBodyRelative(east, LANDER, ground(0, 0));
    expectClose(seen.top, [0.5, 0, Math.sqrt(0.75)]);
    const northWest = toBodyRelative({ ...STILL, tilt: 90, leanTo: 315 }, CRAFT, ground(12, 34));
    expectClose(fromBodyRelative(northWest, LANDER, ground(12, 34)).top, [-Math.SQRT1_2, Math.SQRT1_2, 0]);
  });

  it('turns body +Y from north toward east by the heading', () => {
    const { attitude } = toBodyRelative({ ...STILL, heading: 90 }, CRAFT, ground(0, 0));
    // Local axes are ICRF's here: body y, turned by −90° about up, is east.
    const [x, y, z, w] = attitude;
    expectClose([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)], [1, 0, 0]);
  });

  it.each([
    [0, 0],
    [20, 30],
    [-67, 211],
    [89.9, -135],
  ])('round-trips a state at latitude %d, longitude %d on a rotated Earth', (latitude, longitude) => {
    const turned = { ...EARTH, attitude: [0, Math.sin(0.4), 0, Math.cos(0.4)] as const };
    const here = ground(latitude, longitude, turned);
    const local: LocalState = {
      height: 12.5,
      velocity: [3, -4, -5],
      tilt: 20,
      leanTo: 130,
      heading: 77,
      spin: [0.1, -0.2, 0.05],
    };
    const seen = fromBodyRelative(toBodyRelative(local, CRAFT, here), LANDER, here);
    // A double of 6,371 km holds a nanometre.
    expectClose(seen.position, [0, 0, 12.5], 7);
    expectClose(seen.velocity, local.velocity);
    expectClose(seen.spin, local.spin);
    const lean = Math.sin((20 / 180) * Math.PI);
    expectClose(seen.top, [
      lean * Math.sin((130 / 180) * Math.PI),
      lean * Math.cos((130 / 180) * Math.PI),
      Math.cos((20 / 180) * Math.PI),
    ]);
  });

  it('is on the terrain, not on the radius', () => {
    const hill = { ...ground(20, 30), terrainHeight: () => 123 };
    const reach = Math.hypot(...toBodyRelative(STILL, CRAFT, hill).relativePosition);
    expect(reach).toBeCloseTo(MOON.radius + 123 + LANDER.groundContactOffset, 6);
  });
});
