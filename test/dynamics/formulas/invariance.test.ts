import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  CONTACT,
  type Quat,
  LANDED,
  POSITION,
  SURFACE_STATE,
  VELOCITY,
} from '../../../src/dynamics';
import {
  bodyNamed,
  classNamed,
  createTrial,
  type MovingBody,
  quaternionAt,
  run,
  type Setup,
  stepOnce,
  type Trial,
  vectorAt,
} from '../provingGround';
import { angleBetween, lengthOf, plus, product, rotate, turnAbout, unit } from '../vectors';

/** A bounce, a slide, a rock and a landing: every pass of the law but the tipped ones. */
const TOUCH: Setup = {
  body: bodyNamed('Earth'),
  shipClass: classNamed('cargo_hauler'),
  settings: { touchdownAttitude: 'kept' },
  height: 2,
  velocity: [5, 2, -14],
  tilt: 12,
  roll: 40,
  spin: [0.02, -0.03, 0.1],
};

function apart(a: Trial, b: Trial, column: number): number {
  return lengthOf(plus(vectorAt(a.ships, column), vectorAt(b.ships, column), -1));
}

describe('smaller substeps', () => {
  const steps = [0.01, 0.005, 0.0025, 0.00125];

  /** Difference of each step size from a step of 0.01 s / 128, after 4 s. */
  function misses(setup: Setup): number[] {
    const settings = { touchdownAttitude: 'kept', contactSettleLinearVel: 1e-9 } as const;
    const ends = [...steps, 0.01 / 128].map((dt) => {
      const trial = createTrial({ ...setup, settings });
      run(trial, 4, undefined, dt);
      return trial;
    });
    return ends.slice(0, -1).map((end) => apart(end, ends.at(-1)!, POSITION));
  }

  // Target: each half of the previous, first order. A bounce and a slide: measured 1.58, 0.80, 0.39, 0.19 m.
  it('converge for a bounce and slide', () => {
    const found = misses({ ...TOUCH, body: bodyNamed('Luna'), velocity: [5, 2, -25] });
    expect(found[0]).toBeLessThan(1.7);
    for (let k = 1; k < found.length; k++) {
      expect(found[k]! / found[k - 1]!).toBeGreaterThan(0.42);
      expect(found[k]! / found[k - 1]!).toBeLessThan(0.58);
    }
  });

  // A settling touch on Earth: the moment of the touch within a substep changes the end by up to v dt / 2; then it converges.
  it('converge for a settling touchdown', () => {
    const found = misses({ ...TOUCH, velocity: [5, 2, -8] });
    expect(found[0]).toBeLessThan(0.05);
    expect(found.at(-1)).toBeLessThan(found[0]! / 6);
  });
});

describe('rotating the world', () => {
  const turn: Quat = product(turnAbout(unit([1, 2, -1]), 2.1), turnAbout(unit([-3, 1, 1]), 1.3));

  function turned(body: MovingBody): MovingBody {
    return {
      ...body,
      attitude: product(turn, body.attitude),
      angularVelocity: rotate(turn, body.angularVelocity),
    };
  }

  function turnedShip(trial: Trial): Trial {
    for (const column of [POSITION, VELOCITY, ANGULAR_VELOCITY])
      trial.ships.set(rotate(turn, vectorAt(trial.ships, column)), column);
    trial.ships.set(product(turn, quaternionAt(trial.ships, ATTITUDE)), ATTITUDE);
    return trial;
  }

  // Target 0. The rest is rounding of positions 6,371 km from the centre, 1 nm, amplified by a stiff contact.
  it('rotates the trajectory with it', () => {
    const here = createTrial(TOUCH);
    const there = turnedShip(createTrial(TOUCH));
    const body = turned(TOUCH.body!);
    there.bodies.set(createTrial({ ...TOUCH, body }).bodies);
    const states = new Set<number>();
    for (let i = 0; i < 1500; i++) {
      expect(stepOnce(there)).toBe(stepOnce(here));
      expect(there.ships[SURFACE_STATE]).toBe(here.ships[SURFACE_STATE]);
      states.add(here.ships[SURFACE_STATE]!);
    }
    expect([...states].sort()).toEqual([0, CONTACT, LANDED]);
    turnedShip(here);
    expect(apart(here, there, POSITION)).toBeLessThan(1e-6);
    expect(apart(here, there, VELOCITY)).toBeLessThan(1e-9);
    expect(
      angleBetween(quaternionAt(here.ships, ATTITUDE), quaternionAt(there.ships, ATTITUDE)),
    ).toBeLessThan(1e-9);
  });
});

describe('moving the body', () => {
  // Target: the same bits. A ship is simulated relative to its body, so the body's 1 au and 30 km/s change nothing.
  it.each([
    [
      [1.495978707e11, 0, 0],
      [0, 29784, 0],
    ],
    [
      [-4.1e12, 2.2e12, 7e11],
      [-5000, 3000, 100],
    ],
  ] as const)('to %j changes no bit of the trajectory', (position, velocity) => {
    const origin = createTrial({
      ...TOUCH,
      body: { ...TOUCH.body!, position: [0, 0, 0], velocity: [0, 0, 0] },
    });
    const away = createTrial({ ...TOUCH, body: { ...TOUCH.body!, position, velocity } });
    for (let i = 0; i < 1500; i++) expect(stepOnce(away)).toBe(stepOnce(origin));
    expect(Array.from(away.ships)).toEqual(Array.from(origin.ships));
  });
});
