import { describe, expect, it } from 'vitest';
import { MAX_CATCH_UP, runDueTicks, setFrozen, startLoop } from '../../src/authority';
import { frameOf, moonWith, runTo, valueOf } from './moon';

describe('tick rate and time scale', () => {
  it('apply from the next boundary when changed at run time', () => {
    const authority = moonWith('opening');
    expect(authority.setTickRate(20)).toBeNull();
    expect(authority.setTimeScale(10)).toBeNull();
    expect(frameOf(authority)).toMatchObject({ tick: 0, tickRate: 1, timeScale: 1 });
    const before = frameOf(authority).bodies[0]!.position[1];
    authority.tick(1);
    expect(frameOf(authority)).toMatchObject({ tick: 1, tickRate: 20, timeScale: 10 });
    const middle = frameOf(authority).bodies[0]!.position[1];
    authority.tick(1.05);
    const after = frameOf(authority).bodies[0]!.position[1];
    expect(middle - before).toBeCloseTo(26510, 3);
    expect(after - middle).toBeCloseTo(26510 / 2, 3);
  });

  it('are refused by name when out of range, and change nothing', () => {
    const authority = moonWith('opening');
    expect(authority.setTickRate(0)).toContain('tickRate');
    expect(authority.setTickRate(Number.NaN)).toContain('tickRate');
    expect(authority.setTimeScale(101)).toContain('timeScale');
    runTo(authority, 1);
    expect(frameOf(authority)).toMatchObject({ tickRate: 1, timeScale: 1 });
  });
});

describe('pause', () => {
  it('applies from the next boundary; the same tick repeats, and nothing moves', () => {
    const authority = moonWith('opening');
    runTo(authority, 1);
    authority.setPaused(true);
    expect(frameOf(authority).paused).toBe(false);
    authority.tick(2);
    const held = frameOf(authority);
    expect(held).toMatchObject({ tick: 2, paused: true });
    authority.tick(3);
    authority.tick(4);
    expect(frameOf(authority)).toEqual({ ...held, events: [] });
    authority.setPaused(false);
    authority.tick(5);
    expect(frameOf(authority)).toEqual({ ...held, events: [], paused: false });
    authority.tick(6);
    expect(frameOf(authority).tick).toBe(3);
  });

  it('changes nothing in the trajectory', () => {
    const straight = moonWith('opening');
    runTo(straight, 9);
    const paused = moonWith('opening');
    runTo(paused, 4);
    paused.setPaused(true);
    for (let at = 5; at < 9; at++) paused.tick(at);
    paused.setPaused(false);
    while (paused.tickNumber() < 9) paused.tick(20);
    expect(frameOf(paused).ships).toEqual(frameOf(straight).ships);
  });

  it('answers a ping with the boundary itself: no time passes', () => {
    const authority = moonWith('opening');
    authority.setPaused(true);
    authority.tick(1);
    expect(valueOf(authority.receive('ann', { kind: 'ping', id: 1 }, 1.9))).toMatchObject({
      tick: 1,
      sinceTick: 0,
    });
  });
});

describe('a step', () => {
  it('is refused unless paused', () => {
    expect(moonWith('opening').armStep('tick')).toContain('not paused');
  });

  it('ends in a pause, whatever was requested before', () => {
    const authority = moonWith('opening');
    authority.setPaused(true);
    authority.tick(1);
    authority.setPaused(false);
    expect(authority.armStep('tick')).toBeNull();
    authority.tick(2);
    expect(frameOf(authority)).toMatchObject({ tick: 2, paused: true });
  });

  it('of a substep is an interval of one substep, announced by the frame before it', () => {
    const authority = moonWith('opening');
    authority.setPaused(true);
    authority.tick(1);
    const held = frameOf(authority);
    expect(authority.armStep('substep')).toBeNull();
    expect(frameOf(authority)).toMatchObject({ tick: 1, tickRate: 100, timeScale: 1, paused: false });
    authority.tick(1);
    expect(frameOf(authority)).toMatchObject({ tick: 2, tickRate: 1, timeScale: 1, paused: true });
    const moved = frameOf(authority).bodies[0]!.position[1] - held.bodies[0]!.position[1];
    expect(moved).toBeCloseTo(265.1, 3);
  });

  it('of a tick equals a hundred substeps, bit for bit', () => {
    const whole = moonWith('opening');
    const parts = moonWith('opening');
    for (const authority of [whole, parts]) {
      authority.setPaused(true);
      authority.tick(1);
    }
    whole.armStep('tick');
    whole.tick(2);
    for (let s = 0; s < 100; s++) {
      parts.armStep('substep');
      parts.tick(2);
    }
    expect(frameOf(whole).tick).toBe(2);
    expect(frameOf(parts).tick).toBe(101);
    expect(frameOf(parts).ships[0]!.relativePosition).toEqual(frameOf(whole).ships[0]!.relativePosition);
    expect(frameOf(parts).ships[0]!.surfaceContactState).toBe('');
  });
});

describe('the loop', () => {
  it('ticks when a boundary is due, and not before', () => {
    const authority = moonWith('opening', { tickRate: 20 });
    const loop = startLoop(authority, 100);
    const sent: number[] = [];
    for (const now of [100.049, 100.051, 100.09, 100.21])
      runDueTicks(loop, authority, now, (at) => sent.push(Math.round((at - 100) * 1000)));
    expect(sent).toEqual([50, 100, 150, 200]);
    expect(authority.tickNumber()).toBe(4);
  });

  it('answers pings before its first tick by the time since it started', () => {
    const authority = moonWith('opening');
    startLoop(authority, 100);
    const pong = valueOf(authority.receive('ann', { kind: 'ping', id: 1 }, 100.25));
    expect(pong).toMatchObject({ tick: 0, sinceTick: 0.25 });
  });

  it('follows a tick rate that changes at run time', () => {
    const authority = moonWith('opening');
    const loop = startLoop(authority, 0);
    authority.setTickRate(10);
    runDueTicks(loop, authority, 1.35, () => undefined);
    expect(authority.tickNumber()).toBe(4);
    expect(loop.nextAt).toBeCloseTo(1.4, 12);
  });

  it('catches up a bounded number of ticks after a stall and shifts the rest of the schedule', () => {
    const authority = moonWith('opening', { tickRate: 10 });
    const loop = startLoop(authority, 0);
    const passed = runDueTicks(loop, authority, 60.01, () => undefined);
    expect(passed).toBe(MAX_CATCH_UP);
    expect(loop.slipped).toBe(600 - MAX_CATCH_UP);
    expect(loop.nextAt).toBeCloseTo(60.1, 9);
  });

  it('does not advance while frozen, and continues where it stopped', () => {
    const authority = moonWith('opening');
    const loop = startLoop(authority, 0);
    runDueTicks(loop, authority, 2.5, () => undefined);
    setFrozen(loop, authority, true, 2.5);
    expect(runDueTicks(loop, authority, 30, () => undefined)).toBe(0);
    setFrozen(loop, authority, false, 30);
    expect(valueOf(authority.receive('ann', { kind: 'ping', id: 1 }, 30.25))).toMatchObject({
      tick: 2,
      sinceTick: 0.25,
    });
    expect(runDueTicks(loop, authority, 30.9, () => undefined)).toBe(0);
    expect(runDueTicks(loop, authority, 31, () => undefined)).toBe(1);
    expect(authority.tickNumber()).toBe(3);
    expect(loop.slipped).toBe(0);
  });

  it('keeps its schedule if it is frozen twice, or resumed while it runs', () => {
    const authority = moonWith('opening');
    const loop = startLoop(authority, 0);
    setFrozen(loop, authority, false, 0.5);
    expect(loop.nextAt).toBe(1);
    setFrozen(loop, authority, true, 0.5);
    setFrozen(loop, authority, true, 0.7);
    expect(loop.nextAt).toBe(1);
  });
});
