import { describe, expect, it } from 'vitest';
import { type Authority, MAX_QUEUED } from '../../src/authority';
import type { InputRecord } from '../../src/wire';
import { frameOf, input, moonWith, runTo, valueOf } from './moon';

function send(authority: Authority, inputs: InputRecord[], now: number, playerId = 'ann') {
  return authority.receive(playerId, { kind: 'inputs', inputs }, now);
}

const thrust = (authority: Authority) => frameOf(authority).ships[0]!.thrustLevel;

describe('inputs', () => {
  it('take effect from the start of the substep they name, to the bit', () => {
    // Half the tick's substeps of thrust burn half the fuel.
    const burnt = [0, 50, 99].map((substep) => {
      const authority = moonWith('opening');
      valueOf(send(authority, [input(1, 0, substep, { thrustLevel: 1 })], 0.1));
      runTo(authority, 1);
      return 4800 - frameOf(authority).ships[0]!.fuel;
    });
    const perSubstep = (200000 / (340 * 9.80665)) * 0.01;
    expect(burnt[0]).toBeCloseTo(100 * perSubstep, 9);
    expect(burnt[1]).toBeCloseTo(50 * perSubstep, 9);
    expect(burnt[2]).toBeCloseTo(perSubstep, 9);
  });

  it('are acknowledged, the last applied one with its place and its margin', () => {
    const authority = moonWith('opening');
    expect(frameOf(authority).lastInput).toBeNull();
    valueOf(send(authority, [input(1, 0, 10, {}), input(2, 0, 90, {}), input(3, 1, 5, {})], 0.25));
    runTo(authority, 1);
    expect(frameOf(authority).lastInput).toEqual({ seq: 2, tick: 0, substep: 90, margin: 0.75 });
    runTo(authority, 2);
    expect(frameOf(authority).lastInput).toEqual({ seq: 3, tick: 1, substep: 5, margin: 1.75 });
    expect(authority.counters).toMatchObject({ inputsApplied: 3, inputsLate: 0 });
  });

  it('are applied at the next substep when late, with a negative margin', () => {
    const authority = moonWith('opening');
    runTo(authority, 3);
    valueOf(send(authority, [input(1, 1, 40, { thrustLevel: 0.5 })], 3.2));
    expect(thrust(authority)).toBe(0);
    runTo(authority, 4);
    expect(thrust(authority)).toBe(0.5);
    const { lastInput } = frameOf(authority);
    // Its substep was simulated when boundary 2 was due, at 2 s.
    expect(lastInput).toMatchObject({ seq: 1, tick: 3, substep: 0 });
    expect(lastInput!.margin).toBeCloseTo(2 - 3.2, 12);
    expect(authority.counters).toMatchObject({ inputsApplied: 1, inputsLate: 1 });
  });

  it('have the margin of the boundary’s true time, even after the schedule changed', () => {
    const authority = moonWith('opening');
    for (const at of [1, 2.5, 7, 7.25]) authority.tick(at);
    valueOf(send(authority, [input(1, 1, 99, {})], 7.3));
    authority.tick(7.5);
    expect(frameOf(authority).lastInput!.margin).toBeCloseTo(2.5 - 7.3, 12);
  });

  it('of granularity tick apply at tick starts only', () => {
    const authority = moonWith('opening', { inputGranularity: 'tick' });
    valueOf(send(authority, [input(1, 0, 1, { thrustLevel: 1 })], 0.1));
    runTo(authority, 1);
    expect(frameOf(authority)).toMatchObject({ lastInput: null, ships: [{ fuel: 4800 }] });
    runTo(authority, 2);
    expect(frameOf(authority).lastInput).toMatchObject({ seq: 1, tick: 1, substep: 0 });
    expect(frameOf(authority).ships[0]!.fuel).toBeCloseTo(4800 - 200000 / (340 * 9.80665), 9);
  });

  it('apply once, whatever the network repeats, and never after a newer one', () => {
    const authority = moonWith('opening');
    const first = input(1, 0, 0, { thrustLevel: 0.1 });
    valueOf(send(authority, [first, first], 0));
    valueOf(send(authority, [first, input(3, 0, 20, { thrustLevel: 0.3 })], 0));
    // Sequence 2 is superseded: it arrived after 3.
    valueOf(send(authority, [input(2, 0, 50, { thrustLevel: 0.2 })], 0));
    runTo(authority, 1);
    expect(thrust(authority)).toBe(0.3);
    valueOf(send(authority, [first], 1.5));
    runTo(authority, 2);
    expect(thrust(authority)).toBe(0.3);
    expect(authority.counters).toMatchObject({ inputsApplied: 2, inputsDuplicate: 3, inputsSuperseded: 1 });
  });

  it('start again from 1 for a reloaded page, and continue for one that reconnects', () => {
    const authority = moonWith('opening');
    valueOf(send(authority, [input(1, 0, 0, { thrustLevel: 0.1 }), input(2, 0, 0, {})], 0));
    runTo(authority, 1);
    valueOf(authority.join('ann', 'own'));
    valueOf(send(authority, [input(2, 1, 0, { thrustLevel: 0.2 })], 1.1));
    expect(authority.counters.inputsDuplicate).toBe(1);
    valueOf(authority.join('ann', 'own'));
    valueOf(send(authority, [input(1, 1, 0, { thrustLevel: 0.4 })], 1.2));
    runTo(authority, 2);
    expect(thrust(authority)).toBe(0.4);
  });

  it('move the sender’s own ship only', () => {
    const authority = moonWith('opening');
    valueOf(authority.join('watcher', ''));
    const refused = send(authority, [input(1, 0, 0, { thrustLevel: 1 })], 0, 'watcher');
    expect(refused).toEqual({ ok: false, reason: 'playerId: watcher flies no ship' });
    expect(send(authority, [input(1, 0, 0, { thrustLevel: 1 })], 0, 'stranger').ok).toBe(false);
    runTo(authority, 1);
    expect(thrust(authority)).toBe(0);
    expect(authority.counters.inputsWithoutShip).toBe(2);
  });

  it('are accepted up to ten seconds and a tick ahead', () => {
    const authority = moonWith('opening');
    expect(send(authority, [input(1, 11, 0, { thrustLevel: 1 })], 0).ok).toBe(true);
    expect(send(authority, [input(2, 12, 0, { thrustLevel: 1 })], 0)).toMatchObject({
      reason: 'inputs[0].tick: expected at most 11, got 12',
    });
  });

  it.each([
    ['inputs[0].seq', input(0, 0, 0, {})],
    ['inputs[0].tick', input(1, 0.5, 0, {})],
    ['inputs[0].tick', input(1, 12, 0, {})],
    ['inputs[0].substep', input(1, 0, -1, {})],
    ['inputs[0].substep', input(1, 0, 100_000, {})],
    ['inputs[0].controls.thrustLevel', input(1, 0, 0, { thrustLevel: Number.NaN })],
    ['inputs[0].controls.rotationInput[1]', input(1, 0, 0, { rotationInput: [0, Infinity, 0] })],
    ['inputs[0].controls.targetAttitude', input(1, 0, 0, { targetAttitude: [0, 0, 0, 0] })],
  ])('are refused by name: %s', (field, bad) => {
    const authority = moonWith('opening');
    const refused = send(authority, [bad, input(2, 0, 0, { thrustLevel: 1 })], 0);
    expect(refused.ok ? '' : refused.reason).toContain(`${field}:`);
    runTo(authority, 1);
    // The valid inputs beside it apply.
    expect(thrust(authority)).toBe(1);
    const { inputsMalformed, inputsFromFuture, inputsApplied } = authority.counters;
    expect([inputsMalformed + inputsFromFuture, inputsApplied]).toEqual([1, 1]);
  });

  it('do not pile up: a flood is refused and counted, and queued ones still apply', () => {
    const authority = moonWith('opening');
    const flood = Array.from({ length: MAX_QUEUED + 500 }, (_, i) => input(i + 1, 5, 0, { thrustLevel: 1 }));
    const refused = send(authority, flood, 0);
    expect(refused.ok ? '' : refused.reason).toContain(`inputs[${MAX_QUEUED}].seq`);
    expect(authority.counters.inputsFlooded).toBe(500);
    runTo(authority, 6);
    expect(authority.counters.inputsApplied).toBe(MAX_QUEUED);
    expect(frameOf(authority).lastInput!.seq).toBe(MAX_QUEUED);
  });
});

describe('pings', () => {
  it('are answered with the tick and the wall time since it', () => {
    const authority = moonWith('opening');
    runTo(authority, 4);
    expect(valueOf(authority.receive('ann', { kind: 'ping', id: 9 }, 4.5))).toEqual({
      kind: 'pong',
      id: 9,
      tick: 4,
      sinceTick: 0.5,
    });
  });

  it('are answered at most 100 times a second', () => {
    const authority = moonWith('opening');
    const answered = Array.from({ length: 250 }, (_, id) =>
      valueOf(authority.receive('ann', { kind: 'ping', id }, id / 1000)),
    ).filter((pong) => pong !== null);
    expect(answered).toHaveLength(100);
    expect(valueOf(authority.receive('ann', { kind: 'ping', id: 1 }, 1.5))).not.toBeNull();
    expect(authority.counters).toMatchObject({ pings: 101, pingsFlooded: 150 });
  });
});
