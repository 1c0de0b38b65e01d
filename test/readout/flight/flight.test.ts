import { describe, expect, it } from 'vitest';
import { GRAVITATIONAL_CONSTANT, NEUTRAL_CONTROLS, STANDARD_GRAVITY } from '../../../src/dynamics';
import {
  createFlightReadout,
  createLandingAids,
  createTargetReadout,
  updateFlightReadout,
  updateLandingAids,
  updateTargetReadout,
} from '../../../src/readout';
import { later, makeView, NORMAL, type Pose } from '../views';

const controls = (thrustLevel: number) => ({ controls: { ...NEUTRAL_CONTROLS, thrustLevel } });

describe('the instruments of flying', () => {
  const read = (pose: Pose, changes = {}) =>
    updateFlightReadout(createFlightReadout(), makeView({ clearance: 80, ...pose }, changes));

  it('mark the hover throttle, and give fuel time and remaining Δv', () => {
    const view = makeView({ clearance: 80, fuel: 2000 }, controls(0.1));
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
  });
});

describe('landing aids', () => {
  const settle = (pose: Pose, changes = {}) => {
    const view = makeView(pose, changes);
    const out = createLandingAids();
    // Frames of no time: the run ahead is spread over them.
    for (let i = 0; i < 60; i++) updateLandingAids(out, later(view, 0, view.own));
    return { out, view };
  };

  it('predict the touch of a free fall', () => {
    const { out, view } = settle({ clearance: 80, up: -3, east: 2 });
    const body = view.bodies[view.own.body]!;
    const g = (GRAVITATIONAL_CONSTANT * body.mass) / Math.hypot(...view.own.position) ** 2;
    const seconds = (-3 + Math.sqrt(9 + 2 * g * 80)) / g;
    expect(out.outcome).toBe('touch');
    expect(out.touchSeconds).toBeCloseTo(seconds, 1);
    expect(out.touchVertical).toBeCloseTo(3 + g * seconds, 1);
    expect(out.touchHorizontal).toBeCloseTo(2, 1);
    const off = Math.hypot(
      ...[0, 1, 2].map((k) => out.touchPlace[k]! - NORMAL[k]! * Math.hypot(...out.touchPlace)),
    );
    expect(off).toBeCloseTo(2 * seconds, 0);
  });

  it('say when full thrust must begin so that it stops at the ground', () => {
    const { out, view } = settle({ clearance: 200, up: -10 });
    const body = view.bodies[view.own.body]!;
    const mass = view.own.shipClass.dryMass + view.own.fuel;
    const g = (GRAVITATIONAL_CONSTANT * body.mass) / Math.hypot(...view.own.position) ** 2;
    const t = out.burnSeconds;
    const speed = 10 + g * t;
    const height = 200 - 10 * t - 0.5 * g * t * t;
    const stop = speed ** 2 / (2 * (view.own.shipClass.mainEngineThrust / mass - g));
    expect(t).toBeGreaterThan(0);
    expect(height).toBeCloseTo(stop, 6);
  });

  it('keep to a corridor that ends below two metres per second', () => {
    expect(settle({ clearance: 0.5, up: -1 }).out).toMatchObject({ corridor: 'good' });
    expect(settle({ clearance: 0.5, up: -1 }).out.aimSpeed).toBeLessThan(2);
    expect(settle({ clearance: 20, up: -15 }).out.corridor).toBe('fast');
    expect(settle({ clearance: 500, up: 0 }).out.corridor).toBe('slow');
  });

  it('are hidden on the ground and for a climbing ship', () => {
    expect(settle({ clearance: -0.016, state: 'landed' }).out.shown).toBe(false);
    const { out } = settle({ clearance: 80, up: 400 });
    expect([out.outcome, out.touchSeconds]).toEqual(['none', NaN]);
    expect(out.burnSeconds).toBeNaN();
  });
});

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
    expect(updateTargetReadout(createTargetReadout(), view, null, screen, aids).shown).toBe(false);
  });
});
