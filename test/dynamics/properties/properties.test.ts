import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ATTITUDE,
  BODY_ATTITUDE,
  CONTACT,
  CRASHED,
  EVENT_CONTACT,
  EVENT_DESTROYED,
  EVENT_LANDED,
  EVENT_RIGHTED,
  EVENT_TIPPED,
  FLYING,
  FUEL,
  IMPACT_SPEED,
  isTransitionAllowed,
  LANDED,
  NO_EVENT,
  SURFACE_STATE,
  TIPPED,
  type Vec3,
} from '../../../src/dynamics';
import { setup } from './arbitraries';
import { createTrial, gravityOn, see, type Setup, stepOnce, type Trial } from '../provingGround';

/** The same worlds on every run. */
const SEEDED = { seed: 20_260, numRuns: 400, endOnFailure: true } as const;
const SUBSTEPS = 300;

function offUnit(rows: Float64Array, at: number): number {
  return Math.abs(Math.hypot(...rows.subarray(at, at + 4)) - 1);
}

/** The invariant of a ship that is violated after a substep; '' if none. */
function fault(trial: Trial, before: number, event: number): string {
  const { ships, bodies } = trial;
  if (!ships.every(Number.isFinite)) return `not finite: ${ships.join(' ')}`;
  if (!bodies.every(Number.isFinite)) return `body not finite: ${bodies.join(' ')}`;
  if (offUnit(ships, ATTITUDE) > 1e-12) return `attitude off by ${offUnit(ships, ATTITUDE)}`;
  if (offUnit(bodies, BODY_ATTITUDE) > 1e-12)
    return `body's attitude off by ${offUnit(bodies, BODY_ATTITUDE)}`;
  const after = ships[SURFACE_STATE]!;
  if (ships[FUEL]! < 0 || ships[IMPACT_SPEED]! < 0) return 'fuel or impact speed below 0';
  if (ships[CRASHED] === 1) return after === FLYING ? '' : 'crashed with a surface state';
  if (!isTransitionAllowed(before, after)) return `${before} to ${after} is no legal move`;
  const led: Record<number, readonly number[]> = {
    [NO_EVENT]: before === after ? [after] : [FLYING],
    [EVENT_CONTACT]: [CONTACT],
    [EVENT_LANDED]: [LANDED],
    [EVENT_TIPPED]: [TIPPED],
    [EVENT_RIGHTED]: [CONTACT],
  };
  return led[event]?.includes(after) === true ? '' : `event ${event} from ${before} to ${after}`;
}

describe('any ship over any body under any controls', () => {
  it('stays finite with unit attitude, makes legal transitions only and reports each event', () => {
    const seen = new Set<string>();
    fc.assert(
      fc.property(setup, (given) => {
        const trial = createTrial(given);
        for (let i = 0; i < SUBSTEPS; i++) {
          const before = trial.ships[SURFACE_STATE]!;
          const event = stepOnce(trial);
          const said = fault(trial, before, event);
          if (said !== '') throw new Error(`substep ${i}: ${said}`);
          if (event !== NO_EVENT || before !== trial.ships[SURFACE_STATE])
            seen.add(`${before}>${trial.ships[SURFACE_STATE]!}/${event}`);
        }
      }),
      SEEDED,
    );
    // Every transition of the table and both launches must occur; otherwise the test proves little.
    const [f, c, l, t] = [FLYING, CONTACT, LANDED, TIPPED];
    for (const move of [
      `${f}>${f}/${EVENT_DESTROYED}`,
      `${f}>${c}/${EVENT_CONTACT}`,
      `${c}>${f}/${NO_EVENT}`,
      `${c}>${f}/${EVENT_DESTROYED}`,
      `${c}>${t}/${EVENT_TIPPED}`,
      `${c}>${l}/${EVENT_LANDED}`,
      `${t}>${c}/${EVENT_RIGHTED}`,
      `${t}>${f}/${NO_EVENT}`,
      `${l}>${f}/${NO_EVENT}`,
    ])
      expect([...seen]).toContain(move);
  });

  // By the impact's definition: a touch that is no crash has sunk in by no more than one substep of the crash speed. Level ground;
  // a rotating body's bulge of r² / 2R is below the centimetre allowed here.
  it('penetrates at first contact by at most crash speed × dt', () => {
    let touches = 0;
    fc.assert(
      fc.property(setup, (given) => {
        const trial = createTrial({ ...given, state: '', height: Math.abs(given.height ?? 0) });
        const crashSpeed = trial.world.settings.contactCrashSpeed;
        for (let i = 0; i < SUBSTEPS; i++) {
          const outside = see(trial).height >= 0;
          if (stepOnce(trial) !== EVENT_CONTACT || !outside) continue;
          touches++;
          expect(-see(trial).height).toBeLessThanOrEqual(crashSpeed * 0.01 + 1e-8);
          expect(trial.ships[IMPACT_SPEED]).toBeLessThanOrEqual(crashSpeed);
        }
      }),
      SEEDED,
    );
    expect(touches).toBeGreaterThan(50);
  });

  it('does not move once it has crashed', () => {
    fc.assert(
      fc.property(setup, (given) => {
        const trial = createTrial(given);
        trial.ships[CRASHED] = 1;
        const before = Array.from(trial.ships);
        expect(stepOnce(trial)).toBe(NO_EVENT);
        expect(Array.from(trial.ships)).toEqual(before);
      }),
      { ...SEEDED, numRuns: 50 },
    );
  });
});

describe('a bouncing ship', () => {
  // Without thrust each touch is slower than the last, so a ship ends landed, crashed, or tipped and at
  // rest. Within minutes, given some friction and damping, and enough gravity.
  const ending = setup.map((given) => ({
    ...given,
    state: '' as const,
    controls: {},
    body: { ...given.body!, angularVelocity: [0, 0, 0] as const },
    velocity: given.velocity!.map((part) => part / 2) as unknown as Vec3,
    settings: {
      ...given.settings,
      contactSettleAngularVel: 0.01,
      contactSettleLinearVel: 0.5,
      contactDampingRatio: 0.2 + 0.8 * given.settings!.contactDampingRatio!,
      contactBounceSpeed: Math.max(
        given.settings!.contactBounceSpeed!,
        0.2 * given.settings!.contactCrashSpeed!,
      ),
      contactFrictionStatic: 0.8,
      contactFrictionKinetic: 0.5,
    },
  }));

  it('comes to rest', () => {
    const ends = new Set<string>();
    let bounced = 0;
    fc.assert(
      fc.property(ending, (given) => {
        fc.pre(gravityOn(given.body) > 1 && given.body.radius > 1e5 && isNoNeedle(given));
        const trial = createTrial(given);
        let [touches, still, i] = [0, 0, 0];
        for (; i < MOST && still < 50 && trial.ships[CRASHED] !== 1; i++) {
          if (stepOnce(trial) === EVENT_CONTACT) touches++;
          still = trial.ships[SURFACE_STATE] === LANDED || liesStill(trial) ? still + 1 : 0;
        }
        ends.add(trial.ships[CRASHED] === 1 ? 'crashed' : `state ${trial.ships[SURFACE_STATE]!}`);
        if (touches > 1) bounced++;
        expect(i, `substeps, at the end ${JSON.stringify(see(trial))}`).toBeLessThan(MOST);
      }),
      { ...SEEDED, numRuns: 100 },
    );
    expect([...ends].sort()).toEqual(['crashed', `state ${LANDED}`, `state ${TIPPED}`]);
    expect(bounced).toBeGreaterThan(3);
  });
});

/**
 * Whether gravity turns the ship about its feet by less than 1 rad/s in a substep, m g h / I · dt. The law turns a hull tilted
 * beyond 90° back at 1 rad/s, so one of very little inertia under strong gravity stays there and never comes to rest (the game's
 * classes on Earth: at most 0.2 rad/s).
 */
function isNoNeedle({ body, shipClass }: Setup): boolean {
  const { dryMass, fuelCapacity, groundContactOffset, inertiaTensor } = shipClass!;
  const least = Math.min(...inertiaTensor.map((row, k) => 0.6 * row[k]!));
  return ((dryMass + fuelCapacity) * gravityOn(body!) * groundContactOffset * 0.01) / least < 1;
}

/** Five minutes. */
const MOST = 30_000;

function liesStill(trial: Trial): boolean {
  if (trial.ships[SURFACE_STATE] !== TIPPED) return false;
  const { spin, slide, climb } = see(trial);
  return spin < 0.05 && slide < 0.01 && Math.abs(climb) < 0.01;
}
