import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  FUEL,
  GRAVITATIONAL_CONSTANT,
  POSITION,
  type Quat,
  STANDARD_GRAVITY,
  type Vec3,
  VELOCITY,
} from '../../../src/dynamics';
import {
  createTrial,
  gravityOn,
  LANDER,
  quaternionAt,
  run,
  see,
  still,
  type Trial,
  vectorAt,
} from '../provingGround';
import { angleBetween, cross, dot, lengthOf, plus, product, turnAbout, unit } from '../vectors';

/** Far enough that a body's gravity is below 1e-12 m/s². */
const FAR = 1e9;

/**
 * Distance from the centre, `seconds` after a release at rest at `from`: the radial Kepler problem,
 * t = √(r0³ / 2μ) (acos √x + √(x (1 − x))), x = r / r0, solved by halving.
 */
function fallenTo(from: number, mu: number, seconds: number): number {
  const time = (x: number) =>
    Math.sqrt(from ** 3 / (2 * mu)) * (Math.acos(Math.sqrt(x)) + Math.sqrt(x - x * x));
  let [low, high] = [0.5, 1];
  for (let i = 0; i < 100; i++) {
    const middle = (low + high) / 2;
    if (time(middle) > seconds) low = middle;
    else high = middle;
  }
  return low * from;
}

function speedOf(trial: Trial): number {
  return lengthOf(vectorAt(trial.ships, VELOCITY));
}

describe('free fall from 100 km over the Moon', () => {
  const moon = still('Luna');
  const mu = GRAVITATIONAL_CONSTANT * moon.mass;

  // Target 0: the Kepler solution. Today 6e-10, 4e-8, 2e-6 m.
  it.each([
    [10, 1e-6],
    [100, 1e-6],
    [300, 1e-5],
  ])('matches Kepler after %d s within %d m', (seconds, tolerance) => {
    const trial = createTrial({ body: moon, height: 100_000 });
    const from = lengthOf(vectorAt(trial.ships, POSITION));
    run(trial, seconds);
    const error = lengthOf(vectorAt(trial.ships, POSITION)) - fallenTo(from, mu, seconds);
    expect(Math.abs(error)).toBeLessThan(tolerance);
  });

  // Target 0: Kepler, from 1 km over the Moon and Earth. Bound 1 mm in 10 s.
  it.each(['Luna', 'Earth'])('matches Kepler after 10 s over %s within 1 mm', (name) => {
    const body = still(name);
    const trial = createTrial({ body, height: 1000 });
    const from = lengthOf(vectorAt(trial.ships, POSITION));
    run(trial, 10);
    const ideal = fallenTo(from, GRAVITATIONAL_CONSTANT * body.mass, 10);
    expect(Math.abs(lengthOf(vectorAt(trial.ships, POSITION)) - ideal)).toBeLessThan(1e-3);
  });

  // Target 0.25: the error of a second-order step quarters with it.
  it('has a quarter of the error at half the step', () => {
    const errors = [4, 2].map((dt) => {
      const trial = createTrial({ body: moon, height: 100_000 });
      const from = lengthOf(vectorAt(trial.ships, POSITION));
      run(trial, 200, undefined, dt);
      return lengthOf(vectorAt(trial.ships, POSITION)) - fallenTo(from, mu, 200);
    });
    expect(errors[1]! / errors[0]!).toBeCloseTo(0.25, 2);
  });

  // Target 0: change of the total energy m (v²/2 − μ/r) relative to the energy converted in the fall. Today 3.50e-5.
  it('conserves energy', () => {
    const trial = createTrial({ body: moon, height: 100_000 });
    const energy = () => speedOf(trial) ** 2 / 2 - mu / lengthOf(vectorAt(trial.ships, POSITION));
    const before = energy();
    run(trial, 300);
    expect(Math.abs(energy() - before) / (speedOf(trial) ** 2 / 2)).toBeLessThan(3.6e-5);
  });

  // Target 0: a circular orbit closes after 2π √(r³/μ), 7,143 s. Today 0.8 m of 11,500 km.
  it('closes a circular orbit after one period', () => {
    const trial = createTrial({ body: moon, height: 300_000 });
    const start = vectorAt(trial.ships, POSITION);
    const radius = lengthOf(start);
    const along = unit(cross([0, 1, 0], start));
    const speed = Math.sqrt(mu / radius);
    trial.ships.set(
      along.map((part) => part * speed),
      VELOCITY,
    );
    const period = 2 * Math.PI * Math.sqrt(radius ** 3 / mu);
    const steps = 700_000;
    run(trial, steps * (period / steps), undefined, period / steps);
    expect(lengthOf(plus(vectorAt(trial.ships, POSITION), start, -1))).toBeLessThan(5);
  });
});

describe('the engine', () => {
  // Targets: Δv = Isp g0 ln(m0 / m1) and F t / (Isp g0) of fuel. Today 1.7e-6 of Δv, 5e-13 kg.
  it('follows the rocket equation', () => {
    const trial = createTrial({ height: FAR, body: still('Phobos'), controls: { thrustLevel: 1 } });
    run(trial, 100);
    const exhaust = LANDER.mainEngineIsp * STANDARD_GRAVITY;
    const burnt = (LANDER.mainEngineThrust * 100) / exhaust;
    expect(LANDER.fuelCapacity - trial.ships[FUEL]!).toBeCloseTo(burnt, 8);
    const ideal = exhaust * Math.log(16000 / (16000 - burnt));
    expect(Math.abs(speedOf(trial) / ideal - 1)).toBeLessThan(1e-5);
  });

  // Target 0: thrust of exactly the weight keeps the height. Today 4e-10 m in a second, as the fuel burnt is 20 kg of 16 t.
  it('hovers when thrust equals weight', () => {
    const body = still('Luna');
    const weight = 16000 * gravityOn(body, 1004);
    const trial = createTrial({ body, height: 1000, controls: { thrustLevel: weight / 60000 } });
    const from = see(trial).height;
    run(trial, 0.01);
    expect(Math.abs(see(trial).height - from)).toBeLessThan(1e-8);
    expect(Math.abs(see(trial).climb)).toBeLessThan(1e-12);
  });

  it('stops when the fuel runs out', () => {
    const fuel = 3;
    const trial = createTrial({ height: FAR, body: still('Phobos'), fuel, controls: { thrustLevel: 1 } });
    run(trial, 1);
    const exhaust = LANDER.mainEngineIsp * STANDARD_GRAVITY;
    const ideal = exhaust * Math.log((8000 + fuel) / 8000);
    expect(trial.ships[FUEL]).toBe(0);
    // The last substep gives full thrust from the remaining fuel: at most F dt / m more.
    expect(speedOf(trial)).toBeGreaterThan(ideal);
    expect(speedOf(trial)).toBeLessThan(ideal + (60000 * 0.01) / 8000);
    const spent = speedOf(trial);
    run(trial, 1);
    expect(speedOf(trial)).toBeCloseTo(spent, 10);
  });

  it('burns fuel for RCS force and torque, and none for the wheels', () => {
    const burntBy = (controls: Parameters<typeof createTrial>[0]['controls']) => {
      const trial = createTrial({ height: FAR, body: still('Phobos'), controls: controls! });
      run(trial, 1);
      return LANDER.fuelCapacity - trial.ships[FUEL]!;
    };
    const flow = 1 / (LANDER.rcsIsp * STANDARD_GRAVITY);
    expect(burntBy({ translationInput: [1, -0.5, 0.25] })).toBeCloseTo(1.75 * 2000 * flow, 9);
    expect(burntBy({ rotationInput: [1, 0, 0] })).toBeCloseTo((120000 / 4) * flow, 9);
    // 2000 of 122,000 N m is the wheel's own.
    expect(burntBy({ rotationInput: [2000 / 122000, 0, 0] })).toBeCloseTo(0, 12);
  });
});

describe('free rotation', () => {
  // Target 0: w t about the axis. The half-step quaternion is 2 atan(w dt/2): (w dt)³/12 short a substep. Today 8.3e-7 of 10 rad.
  it('turns by ω t', () => {
    const trial = createTrial({ height: FAR, body: still('Phobos'), tilt: 33 });
    const before = quaternionAt(trial.ships, ATTITUDE);
    const w: Vec3 = [0.06, -0.08, 0];
    trial.ships.set(w, ANGULAR_VELOCITY);
    run(trial, 100);
    const ideal = product(turnAbout([0.6, -0.8, 0], 10), before);
    expect(angleBetween(quaternionAt(trial.ships, ATTITUDE), ideal)).toBeLessThan(8.5e-7);
  });

  // Target: I⁻¹ τ t at full mass and (m / full) less when the tanks are empty. Today 1e-15.
  it.each([
    [8000, 1],
    [0, 2],
  ])('spins up by torque / inertia with %d kg of fuel', (fuel, gain) => {
    const shipClass = { ...LANDER, rcsTorque: [0, 0, 0] as const };
    const controls = { rotationInput: [0, 0, 1] as const };
    const trial = createTrial({ height: FAR, body: still('Phobos'), shipClass, fuel, controls });
    run(trial, 10);
    const axis = vectorAt(trial.ships, ANGULAR_VELOCITY);
    expect(lengthOf(axis)).toBeCloseTo((gain * 1000 * 10) / 77440, 12);
  });

  // Target: the angle of a critically damped a = −4 e − 4 w, θ (1 + 2 t) e^(−2 t) for a small angle. Today 7.5e-5 rad of 0.1.
  it('holds an attitude as a critically damped oscillator', () => {
    const trial = createTrial({ height: FAR, body: still('Phobos') });
    const now: Quat = quaternionAt(trial.ships, ATTITUDE);
    const targetAttitude = product(turnAbout([0, 0, 1], 0.1), now);
    const steered = createTrial({
      height: FAR,
      body: still('Phobos'),
      controls: { attitudeMode: 'hold', targetAttitude },
    });
    run(steered, 3);
    const left = angleBetween(quaternionAt(steered.ships, ATTITUDE), targetAttitude);
    expect(Math.abs(left - 0.1 * (1 + 6) * Math.exp(-6))).toBeLessThan(8e-5);
  });

  it.each([
    ['prograde', 1],
    ['retrograde', -1],
  ] as const)('points %s, also from the opposite direction', (attitudeMode, sign) => {
    const trial = createTrial({ height: FAR, body: still('Phobos'), tilt: 20, controls: { attitudeMode } });
    const top = () => plus([0, 0, 0], rotateTop(trial));
    trial.ships.set(
      top().map((part) => -sign * 5 * part),
      VELOCITY,
    );
    expect(dot(top(), unit(vectorAt(trial.ships, VELOCITY)))).toBeCloseTo(-sign, 12);
    run(trial, 30);
    expect(dot(top(), unit(vectorAt(trial.ships, VELOCITY)))).toBeCloseTo(sign, 9);
  });
});

function rotateTop(trial: Trial): Vec3 {
  const [x, y, z, w] = quaternionAt(trial.ships, ATTITUDE);
  return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
}
