import { describe, expect, it } from 'vitest';
import { SHIP_CLASSES } from '../../src/dynamics';
import { flyDown, LANDER_CLASS } from './autopilotFlight';

const HAULER = SHIP_CLASSES.find(({ name }) => name === 'cargo_hauler')!;

describe('the landing autopilot with a target', () => {
  // Measured: within 1.2 m, at 0.9 to 1.6 m/s.
  it.each(
    ['Luna', 'Earth', 'Mars', 'Phobos'].flatMap((body) => [1, 10].map((rate) => [body, rate] as const)),
  )(
    'carries the ship there and lands softly on %s at %d Hz, without delay and a tick late',
    (body, tickRate) => {
      for (const delay of [0, 1]) {
        const { maneuver, impact, off } = flyDown({ body, tickRate, delay, target: [60, -35] });
        expect([maneuver.phase, maneuver.reason]).toEqual(['complete', '']);
        expect(off).toBeLessThan(2);
        expect(impact).toBeLessThan(2);
      }
    },
  );

  it('over hills and with a heavy ship’s drift too', () => {
    const hills = flyDown({ body: 'Luna', tickRate: 10, terrain: 'hills', target: [-80, 50] });
    const initial = { velocity: [-4, 3, -6] } as const;
    const hauler = flyDown({ body: 'Luna', tickRate: 10, shipClass: HAULER, initial, target: [-30, 20] });
    for (const { maneuver, impact, off } of [hills, hauler]) {
      expect([maneuver.phase, maneuver.reason]).toEqual(['complete', '']);
      expect(off).toBeLessThan(2);
      expect(impact).toBeLessThan(2);
    }
  });

  it('takes off again from beside it, and stays where it stands near it', () => {
    const standing = (east: number) =>
      flyDown({ body: 'Luna', tickRate: 10, initial: { height: 0 }, standing: true, target: [east, 0] });
    const beside = standing(40);
    expect([beside.maneuver.phase, beside.phases.at(0)]).toEqual(['complete', 'descent']);
    expect(beside.off).toBeLessThan(2);
    const near = standing(6);
    expect([near.seconds, near.maneuver.phase]).toEqual([0, 'complete']);
  });

  it('lands a ship without thrusters where it is', () => {
    const shipClass = { ...LANDER_CLASS, rcsThrust: [0, 0, 0] } as const;
    const { maneuver, off } = flyDown({ body: 'Luna', tickRate: 10, shipClass, target: [60, 0] });
    expect(maneuver.phase).toBe('complete');
    expect(off).toBeCloseTo(60, 0);
  });
});
