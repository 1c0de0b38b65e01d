import { describe, expect, it } from 'vitest';
import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_END_ATTITUDE,
  BODY_STRIDE,
  EVENT_CONTACT,
  EVENT_LANDED,
} from '../../../../src/dynamics';
import type { WorldView } from '../../../../src/prediction';
import { advanceEase, createEase, restartEase, springsOf } from '../../../../src/prediction/drawn/ease';
import { LONG_AGO } from '../../../../src/prediction/drawn/picture';
import { easeUprighting, uprights } from '../../../../src/prediction/drawn/snap/uprighting';
import { createRowStep } from '../../../../src/prediction/simulation/rowStep';
import { product, turnAbout, unit } from '../../../dynamics/vectors';
import { sessionAt, shipAt } from '../../decisions/sessionAt';
import { createRig } from '../../rig';
import { angleBetween } from '../../samples';

/** A ship that an aligned touchdown turned upright from `tilt` rad about AXIS, while it turned at `rate` rad/s about it. */
const AXIS = unit([2, -3, 6]);
function touched(event: number, touchdownAttitude: 'aligned' | 'kept' = 'aligned', rate = 0) {
  const { sim } = sessionAt(100);
  const track = shipAt(sim, 'own', '');
  const world = { ...sim.world, settings: { ...sim.world.settings, touchdownAttitude } };
  const step = createRowStep();
  const bodies = new Float64Array(BODY_STRIDE);
  bodies.set(turnAbout(unit([1, 2, 2]), 0.9), BODY_END_ATTITUDE);
  Object.assign(step, { event, bodies, dt: [0.01, null] });
  const upright = turnAbout(unit([3, 6, 2]), 0.4);
  step.rows.set(upright, ATTITUDE);
  step.before.set(product(turnAbout(AXIS, 0.3), upright), ATTITUDE);
  step.before.set(
    AXIS.map((x) => x * rate),
    ANGULAR_VELOCITY,
  );
  const changed = { ...sim, world };
  easeUprighting(changed, track, step);
  return { sim: changed, picture: track.picture };
}

const attitudeOf = ({ own }: WorldView) => (own === null ? null : [...own.attitude]);

describe('an aligned touchdown', () => {
  it('fades from the attitude that the ship’s spin would have led to', () => {
    const { picture } = touched(EVENT_CONTACT);
    expect([picture.sinceUprighting, picture.ease.active]).toEqual([0, true]);
    expect(Math.hypot(...picture.ease.turn)).toBeCloseTo(0.3, 9);
    expect(Math.hypot(...picture.ease.offset)).toBe(0);
    // By 5 rad/s for a substep more.
    expect(Math.hypot(...touched(EVENT_CONTACT, 'aligned', 5).picture.ease.turn)).toBeCloseTo(0.35, 9);
  });

  it.each([
    ['another event', EVENT_LANDED, 'aligned'],
    ['a touchdown that leaves the attitude', EVENT_CONTACT, 'kept'],
  ] as const)('is not %s', (_, event, attitude) => {
    const { sim, picture } = touched(event, attitude);
    expect([uprights(sim, event), picture.ease.active]).toEqual([false, false]);
    expect(picture.sinceUprighting).toBe(LONG_AGO);
  });

  it.each([10, 30, 60, 144])('is eased from the touch, not from the frame before it, at %i Hz', (hz) => {
    const rig = createRig({ scenario: 'opening', hz });
    let turn = 0;
    for (let flying: number[] | null = null; turn < 0.1; flying = attitudeOf(rig.view())) {
      const attitude = attitudeOf(rig.frame());
      if (flying !== null && attitude !== null) turn = angleBetween(flying, attitude);
    }
    const { tick: now, sinceTick, own } = rig.view();
    const { tick, substep } = rig.notices.find(({ type }) => type === 'ship.contact')!;
    // The ship turns at the end of the touch's substep, 0.01 s; a tick is 1 s.
    const since = now - tick + sinceTick - (substep + 1) * 0.01;
    const expected = createEase();
    expected.turn[0] = turn;
    restartEase(expected);
    advanceEase(expected, Float64Array.of(0, 0, 1), since, springsOf());
    expect(angleBetween([...own!.meshAttitude], [...own!.attitude])).toBeCloseTo(expected.turn[0], 3);
  });
});
