import { describe, expect, it } from 'vitest';
import { type Controls, NEUTRAL_CONTROLS, SHIP_STRIDE, THRUST_LEVEL } from '../../../src/dynamics';
import { applyDue, isPlanned, seek } from '../../../src/prediction/inputs/scheduledInput';
import {
  acknowledge,
  createInputs,
  forgetRecords,
  prune,
  resend,
  store,
  takeUnsent,
} from '../../../src/prediction/inputs/inputs';
import { createRig } from '../rig';

const thrust = (thrustLevel: number): Controls => ({ ...NEUTRAL_CONTROLS, thrustLevel });

function stored(...stamps: readonly (readonly [tick: number, substep: number])[]) {
  const inputs = createInputs();
  for (const [i, [tick, substep]] of stamps.entries())
    store(inputs, thrust((i + 1) / 10), { tick, substep }, 0, 0);
  return inputs;
}

/** Thrust level after the controls due at (tick, substep) were applied from the start of `from` on. */
function inForce(
  inputs: ReturnType<typeof createInputs>,
  from: number,
  tick: number,
  substep: number,
): number {
  const row = new Float64Array(SHIP_STRIDE);
  applyDue(inputs, seek(inputs, from, 0), { tick, substep }, row, 0);
  return row[THRUST_LEVEL]!;
}

it('a plan ends with the first input that is due, including its future inputs', () => {
  const inputs = createInputs([4, 8].map((tick) => ({ tick, substep: 0, controls: thrust(tick / 10) })));
  store(inputs, thrust(1), { tick: 6, substep: 0 }, 0, 0);
  expect([3, 4, 5, 6, 7, 8, 9].map((tick) => inForce(inputs, 0, tick, 0))).toEqual([0, 0.4, 0.4, 1, 1, 1, 1]);
});

describe('own inputs', () => {
  it('are sent once, as stored, numbered from 1', () => {
    const inputs = stored([3, 10], [3, 50]);
    expect(takeUnsent(inputs).map(({ seq, tick, substep }) => [seq, tick, substep])).toEqual([
      [1, 3, 10],
      [2, 3, 50],
    ]);
    expect(takeUnsent(inputs)).toEqual([]);
    acknowledge(inputs, 4, { seq: 1, tick: 3, substep: 10, margin: 0.5 }, thrust(0.1), 0);
    resend(inputs);
    expect(takeUnsent(inputs).map(({ seq }) => seq)).toEqual([2]);
  });

  it('take effect at their substep, the last one of a substep winning', () => {
    const inputs = stored([3, 10], [3, 50], [3, 50]);
    expect(inForce(inputs, 3, 3, 9)).toBe(0);
    expect(inForce(inputs, 3, 3, 10)).toBe(0.1);
    expect(inForce(inputs, 3, 3, 50)).toBe(0.3);
    expect(inForce(inputs, 4, 4, 0)).toBe(0);
  });

  it('take effect where the server says: later when late, and from the newest frame on when not yet acknowledged', () => {
    const inputs = stored([3, 10], [3, 50]);
    expect(acknowledge(inputs, 4, { seq: 1, tick: 3, substep: 10, margin: 0.5 }, thrust(0.1), 0)).toBe(
      'late',
    );
    expect(inForce(inputs, 4, 4, 0)).toBe(0.2);
    expect(acknowledge(inputs, 5, { seq: 2, tick: 4, substep: 7, margin: -0.1 }, thrust(0.2), 0)).toBe(
      'late',
    );
    expect(inForce(inputs, 4, 4, 6)).toBe(0);
    expect(inForce(inputs, 4, 4, 7)).toBe(0.2);
    expect(acknowledge(inputs, 6, { seq: 2, tick: 4, substep: 7, margin: -0.1 }, thrust(0.2), 0)).toBe(
      'asPredicted',
    );
  });

  it('are given up as lost when overdue', () => {
    const inputs = stored([3, 10]);
    inputs.acknowledges = true;
    expect(acknowledge(inputs, 4, null, NEUTRAL_CONTROLS, 1)).toBe('late');
    expect(acknowledge(inputs, 8, null, NEUTRAL_CONTROLS, 5)).toBe('lost');
    expect(inputs.records).toHaveLength(0);
  });

  it('are inferred from the sent controls when a server acknowledges nothing', () => {
    const inputs = stored([3, 0], [4, 0], [5, 0]);
    expect(acknowledge(inputs, 5, null, thrust(0.2), 0)).toBe('asPredicted');
    expect(inputs.applied).toBe(2);
    expect(acknowledge(inputs, 6, null, thrust(0.2), 0)).toBe('late');
    expect(inForce(inputs, 6, 6, 0)).toBe(0.3);
  });

  it('are ignored when not finite, and clamped when out of range', () => {
    const rig = createRig({ scenario: 'bounce' });
    rig.fly(3);
    for (const bad of [Number.NaN, Number.POSITIVE_INFINITY]) rig.frame(thrust(bad));
    expect(rig.sentInputs).toEqual([]);
    for (let i = 0; i < 5; i++) rig.frame(thrust(7));
    expect(rig.sentInputs).toHaveLength(1);
    expect(rig.sentInputs[0]!.controls.thrustLevel).toBe(1);
  });

  it('hold for other pilots 1.5 tick intervals without news, then the stick is released', () => {
    const rig = createRig({ scenario: 'bounce', others: 1 });
    rig.authority.join('player-1', 'other-1');
    rig.fly(3);
    const tick = rig.authority.tickNumber();
    const record = { seq: 1, tick, substep: 0, controls: thrust(0.12) };
    rig.authority.receive('player-1', { kind: 'inputs', inputs: [record] }, rig.now);
    rig.fly(2.5);
    const level = () => rig.view().ships.find(({ shipId }) => shipId === 'other-1')!.controls.thrustLevel;
    expect(level()).toBe(0.12);
    rig.exchange.drop('me');
    rig.fly(0.8);
    expect(level()).toBe(0.12);
    rig.fly(1.8);
    expect(level()).toBe(0);
    rig.exchange.reconnect('me', rig.now);
    rig.fly(1.5);
    expect(level()).toBe(0.12);
  });
});

describe('a scheduled input plan', () => {
  const plan = [
    { tick: 0, substep: 0, controls: thrust(0.1) },
    { tick: 2, substep: 30, controls: thrust(0.2) },
    { tick: 8, substep: 0, controls: thrust(0.3) },
  ];

  it('takes effect at its substeps, from any start of a replay', () => {
    const inputs = createInputs(plan);
    expect(inForce(inputs, 0, 2, 29)).toBe(0.1);
    expect(inForce(inputs, 0, 2, 30)).toBe(0.2);
    expect(inForce(inputs, 2, 7, 99)).toBe(0.2);
    expect(inForce(inputs, 3, 7, 99)).toBe(0);
    expect(inForce(inputs, 3, 8, 0)).toBe(0.3);
    expect(takeUnsent(inputs)).toEqual([]);
  });

  it('ends where the first input takes effect, also when that turns out to be later', () => {
    const inputs = createInputs(plan);
    store(inputs, thrust(0.9), { tick: 2, substep: 10 }, 0, 0);
    expect(inForce(inputs, 0, 2, 9)).toBe(0.1);
    expect(inForce(inputs, 0, 9, 0)).toBe(0.9);
    expect(acknowledge(inputs, 4, { seq: 1, tick: 3, substep: 0, margin: -1 }, thrust(0.9), 0)).toBe('late');
    expect(inForce(inputs, 0, 2, 99)).toBe(0.2);
    expect(inForce(inputs, 0, 9, 0)).toBe(0.9);
  });

  it('does not return when the input that ended it is forgotten', () => {
    const pruned = createInputs(plan);
    for (const tick of [1, 20]) store(pruned, thrust(0.9), { tick, substep: 0 }, 0, 0);
    acknowledge(pruned, 2, { seq: 1, tick: 1, substep: 0, margin: 1 }, thrust(0.9), 0);
    prune(pruned, 5);
    expect(inForce(pruned, 6, 9, 0)).toBe(0);
    const anew = createInputs(plan);
    store(anew, thrust(0.9), { tick: 1, substep: 0 }, 0, 0);
    forgetRecords(anew);
    expect(inForce(anew, 6, 9, 0)).toBe(0);
  });

  it('continues after a jump in time that found no input', () => {
    const inputs = createInputs(plan);
    forgetRecords(inputs);
    expect(inForce(inputs, 6, 9, 0)).toBe(0.3);
  });

  it('can be ended as long as part of it remains', () => {
    const inputs = createInputs(plan);
    expect(isPlanned(inputs, { tick: 8, substep: 0 })).toBe(true);
    expect(isPlanned(inputs, { tick: 8, substep: 1 })).toBe(false);
    store(inputs, thrust(0), { tick: 1, substep: 0 }, 0, 0);
    expect(isPlanned(inputs, { tick: 0, substep: 0 })).toBe(false);
    expect(isPlanned(createInputs(), { tick: 0, substep: 0 })).toBe(false);
  });
});
