import { describe, expect, it } from 'vitest';
import {
  BODY_STRIDE,
  IMPACT_SPEED,
  REFERENCE_BODY,
  SURFACE_STATE,
  SURFACE_STATES,
  THRUST_LEVEL,
  WHEEL_MOMENTUM,
} from '../../../../src/dynamics';
import { showServerState } from '../../../../src/prediction/snapshots/reconcile/reconcile';
import type { ShipState } from '../../../../src/wire';

import { predicted, type Predicted, SUBSTEPS, TICK } from './predicted';

describe('an ignored state', () => {
  it('is older than the newest one', () => {
    const of = predicted();
    of.track.serverTick = TICK + 1;
    expect(of.take({ name: 'Late' })).toBeNull();
    expect([of.track.name, of.track.serverTick]).toEqual(['', TICK + 1]);
    expect(showServerState(of.sim, of.track, { ...of.sent, name: 'Late' }, of.context)).toBeNull();
    expect(of.track.name).toBe('');
  });

  it('names a body that is not in the world; the reason is kept', () => {
    const of = predicted();
    expect(of.take({ referenceBody: 'Vulcan' })).toContain('Vulcan');
    expect([of.track.serverTick, of.track.seenAt]).toEqual([TICK - 1, 3]);
  });
});

describe('another pilot’s controls', () => {
  it.each([
    [0, 15],
    [1, 15],
    [4, 60],
  ])('are held for one and a half sends, %i ticks apart: %i substeps from the present', (ticks, substeps) => {
    const { sim, track, take } = predicted('', { own: false });
    sim.cadence.ticks = ticks;
    sim.front.substep = 3;
    take();
    expect((track.releaseTick - sim.front.tick) * SUBSTEPS + track.releaseSubstep - 3).toBe(substeps);
  });

  it('are restored after their release if they still apply', () => {
    const released = (prepare: (of: Predicted) => void) => {
      const of = predicted('', { own: false });
      Object.assign(of.track, { releaseTick: TICK + 1, releaseSubstep: 9 });
      prepare(of);
      of.take({ thrustLevel: of.kept[THRUST_LEVEL]! });
      return of.track.replaying;
    };
    expect(released(() => undefined)).toBe(true);
    expect(released(({ kept }) => (kept[THRUST_LEVEL] = 0))).toBe(false);
    expect(released(({ track }) => (track.releaseTick = TICK + 2))).toBe(false);
    expect(released(({ track }) => (track.releaseTick = -1))).toBe(false);
  });

  it('of the player’s ship are never released', () => {
    const { track, take } = predicted();
    take();
    expect(track.releaseTick).toBe(-1);
  });
});

describe('a ship that is not predicted', () => {
  const show = (prepare: (of: Predicted) => void, more: Partial<ShipState> = {}) => {
    const of = predicted();
    Object.assign(of.track, { replaying: true, policy: 'hold' });
    of.track.picture.hasHeld = true;
    prepare(of);
    expect(showServerState(of.sim, of.track, { ...of.sent, ...more }, of.context)).toBeNull();
    return of.track;
  };

  it('is held in its server state', () => {
    const track = show(() => undefined);
    expect(track).toMatchObject({ mode: 'held', replaying: false, serverTick: TICK, silence: 2 });
    expect([track.unpredictable, track.states, track.picture.hasHeld]).toEqual([false, null, true]);
  });

  it('of an unknown class is not predictable, and drawn where the server has it', () => {
    const track = show(({ track: { policy: _, ...rest } }) => rest, { shipClass: 'Ferry' });
    expect(track.unpredictable).toBe(true);
    expect(show((of) => (of.track.policy = 'predict')).picture.hasHeld).toBe(false);
  });

  it('keeps its states if it is interpolated', () => {
    const track = show((of) => (of.track.policy = 'interpolate'));
    expect(track.states!.ticks).toEqual([TICK]);
  });

  it('has no wheel momentum and no impact speed if the server sends none', () => {
    const { serverRow } = show(() => undefined, {
      wheelMomentum: null,
      contactImpactSpeed: null,
    });
    expect([...serverRow.subarray(WHEEL_MOMENTUM, WHEEL_MOMENTUM + 3), serverRow[IMPACT_SPEED]]).toEqual([
      0, 0, 0, 0,
    ]);
    expect(SURFACE_STATES[serverRow[SURFACE_STATE]!]).toBe('');
    expect(serverRow[REFERENCE_BODY]! * BODY_STRIDE).toBe(0);
  });
});
