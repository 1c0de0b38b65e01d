import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  CONTACT,
  CRASHED,
  FLYING,
  FUEL,
  LANDED,
  POSITION,
  SURFACE_STATE,
  TIPPED,
  VELOCITY,
} from '../../../src/dynamics';
import {
  createTrial,
  gravityOn,
  LANDER,
  quaternionAt,
  run,
  stepOnce,
  still,
  type Setup,
  type Trial,
  vectorAt,
} from '../provingGround';
import { createRandom } from '../seeded';
import { EAST, FOOT, slopeOf, valleyOf } from './slope';
import { conjugate, dot, lengthOf, rotate } from '../vectors';

const LUNA = still('Luna');
const SLOPES = [0, 10, 20, 30, 36, 38, 45, 60];

function standOn(degrees: number, settings: Setup['settings'] = {}, more: Partial<Setup> = {}): Trial {
  return createTrial({
    body: LUNA,
    place: FOOT,
    terrain: slopeOf(degrees, LUNA.radius),
    settings: { surfaceNormal: 'terrain', ...settings },
    height: 0.01,
    velocity: [0, 0, -0.2],
    ...more,
  });
}

/** Degrees between the ship's top and the vertical. */
function leanOf(trial: Trial): number {
  const top = rotate(quaternionAt(trial.ships, ATTITUDE), [0, 0, 1]);
  const r = vectorAt(trial.ships, POSITION);
  return (Math.acos(Math.min(1, dot(top, r) / lengthOf(r))) * 180) / Math.PI;
}

describe('on a slope, with the surface normal from the terrain', () => {
  // Footprint 36.87°, mu_static 0.8 = 38.66°: below both it stands flush; beyond the first it topples, beyond the second it slides.
  it.each(SLOPES)('of %d° an aligned ship stays flush or topples', (degrees) => {
    const trial = standOn(degrees);
    run(trial, 1, () => trial.ships[SURFACE_STATE] === CONTACT);
    expect(leanOf(trial)).toBeCloseTo(degrees, 2);
    run(trial, 40, () => [LANDED, TIPPED].includes(trial.ships[SURFACE_STATE]!));
    expect(trial.ships[SURFACE_STATE]).toBe(degrees < 36.87 ? LANDED : TIPPED);
    if (degrees < 36.87) expect(leanOf(trial)).toBeCloseTo(degrees, 1);
  });

  // A low, wide class does not topple on 40°: it slides where tan > mu_static, at g (sin − mu_kinetic cos).
  it.each([
    [37, false],
    [40, true],
  ])('of %d° a wide ship slides: %s', (degrees, slides) => {
    const wide = { ...LANDER, groundContactOffset: 1, legRadius: 3 };
    const trial = standOn(degrees, {}, { shipClass: wide });
    run(trial, 2);
    const from = vectorAt(trial.ships, POSITION);
    const before = lengthOf(vectorAt(trial.ships, VELOCITY));
    run(trial, 2);
    const angle = (degrees * Math.PI) / 180;
    const pull = gravityOn(LUNA, 1) * (Math.sin(angle) - 0.5 * Math.cos(angle));
    const moved = lengthOf(
      vectorAt(trial.ships, POSITION).map((x, k) => x - from[k]!) as unknown as typeof from,
    );
    expect(trial.ships[SURFACE_STATE]).toBe(slides ? CONTACT : LANDED);
    if (slides) expect(moved).toBeCloseTo(before * 2 + 0.5 * pull * 4, 1);
    else expect(moved).toBeLessThan(1e-6);
  });

  // Target: the same speed. Today within 0.01 %.
  it('a frictionless run up a slope and back returns the speed', () => {
    const trial = createTrial({
      body: LUNA,
      place: FOOT,
      terrain: valleyOf(400, LUNA.radius),
      settings: {
        surfaceNormal: 'terrain',
        contactFrictionStatic: 0,
        contactFrictionKinetic: 0,
        contactSettleLinearVel: 1e-7,
        contactSettleAngularVel: 1e-7,
      },
      height: -gravityOn(LUNA) / 100,
      velocity: [8, 0, 0],
      state: 'contact',
    });
    const along = () => dot(rotate(conjugate(LUNA.attitude), vectorAt(trial.ships, POSITION)), EAST);
    const speed = () => lengthOf(vectorAt(trial.ships, VELOCITY));
    const out: number[] = [];
    // Past the bottom in each direction: first east, then west.
    let side = 1;
    out.push(speed());
    for (let i = 0; i < 20_000 && out.length < 3; i++) {
      stepOnce(trial);
      if (Math.sign(along()) !== 0 && Math.sign(along()) !== side) {
        side = Math.sign(along());
        out.push(speed());
      }
    }
    expect(trial.ships[SURFACE_STATE]).toBe(CONTACT);
    expect(out).toHaveLength(3);
    for (const back of out.slice(1)) expect(Math.abs(back / out[0]! - 1)).toBeLessThan(1e-3);
  });
});

describe('energy on the ground without engines', () => {
  /** Kinetic, of motion and of rotation, gravity and spring, J; relative to ground that does not turn. */
  function energyOf(trial: Trial, degrees: number): number {
    const { ships, world } = trial;
    const [shipClass, body] = [world.shipClasses[0]!, world.bodies[0]!];
    const mass = shipClass.dryMass + ships[FUEL]!;
    const w = rotate(conjugate(quaternionAt(ships, ATTITUDE)), vectorAt(ships, ANGULAR_VELOCITY));
    const [x, y, z] = shipClass.inertiaTensor;
    const turning = 0.5 * (w[0] * dot(x, w) + w[1] * dot(y, w) + w[2] * dot(z, w));
    const r = vectorAt(ships, POSITION);
    const n = rotate(conjugate(LUNA.attitude), r);
    const unitN = [n[0] / lengthOf(r), n[1] / lengthOf(r), n[2] / lengthOf(r)] as const;
    const ground = body.radius + world.terrainHeight(body.name, ...unitN) + shipClass.groundContactOffset;
    const sunk = Math.max(0, ground - lengthOf(r)) * Math.cos((degrees * Math.PI) / 180);
    const gravity = -mass * body.gravityParameter * (1 / lengthOf(r) - 1 / body.radius);
    return (
      0.5 * mass * lengthOf(vectorAt(ships, VELOCITY)) ** 2 + turning + gravity + 0.5 * 100 * mass * sunk ** 2
    );
  }

  /** The largest rise above the lowest value so far within one contact, J. */
  function largestRise(trial: Trial, degrees: number, dt: number): number {
    let [low, worst] = [Infinity, 0];
    for (let t = 0; t < 12; t += dt) {
      stepOnce(trial, dt);
      if (trial.ships[CRASHED] === 1 || trial.ships[SURFACE_STATE] === LANDED) break;
      if (trial.ships[SURFACE_STATE] === FLYING) {
        low = Infinity;
        continue;
      }
      const now = energyOf(trial, degrees);
      worst = Math.max(worst, now - low);
      low = Math.min(low, now);
    }
    return worst;
  }

  const weight = 16_000 * gravityOn(LUNA);
  const rng = createRandom(11);
  const between = (a: number, b: number) => a + (b - a) * rng();
  const touches = Array.from({ length: 5 }, () => ({
    velocity: [between(-6, 6), between(-6, 6), -between(0.5, 30)] as const,
    roll: between(0, 360),
  }));

  // Target 0, except for the spring's discretisation; bound 1 % of weight · leg_radius at 2 ms.
  it.each([0, 15, 30])(
    'does not rise by one per cent of weight · leg_radius after aligned touchdowns on %d°',
    (degrees) => {
      for (const touch of touches) {
        const trial = standOn(degrees, { contactLongestSubstep: 0.002 }, touch);
        expect(largestRise(trial, degrees, 0.002)).toBeLessThan(0.01 * weight * 3);
      }
    },
  );

  // A tilted touch loads the legs' moment, and the legs lift the ship back.
  it.each([0, 15, 30])(
    'does not rise by weight · (h + leg_radius) after touchdowns with kept tilt on %d°',
    (degrees) => {
      for (const touch of touches) {
        const more = {
          ...touch,
          tilt: between(0, 60),
          spin: [between(-0.3, 0.3), between(-0.3, 0.3), 0] as const,
        };
        const trial = standOn(degrees, { touchdownAttitude: 'kept', contactLongestSubstep: 0.002 }, more);
        expect(largestRise(trial, degrees, 0.002)).toBeLessThan(weight * (4 + 3));
      }
    },
  );
});
