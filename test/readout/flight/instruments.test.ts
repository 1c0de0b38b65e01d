import { describe, expect, it } from 'vitest';
import { GRAVITATIONAL_CONSTANT, NEUTRAL_CONTROLS, STANDARD_GRAVITY } from '../../../src/dynamics';
import { createFlightReadout, updateFlightReadout } from '../../../src/readout';
import { makeView, type Pose } from '../views';

describe('the flight instruments', () => {
  const read = (pose: Pose, changes = {}) =>
    updateFlightReadout(createFlightReadout(), makeView({ clearance: 80, ...pose }, changes));

  it('mark the hover throttle, and give fuel time and remaining Δv', () => {
    const view = makeView(
      { clearance: 80, fuel: 2000 },
      { controls: { ...NEUTRAL_CONTROLS, thrustLevel: 0.1 } },
    );
    const { own } = view;
    const out = updateFlightReadout(createFlightReadout(), view);
    const body = view.bodies[own.body]!;
    const mass = own.shipClass.dryMass + 2000;
    const distance = Math.hypot(...own.position);
    const weight = (mass * GRAVITATIONAL_CONSTANT * body.mass) / distance ** 2;
    expect(out.hover).toBeCloseTo(weight / own.shipClass.mainEngineThrust, 9);
    const exhaust = own.shipClass.mainEngineIsp * STANDARD_GRAVITY;
    const flow = (0.1 * own.shipClass.mainEngineThrust) / exhaust;
    expect(out.burnSeconds).toBeCloseTo(2000 / flow, 6);
    expect(out.deltaV).toBeCloseTo(exhaust * Math.log(mass / own.shipClass.dryMass), 6);
    expect([out.fuel, out.fuelShare, out.throttle]).toEqual([2000, 0.25, 0.1]);
  });

  it('give attitude: pitch, lean, and the heading of the ship’s +Y from north to east', () => {
    expect(read({}).pitch).toBeCloseTo(90, 6);
    expect(read({ tilt: 30, leanTo: 90 }).pitch).toBeCloseTo(60, 6);
    const out = read({ tilt: 30, leanTo: 90 });
    expect(Math.hypot(out.leanX, out.leanY)).toBeCloseTo(30, 6);
    const [a, b] = [read({ heading: 0 }).heading, read({ heading: 50 }).heading];
    expect((a - b + 360) % 360).toBeCloseTo(50, 6);
  });

  it('give pitch and lean over the horizon, not over the slope below', () => {
    const slope = makeView({ tilt: 15 }).own.attitude;
    const [x, y, z, w] = slope as unknown as [number, number, number, number];
    const groundNormal = Float64Array.of(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
    const upright = read({}, { groundNormal });
    expect([upright.pitch, upright.leanX, upright.leanY]).toEqual([
      expect.closeTo(90, 6),
      expect.closeTo(0, 6),
      expect.closeTo(0, 6),
    ]);
    expect(read({ tilt: 15 }, { groundNormal }).pitch).toBeCloseTo(75, 6);
  });

  it('give no heading of a +Y that points straight up', () => {
    /** Over a body that turns about y, as the azimuth of a pose has it. */
    const heading = (pose: Pose) => {
      const view = makeView({ clearance: 80, ...pose });
      const bodies = view.bodies.map((body) => ({ ...body, angularVelocity: [0, 1e-6, 0] as const }));
      return updateFlightReadout(createFlightReadout(), { ...view, bodies }).heading;
    };
    for (const turned of [0, 90, 180, 270]) {
      const upright = heading({ heading: turned });
      // Leaning away from where +Y points raises it.
      const raised = (tilt: number) => heading({ heading: turned, tilt, leanTo: upright + 180 });
      expect(raised(89.9)).toBeCloseTo(upright, 6);
      expect(raised(90)).toBeNaN();
    }
  });

  it('give the wheels’ momentum as a share of their capacity', () => {
    const view = makeView({ clearance: 80 });
    const capacity = view.own.shipClass.reactionWheelCapacity!;
    view.own.wheelMomentum[1] = -capacity[1] / 4;
    expect(updateFlightReadout(createFlightReadout(), view).wheels[1]).toBeCloseTo(-0.25, 12);
  });

  it('are blank for a ship that is gone', () => {
    const out = read({}, { crashed: true, shownState: 'crashed' });
    expect(out.known).toBe(false);
    expect([out.throttle, out.fuel, out.pitch, out.heading]).toEqual([NaN, NaN, NaN, NaN]);
    const left = updateFlightReadout(createFlightReadout(), makeView({ clearance: 80 }));
    expect(left.wheels[0]).toBe(0);
    updateFlightReadout(left, makeView({ clearance: 80 }, { crashed: true, shownState: 'crashed' }));
    expect([...left.wheels]).toEqual([NaN, NaN, NaN]);
  });
});
