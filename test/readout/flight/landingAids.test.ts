import { describe, expect, it } from 'vitest';
import { GRAVITATIONAL_CONSTANT, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createLandingAids, updateLandingAids } from '../../../src/readout';
import { crossed, later, makeView, multiplied, NORMAL, type Pose } from '../views';

const controls = (thrustLevel: number) => ({ controls: { ...NEUTRAL_CONTROLS, thrustLevel } });

describe('landing aids', () => {
  const settle = (pose: Pose, changes = {}) => {
    const view = makeView(pose, changes);
    const out = createLandingAids();
    // Frames of no time: the run ahead is spread over them.
    for (let i = 0; i < 60; i++) updateLandingAids(out, later(view, 0, view.own));
    return { out, view };
  };

  /** Of a ship at rest: gravity, full thrust, what it brakes, m/s², and the speed to aim at, m/s. */
  const corridorOf = (pose: Pose) => {
    const view = makeView({ up: 0, ...pose });
    const out = createLandingAids();
    updateLandingAids(out, view);
    const { dryMass, mainEngineThrust } = view.own.shipClass;
    const g =
      (GRAVITATIONAL_CONSTANT * view.bodies[view.own.body]!.mass) / Math.hypot(...view.own.position) ** 2;
    const full = mainEngineThrust / (dryMass + view.own.fuel);
    return { g, full, braking: full - g, aim: out.aimSpeed };
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

  it('predict the touch on terrain as on the body’s radius', () => {
    const over = (terrain: number) => settle({ clearance: 80, up: -3, east: 2, terrain }).out;
    // 1,200 m down the Moon's gravity is 0.14 % more: less than the last substep of 8.3 s.
    expect(Math.abs(over(-1200).touchSeconds - over(0).touchSeconds)).toBeLessThan(0.021);
  });

  it('predict the tilt at the touch, which a server may align', () => {
    for (const tilt of [0, 25, 70]) {
      const at = (touchdownAttitude: 'kept' | 'aligned') =>
        settle({ clearance: 40, tilt, leanTo: 200, settings: { touchdownAttitude } }).out.touchTilt;
      // The ground turns by 0.001° during the fall.
      expect(at('kept')).toBeCloseTo(tilt, 2);
      expect(at('aligned')).toBeCloseTo(0, 5);
    }
  });

  it('predict the touch on a slope that rises ahead', () => {
    const pose = { clearance: 80, east: 10 };
    const [moving, still] = [makeView(pose), makeView({ clearance: 80 })];
    const ahead = moving.own.velocity.map((v, k) => (v - still.own.velocity[k]!) / 10);
    const steepness = Math.PI / 6;
    // Upright relative to the plumb line, so that feet and slope meet below the centre of mass.
    const groundNormal = NORMAL.map((n, k) => Math.cos(steepness) * n - Math.sin(steepness) * ahead[k]!);
    const { out, view } = settle(pose, { groundNormal: Float64Array.from(groundNormal) });
    const g =
      (GRAVITATIONAL_CONSTANT * view.bodies[view.own.body]!.mass) / Math.hypot(...view.own.position) ** 2;
    const closing = 10 * Math.tan(steepness);
    expect(out.touchSeconds).toBeCloseTo((Math.sqrt(closing ** 2 + 2 * g * 80) - closing) / g, 1);
  });

  it('keep the predicted touch on its ground while the ground turns, however old the run ahead', () => {
    const fallen = settle({ clearance: 800, up: 0 });
    const { own } = fallen.view;
    // Turned about no axis of the ship's frame, so that each component counts.
    const body = { ...fallen.view.bodies[own.body]!, attitude: [0.5, -0.1, 0.7, 0.5] as const };
    const view = { ...fallen.view, bodies: [body] };
    const out = createLandingAids();
    // However long the readout has run.
    for (const at of [-100, 0]) for (let i = 0; i < 60; i++) updateLandingAids(out, later(view, at, own));
    const rate = Math.hypot(...body.angularVelocity);
    const axis = [...body.angularVelocity].map((w) => w / rate);
    const under = (place: Float64Array) =>
      Math.hypot(...[0, 1, 2].map((k) => place[k]! - NORMAL[k]! * Math.hypot(...place)));
    // Straight down: the ground below the ship now is what it will touch, half a minute and 140 m of turning later.
    expect(out.touchSeconds).toBeGreaterThan(30);
    expect(under(out.touchPlace)).toBeLessThan(1);
    const half = (rate * 5) / 2;
    const [x, y, z] = axis.map((a) => a * Math.sin(half)) as [number, number, number];
    const turned = multiplied([x, y, z, Math.cos(half)], [...body.attitude]);
    const [before, seconds] = [out.touchPlace.slice(), out.touchSeconds];
    updateLandingAids(out, { ...later(view, 5, own), bodies: [{ ...body, attitude: turned }] });
    expect(out.touchSeconds).toBeCloseTo(seconds - 5, 6);
    const moved = before.map((x, k) => x + 5 * crossed([...body.angularVelocity], [...before])[k]!);
    expect(Math.hypot(...moved.map((x, k) => x - before[k]!))).toBeGreaterThan(10);
    expect(Math.hypot(...moved.map((x, k) => x - out.touchPlace[k]!))).toBeLessThan(0.01);
  });

  it('give the time until full thrust must begin to stop at the ground', () => {
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
    // Too late is now.
    expect(settle({ clearance: 20, up: -40 }).out.burnSeconds).toBe(0);
  });

  it('keep to a corridor that ends below two metres per second', () => {
    expect(settle({ clearance: 0.5, up: -1 }).out).toMatchObject({ corridor: 'good' });
    expect(settle({ clearance: 0.5, up: -1 }).out.aimSpeed).toBeLessThan(2);
    expect(settle({ clearance: 20, up: -15 }).out.corridor).toBe('fast');
    expect(settle({ clearance: 500, up: 0 }).out.corridor).toBe('slow');
  });

  it('aim at the speed that a quarter of a gentle braking slows to 1.2 m/s over the last two metres', () => {
    for (const body of ['Luna', 'Mars', 'Phobos'] as const)
      for (const clearance of [0, 1.5, 5, 40, 300, 3000]) {
        const { g, braking, aim } = corridorOf({ body, clearance });
        const gentle = Math.min(0.5 * braking, Math.max(g, 0.3));
        const square = 1.2 ** 2 + 2 * 0.25 * gentle * Math.max(0, clearance - 2);
        expect(aim).toBeCloseTo(Math.min(30, Math.sqrt(square)), 6);
      }
  });

  it('call a descent fast above 1.35 of that speed, slow below half of it, 0.5 m/s allowed', () => {
    for (const clearance of [5, 40, 300]) {
      const { aim } = corridorOf({ clearance });
      const at = (speed: number) => settle({ clearance, up: -speed }).out.corridor;
      const [fastest, slowest] = [1.35 * aim + 0.5, 0.5 * aim - 0.5];
      expect([fastest + 0.001, fastest - 0.001].map(at)).toEqual(['fast', 'good']);
      expect([slowest + 0.001, slowest - 0.001].map(at)).toEqual(['good', 'slow']);
    }
  });

  it('advise by the speed and height a second and a half ahead', () => {
    for (const clearance of [20, 150])
      for (const throttle of [0, 0.1, 0.2]) {
        const { g, full } = corridorOf({ clearance });
        const gained = (g - throttle * full) * 1.5;
        const at = (speed: number) => settle({ clearance, up: -speed }, controls(throttle)).out.advice;
        // The bound is where the speed ahead is the corridor's there; that height depends on the speed.
        const bound = (share: number, slack: number) => {
          let speed = 0;
          for (let i = 0; i < 60; i++) {
            const { aim } = corridorOf({ clearance: clearance - 1.5 * (speed + gained / 2) });
            speed = share * aim + slack - gained;
          }
          return speed;
        };
        const [fastest, slowest] = [bound(1.1, 0.3), bound(0.45, -0.3)];
        expect([fastest + 0.02, fastest - 0.02].map(at)).toEqual(['more', 'hold']);
        // An engine that is off cannot give less.
        expect([slowest + 0.02, slowest - 0.02].map(at)).toEqual(['hold', throttle > 0 ? 'less' : 'hold']);
      }
  });

  it('give no corridor and no advice for an engine that cannot lift the ship, and demand full thrust at once', () => {
    const blank = { corridor: 'none', advice: 'none', aimSpeed: NaN };
    expect(settle({ clearance: 80, up: -1, fuel: 0 }).out).toMatchObject({ ...blank, burnSeconds: 0 });
    expect(settle({ clearance: 80, up: 1, fuel: 0 }).out).toMatchObject({ ...blank, burnSeconds: NaN });
  });

  it('spend at most 400 substeps a view, and look two minutes ahead', () => {
    const out = createLandingAids();
    const view = makeView({ clearance: 3000, up: 100 });
    const { projection } = out.memory;
    updateLandingAids(out, view);
    // Substeps of 0.01 s.
    expect(projection.elapsed).toBeCloseTo(4, 9);
    for (let i = 2; i < 30; i++) updateLandingAids(out, view);
    expect(out.outcome).toBe('working');
    // One more than thirty times 400 where the sum of the substeps is a little short.
    for (let i = 0; i < 2; i++) updateLandingAids(out, view);
    expect(out.outcome).toBe('none');
  });

  it('forget a predicted touch once a run ahead with other controls has flown past it', () => {
    const { out, view } = settle({ clearance: 8, up: -2 });
    expect(out.touchSeconds).toBeLessThan(3);
    // Full thrust: it climbs for longer than the run looks ahead.
    const climbing = { ...view.own, ...controls(1) };
    for (let i = 0; i < 3; i++) updateLandingAids(out, later(view, 0.05 * i, climbing));
    expect(out).toMatchObject({ outcome: 'working', touchSeconds: NaN, touchVertical: NaN, touchTilt: NaN });
  });

  it('forget a predicted touch when the ship is put elsewhere', () => {
    const { out } = settle({ clearance: 80, up: -3 });
    expect(out.outcome).toBe('touch');
    updateLandingAids(out, makeView({ clearance: 3000, up: -3 }));
    expect(out).toMatchObject({ outcome: 'working', touchSeconds: NaN, touchVertical: NaN, touchTilt: NaN });
  });

  it('forget a run ahead when the ship lands', () => {
    const [falling, other] = [
      makeView({ clearance: 800, up: -3 }),
      makeView({ clearance: 30, up: -1, north: 4 }),
    ];
    const out = createLandingAids();
    updateLandingAids(out, falling);
    expect(out.outcome).toBe('working');
    updateLandingAids(out, makeView({ clearance: -0.016, state: 'landed' }));
    for (let i = 0; i < 60; i++) updateLandingAids(out, other);
    const fresh = settle({ clearance: 30, up: -1, north: 4 }).out;
    expect([out.touchSeconds, out.touchVertical, out.touchHorizontal]).toEqual([
      fresh.touchSeconds,
      fresh.touchVertical,
      fresh.touchHorizontal,
    ]);
  });

  it('advise more thrust before the ship is too fast, and less only where it hardly descends', () => {
    const advice = (pose: Parameters<typeof settle>[0]) => settle(pose).out.advice;
    expect(advice({ clearance: 188, up: -6 })).toBe('hold');
    // In free fall a moment ahead: 5.5 m/s at 4 m are on no corridor, whatever the speed of now.
    expect(advice({ clearance: 8, up: -3 })).toBe('more');
    expect(settle({ clearance: 8, up: -3 }).out.corridor).toBe('good');
    const at = (pose: Pose, throttle: number) => settle(pose, controls(throttle)).out.advice;
    expect(at({ clearance: 60, up: 5 }, 0.1)).toBe('less');
    expect(at({ clearance: 60, up: 5 }, 0)).toBe('hold');
    expect(at({ clearance: 20, up: 0, body: 'Phobos' }, 0)).toBe('push');
    expect(at({ clearance: 20, up: 0, body: 'Phobos' }, 0.005)).toBe('less');
    expect(at({ clearance: 20, up: -1, body: 'Phobos' }, 0)).toBe('hold');
    expect(advice({ clearance: -0.016, state: 'landed' })).toBe('none');
  });

  it('are hidden on the ground and for a climbing ship', () => {
    expect(settle({ clearance: -0.016, state: 'landed' }).out.shown).toBe(false);
    const { out } = settle({ clearance: 80, up: 400 });
    expect([out.outcome, out.touchSeconds]).toEqual(['none', NaN]);
    expect(out.burnSeconds).toBeNaN();
  });
});
