/** What a view shows of ships and bodies at an instant between two substep boundaries, by the formulas. */
import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_POSITION,
  BODY_VELOCITY,
  CRASHED,
  FUEL,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  LANDED,
  MAIN_ENGINE_THRUST,
  POSITION,
  RCS_THRUST,
  SHIP_STRIDE,
  SURFACE_STATE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  VELOCITY,
  WHEEL_MOMENTUM,
} from '../../../src/dynamics';
import { restartEase } from '../../../src/prediction/drawn/ease';
import { fillView } from '../../../src/prediction/drawn/worldView';
import { beginReading } from '../../../src/prediction/ground/learnedGround';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { setTempo } from '../../../src/prediction/time/timeline';
import { RATE, sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
const SUBSTEP = 0.01;
/** Share of the way from the boundary before the front to the front. */
const ALPHA = 0.25;
const SHARED = [POSITION, VELOCITY, ANGULAR_VELOCITY] as const;

/** A ship in step, high above the ground, with other values at the front than a substep before. */
function seen({ alpha = ALPHA, substep = 5 } = {}) {
  const { sim, viewBuilder } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  track.own = true;
  sim.front.substep = substep;
  sim.alpha = alpha;
  const { previous, front } = sim.fleet;
  for (let k = 0; k < 3; k++) previous[track.at + POSITION + k]! *= 1.01;
  for (let k = 0; k < SHIP_STRIDE; k++) front[track.at + k] = previous[track.at + k]!;
  for (const column of SHARED)
    for (let k = 0; k < 3; k++) front[track.at + column + k]! += column + 2 * k + 1;
  front[track.at + FUEL]! -= 3;
  front[track.at + IMPACT_SPEED] = 4;
  front[track.at + WHEEL_MOMENTUM + 1] = 6;
  front[track.at + GROUND_CONTACT_OFFSET]! += 1;
  const view = (now = 50) => {
    Object.assign(viewBuilder.instant, { now, present: 40, lead: 0.1, heard: 39 });
    fillView(viewBuilder, sim);
    return viewBuilder.view;
  };
  const rows = (of: Float64Array, column: number, count = 3) => [
    ...of.subarray(track.at + column, track.at + column + count),
  ];
  return { sim, track, view, rows, viewBuilder };
}
type Seen = ReturnType<typeof seen>;

describe('a ship in a view', () => {
  it('is interpolated between the substep boundaries around the present', () => {
    const { sim, view, rows } = seen();
    const own = view().own!;
    for (const [column, shown] of [
      [POSITION, own.position],
      [VELOCITY, own.velocity],
      [ANGULAR_VELOCITY, own.angularVelocity],
    ] as const) {
      const [before, after] = [rows(sim.fleet.previous, column), rows(sim.fleet.front, column)];
      for (const [k, x] of before.entries())
        expect(shown[k], `column ${column + k}`).toBeCloseTo(x + ALPHA * (after[k]! - x), 6);
    }
  });

  it.each([
    ['before the present', ALPHA, 'previous'],
    ['that is the present', 1, 'front'],
  ] as const)('has fuel, wheels, impact and height of the boundary %s', (_, alpha, of) => {
    const { sim, view, rows } = seen({ alpha });
    const own = view().own!;
    const at = (column: number) => rows(sim.fleet[of], column, 1)[0];
    expect([own.fuel, own.impactSpeed, own.groundContactOffset]).toEqual([
      at(FUEL),
      at(IMPACT_SPEED),
      at(GROUND_CONTACT_OFFSET),
    ]);
    expect([...own.wheelMomentum]).toEqual(rows(sim.fleet[of], WHEEL_MOMENTUM));
  });

  it('has its name, whether it is the player’s, its extrapolated states and its missed sends', () => {
    const { sim, track, view } = seen();
    Object.assign(track, { name: 'Eagle', lastSend: 3 });
    Object.assign(track.fit, { extrapolated: 'law', states: 7 });
    sim.cadence.sends = 5;
    expect(view().own).toMatchObject({
      ...{ name: 'Eagle', own: true, extrapolated: 'law', extrapolatedStates: 7, missingSends: 2 },
    });
    expect(sim.counters.shipsExtrapolated).toBe(1);
    track.own = false;
    track.fit.extrapolated = '';
    expect(view().own).toBeNull();
    expect([view().ships[0]!.own, sim.counters.shipsExtrapolated]).toEqual([false, 0]);
  });

  it('is drawn at its predicted pose plus the offset, which is in the axes of its body', () => {
    const { sim, track, view } = seen();
    const own = view().own!;
    expect([...own.easedPosition]).toEqual([...own.position]);
    expect([...own.meshAttitude]).toEqual([...own.attitude]);
    const { ease } = track.picture;
    ease.offset.set([2, -3, 6]);
    ease.turn.set([0, 0, 0.4]);
    restartEase(ease);
    // No time has passed since the last view.
    const eased = view().own!;
    const apart = eased.easedPosition.map((x, k) => x - eased.position[k]!);
    expect(Math.hypot(...apart)).toBeCloseTo(7, 6);
    const cos = Math.abs(eased.meshAttitude.reduce((sum, x, k) => sum + x * eased.attitude[k]!, 0));
    expect(2 * Math.acos(cos)).toBeCloseTo(0.4, 6);
    expect([sim.counters.offsetPosition, sim.counters.offsetAngle]).toEqual([7, 0.4]);
    // Later it is less.
    view(50.1);
    expect(sim.counters.offsetPosition).toBeLessThan(6);
    expect(sim.counters.offsetAngle).toBeLessThan(0.3);
  });

  it('has the thrust of thrusters and engine in its own axes, none without fuel or as a wreck', () => {
    const thrust = (prepare: (of: Seen) => void) => {
      const of = seen();
      const { sim, track, view } = of;
      for (const rows of [sim.fleet.previous, sim.fleet.front]) {
        rows.set([0, 0, 0, 1], track.at + ATTITUDE);
        rows.set([0.5, -1, 0.25], track.at + TRANSLATION_INPUT);
        rows[track.at + THRUST_LEVEL] = 0.8;
      }
      prepare(of);
      return [...view().own!.thrust];
    };
    const { constants } = seen().sim.world.shipClasses[0]!;
    expect(thrust(() => undefined)).toEqual([
      expect.closeTo(0.5 * constants[RCS_THRUST]!, 6),
      expect.closeTo(-constants[RCS_THRUST + 1]!, 6),
      expect.closeTo(0.25 * constants[RCS_THRUST + 2]! + 0.8 * constants[MAIN_ENGINE_THRUST]!, 6),
    ]);
    const none = (column: number, set: number) =>
      thrust(({ sim, track }) => (sim.fleet.previous[track.at + column] = set)).map(Math.abs);
    expect([none(FUEL, 0), none(CRASHED, 1)]).toEqual([
      [0, 0, 0],
      [0, 0, 0],
    ]);
  });

  it('has the height of its feet above the ground', () => {
    const { track, view, sim } = seen();
    const own = view().own!;
    const { radius } = sim.world.bodies[0]!;
    expect(own.groundRadius).toBeCloseTo(radius, 6);
    expect(own.feetHeight).toBeCloseTo(Math.hypot(...own.position) - radius - own.groundContactOffset, 6);
    expect([...own.meshPosition]).toEqual([...own.easedPosition]);
    const up = Math.hypot(...own.position);
    for (const [k, n] of own.groundNormal.entries()) expect(n).toBeCloseTo(own.position[k]! / up, 9);
    expect([own.groundOffset, own.groundConfidence, track.picture.groundOffset]).toEqual([0, 0, 0]);
  });

  it('stands on the learned ground, which is drawn at once on the ground and gradually in flight', () => {
    const learned = (state: number) => {
      const of = seen();
      const { sim, track, view } = of;
      for (const rows of [sim.fleet.previous, sim.fleet.front]) rows[track.at + SURFACE_STATE] = state;
      const { position } = view().own!;
      const distance = Math.hypot(...position);
      const { name, radius } = sim.world.bodies[0]!;
      const attitude = of.viewBuilder.context.normal.slice();
      beginReading(track.ground);
      track.ground.places.push({
        ...{ bodyName: name, bodyRadius: radius, direction: attitude, slope: new Float64Array(3) },
        ...{ offset: 2, states: 1, seenAt: 0, weight: 1 },
      });
      const own = view(50.1).own!;
      return { own, distance, radius, drawn: track.picture.groundOffset, counters: sim.counters };
    };
    const { own, distance, radius, drawn, counters } = learned(LANDED);
    expect([own.groundOffset, own.groundConfidence, drawn]).toEqual([
      expect.closeTo(2, 9),
      0.5,
      expect.closeTo(2, 9),
    ]);
    expect(own.groundRadius).toBeCloseTo(radius + 2, 6);
    expect(own.feetHeight).toBeCloseTo(distance - radius - 2 - own.groundContactOffset, 6);
    expect([counters.groundOffset, counters.groundConfidence]).toEqual([own.groundOffset, 0.5]);
    // 1 − e^(−10 · 0.1)
    expect(learned(0).drawn).toBeCloseTo(2 * (1 - Math.exp(-1)), 9);
  });
});

describe('the time of a view', () => {
  const label = (substep: number, alpha: number) => {
    const { tick, sinceTick } = seen({ substep, alpha }).view();
    return [tick, Math.round(sinceTick * 1e6) / 1e6];
  };

  it('is the instant between the two boundaries', () => {
    expect(label(5, ALPHA)).toEqual([TICK, (4 + ALPHA) * SUBSTEP]);
    expect(label(5, 1)).toEqual([TICK, 5 * SUBSTEP]);
    expect(label(1, 0)).toEqual([TICK, 0]);
    expect(label(0, 1)).toEqual([TICK, 0]);
    // In the last substep of the tick before.
    expect(label(0, ALPHA)).toEqual([TICK - 1, (9 + ALPHA) * SUBSTEP]);
  });

  it('has the tempo at the present, and whether time stands at the newest frame', () => {
    const { sim, view } = seen();
    expect(view()).toMatchObject({ tickRate: RATE, timeScale: 1, paused: false, ready: true });
    setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: true }, null);
    expect(view().paused).toBe(true);
  });
});

describe('a body in a view', () => {
  it('has moved since its tick by its velocity, and has its spin', () => {
    for (const substep of [5, 0]) {
      const { sim, view } = seen({ substep });
      const rows = boundaryAt(sim.bodies, sim.timeline, TICK);
      rows.set([30, -20, 10], BODY_VELOCITY);
      const { bodies } = view();
      // In the tick's fifth substep, or the last one of the tick before.
      const since = (substep === 0 ? -1 + ALPHA : 4 + ALPHA) * SUBSTEP;
      for (let k = 0; k < 3; k++) {
        expect(bodies[0]!.position[k]).toBeCloseTo(rows[BODY_POSITION + k]! + [30, -20, 10][k]! * since, 6);
        expect(bodies[0]!.velocity[k]).toBe([30, -20, 10][k]);
        expect(bodies[0]!.angularVelocity[k]).toBe(rows[BODY_ANGULAR_VELOCITY + k]);
      }
    }
  });
});
