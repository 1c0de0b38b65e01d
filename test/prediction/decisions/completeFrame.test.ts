import { describe, expect, it } from 'vitest';
import { createPredictor } from '../../../src/prediction';
import { completeFrame } from '../../../src/prediction/snapshots/completeFrame';
import { forgetPast } from '../../../src/prediction/snapshots/receiver';
import type { PartialFrame } from '../../../src/wire';
import { frameAt, helloAt, STILL } from '../faults/restingShip';
import { value } from '../rig';
import { sessionAt } from './sessionAt';

const TICK = 100;
const bare: PartialFrame = { kind: 'frame', tick: TICK + 1, ships: [STILL] };

function completed(given: PartialFrame, session = sessionAt(TICK)) {
  return { session, result: completeFrame(session.sim, session.receiver, given, 0) };
}

describe('a frame without its optional members', () => {
  it('has the last tempo, no pause, and empty lists', () => {
    const { result } = completed(bare);
    expect(value(result)).toMatchObject({ tickRate: 10, timeScale: 1, paused: false });
    expect(value(result)).toMatchObject({ ships: [STILL], bodies: [], events: [], lastInput: null });
  });

  it('has the time scale and the rate that a frame sent last', () => {
    const { session } = completed({ ...bare, tickRate: 20, timeScale: 8 });
    session.sim.newestTick = bare.tick;
    expect(value(completed({ ...bare, tick: TICK + 2 }, session).result)).toMatchObject({
      tickRate: 20,
      timeScale: 8,
    });
  });

  it('has no tempo of an older frame, nor of one that was refused', () => {
    const { session } = completed({ ...bare, tick: TICK - 1, tickRate: 20, timeScale: 8 });
    completed({ ...bare, tickRate: 0 }, session);
    completed({ ...bare, timeScale: -1 }, session);
    expect(value(completed(bare, session).result)).toMatchObject({ tickRate: 10, timeScale: 1 });
  });

  it('has the hello’s tempo before any frame has had one', () => {
    const predictor = createPredictor({ ownShipId: STILL.shipId });
    predictor.receive(helloAt(TICK, 20, { timeScale: 8 }), 0);
    predictor.receive(bare, 0);
    predictor.advance(null, 0.01);
    expect(predictor.view(0.01)).toMatchObject({ tickRate: 20, timeScale: 8 });
  });

  it('is refused with a tick that is not a whole number up to 2⁵², by name', () => {
    for (const tick of [-1, 0.5, 2 ** 52 + 2, Number.NaN, '7' as unknown as number])
      expect(completed({ ...bare, tick }).result).toMatchObject({
        reason: expect.stringMatching(/^frame\.tick: /) as string,
      });
    expect(completed({ ...bare, tick: 2 ** 52 }).result.ok).toBe(true);
  });

  it('is refused with a tempo out of range, by name', () => {
    const rate = completed({ ...bare, tickRate: 0 }).result;
    expect(rate).toMatchObject({ reason: expect.stringMatching(/^frame\.tickRate/) as string });
    const scale = completed({ ...bare, timeScale: -1 }).result;
    expect(scale).toMatchObject({ reason: expect.stringMatching(/^frame\.timeScale/) as string });
  });

  it('keeps the records of a list and counts its other entries', () => {
    const { result, session } = completed({ ...bare, ships: [null, STILL, 7] as never });
    expect(value(result).ships).toEqual([STILL]);
    expect(session.counters).toMatchObject({ shipsRefused: 1, lastRefusal: 'frame.ships: expected records' });
  });
});

describe('an acknowledgement', () => {
  const input = { seq: 3, tick: TICK, substep: 4, margin: 0.1 };

  it.each([input, { ...input, tick: TICK + 1, substep: 0 }])(
    'is accepted up to the frame’s tick: %o',
    (given) => {
      expect(value(completed({ ...bare, lastInput: given }).result).lastInput).toEqual(given);
    },
  );

  it.each([
    { ...input, tick: TICK + 1, substep: 1 },
    { ...input, tick: TICK + 2, substep: 0 },
    { ...input, margin: Number.NaN },
    { ...input, seq: 1.5 },
  ])('of an input that cannot have been applied is dropped and counted: %o', (given) => {
    const { result, session } = completed({ ...bare, lastInput: given });
    expect(value(result).lastInput).toBeNull();
    expect(session.counters.acknowledgementsRefused).toBe(1);
  });
});

it('a time scale that contradicts the game time is measured', () => {
  const session = sessionAt(TICK);
  const scales = [1, 2, 3, 4].map((k) => {
    const frame = frameAt(TICK + 10 * k, 10, { gameTime: 3 * k });
    return value(completed(frame, session).result).timeScale;
  });
  expect(scales[0]).toBe(1);
  expect(scales[3]).toBeCloseTo(3, 9);
});

it('a restarted server has neither the measured tempo nor the one sent before', () => {
  const measured = sessionAt(TICK);
  for (let k = 1; k < 5; k++) completed(frameAt(TICK + 10 * k, 10, { gameTime: 3 * k }), measured);
  const sent = completed({ ...bare, tickRate: 20, timeScale: 8 }).session;
  for (const session of [measured, sent]) {
    forgetPast(session.receiver);
    session.sim.newestTick = -1;
    const { result } = completed({ ...bare, tick: 5, gameTime: 0.5 }, session);
    expect(value(result)).toMatchObject({ tickRate: 10, timeScale: 1 });
  }
});
