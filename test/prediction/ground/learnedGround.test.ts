import { describe, expect, it } from 'vitest';
import {
  agePlaces,
  beginReading,
  createLearnedGround,
  type GroundPlace,
  keepPlace,
  metresFrom,
  offsetAt,
  placeAt,
} from '../../../src/prediction/ground/learnedGround';
import { sessionAt } from '../decisions/sessionAt';

const RADIUS = 1e6;
const AT = [2 / 7, -3 / 7, 6 / 7] as const;
/** A unit direction along the ground there. */
const ALONG = [3 / 7, 6 / 7, 2 / 7] as const;

const placeOf = (more: Partial<GroundPlace> = {}): GroundPlace => ({
  bodyName: 'Luna',
  bodyRadius: RADIUS,
  direction: Float64Array.from(AT),
  offset: 2,
  slope: new Float64Array(3),
  states: 1,
  seenAt: 0,
  weight: 1,
  ...more,
});

/** The direction `metres` along the ground from AT. */
const aside = (metres: number) => AT.map((n, k) => n + (ALONG[k]! * metres) / RADIUS);
const offsetBeside = (places: GroundPlace[], metres: number, body = 'Luna') => {
  const [x, y, z] = aside(metres);
  return offsetAt(places, body, x!, y!, z!);
};
/** A place `metres` aside. */
const placeBeside = (metres: number, more: Partial<GroundPlace> = {}) =>
  placeOf({ direction: Float64Array.from(aside(metres)), ...more });

describe('the learned offset', () => {
  it('applies fully within 150 m of its place, by half midway, and not at all from 1 km on', () => {
    for (const [metres, share] of [
      [0, 1],
      [149, 1],
      [150 + 850 / 2, 1 / 2],
      // Smooth in between: 3 t² − 2 t³ at a quarter and at three.
      [150 + 850 / 4, 27 / 32],
      [150 + (850 * 3) / 4, 5 / 32],
      [1000, 0],
      [1e5, 0],
    ] as const)
      expect(offsetBeside([placeOf()], metres), `at ${metres} m`).toBeCloseTo(2 * share, 6);
  });

  it('follows the slope of its place', () => {
    const slope = Float64Array.from(ALONG, (x) => 0.05 * x);
    expect(offsetBeside([placeOf({ slope })], 100)).toBeCloseTo(2 + 5, 6);
    expect(offsetBeside([placeOf({ slope })], -100)).toBeCloseTo(2 - 5, 6);
  });

  it('applies to its own body only', () => {
    expect(offsetBeside([placeOf()], 0, 'Terra')).toBe(0);
    const other = placeOf({ bodyName: 'Terra', offset: 9 });
    expect(offsetBeside([placeOf(), other], 0)).toBe(2);
  });

  it('comes from the newer place where two overlap', () => {
    const [older, newer] = [placeOf({ offset: 2 }), placeBeside(500, { offset: 4 })];
    expect(offsetBeside([older, newer], 500)).toBe(4);
    // 425 m from the newer one: half of it, and the older one's for the rest.
    expect(offsetBeside([older, newer], 500 - 575)).toBeCloseTo(4 / 2 + 2 / 2, 6);
    const faded = placeOf({ offset: 4, weight: 0.25 });
    expect(offsetBeside([older, faded], 0)).toBeCloseTo(4 / 4 + (2 * 3) / 4, 9);
  });
});

describe('a place', () => {
  it('is found up to 150 m around it, the newest first', () => {
    const ground = createLearnedGround();
    const [older, newer] = [placeOf(), placeBeside(100)];
    ground.places.push(older, newer);
    const found = (metres: number, body = 'Luna') => placeAt(ground, body, Float64Array.from(aside(metres)));
    expect(found(0)).toBe(newer);
    expect(found(-51)).toBe(older);
    expect(found(-149)).toBe(older);
    expect(found(-151)).toBeNull();
    expect(found(0, 'Terra')).toBeNull();
    expect(metresFrom(older, Float64Array.from(aside(120)))).toBeCloseTo(120, 3);
  });

  it('replaces a nearby place, or the oldest of eight', () => {
    const ground = createLearnedGround();
    const kept = () => ground.places.map(({ offset }) => offset);
    for (let i = 0; i < 8; i++) keepPlace(ground, placeBeside(1000 * i, { offset: i }));
    expect(kept()).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    keepPlace(ground, placeBeside(3100, { offset: 30 }));
    expect(kept()).toEqual([0, 1, 2, 4, 5, 6, 7, 30]);
    keepPlace(ground, placeBeside(9000, { offset: 9 }));
    expect(kept()).toEqual([1, 2, 4, 5, 6, 7, 30, 9]);
  });

  it('fades from 5 to 20 minutes after its last confirmation', () => {
    const weights = (...ages: number[]) =>
      ages.map((age) => {
        const ground = createLearnedGround();
        ground.places.push(...[50, 50 + age, 50].map((seenAt) => placeOf({ seenAt })));
        agePlaces(ground, 50 + age);
        const left = ground.places.map(({ weight }) => weight);
        expect(left).toEqual(left.length === 1 ? [1] : [left[0], 1, left[0]]);
        return left.length === 1 ? 'gone' : left[0];
      });
    expect(weights(0, 300, 750, 1199, 1200)).toEqual([1, 1, 0.5, expect.closeTo(1 / 900, 9), 'gone']);
  });
});

describe('the ground that a ship reads', () => {
  const read = () => {
    const ground = createLearnedGround();
    beginReading(ground);
    return { ground, reading: ground.reading!, world: sessionAt(1).sim.world };
  };

  it('is the terrain itself without a place, and raised by a place’s offset', () => {
    const { ground, reading, world } = read();
    expect(reading.worldOf(ground, world)).toBe(world);
    ground.places.push(placeOf());
    const raised = reading.worldOf(ground, world);
    expect(raised.terrainHeight('Luna', ...AT)).toBeCloseTo(2, 9);
  });

  it('is created once per world', () => {
    const { ground, reading, world } = read();
    ground.places.push(placeOf());
    const raised = reading.worldOf(ground, world);
    expect(reading.worldOf(ground, world)).toBe(raised);
    expect(reading.worldOf(ground, { ...world })).not.toBe(raised);
  });

  it('has confidence 0.5 after one state, 0.75 after three, and less as it fades', () => {
    const { ground, reading } = read();
    const trust = (states: number, weight = 1) => {
      ground.places.splice(0, 9, placeOf({ states, weight }));
      return reading.confidenceAt(ground, 'Luna', Float64Array.from(AT));
    };
    expect([trust(1), trust(3), trust(3, 0.4)]).toEqual([0.5, 0.75, expect.closeTo(0.3, 9)]);
    expect(reading.confidenceAt(ground, 'Terra', Float64Array.from(AT))).toBe(0);
  });
});
