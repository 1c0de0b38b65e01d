import { describe, expect, it } from 'vitest';
import {
  createCadence,
  followTickRate,
  forgetCadence,
  horizonOf,
  noteSend,
  sendSeconds,
} from '../../../src/prediction/time/cadence';

/** 20 Hz, sent every 10 s. */
function known() {
  const cadence = createCadence();
  for (let k = 0; k < 8; k++) noteSend(cadence, 200);
  return cadence;
}

describe('the send interval', () => {
  it('is the median of the last intervals: one missed send does not change it', () => {
    const cadence = known();
    noteSend(cadence, 400);
    expect(sendSeconds(cadence, 20)).toBe(10);
    expect(horizonOf(cadence, 20, true)).toBe(30);
  });

  it('limits prediction to the longest recent interval while the server answers no pings', () => {
    const cadence = known();
    expect(horizonOf(cadence, 20, false)).toBe(10.75);
    noteSend(cadence, 400);
    expect(horizonOf(cadence, 20, false)).toBe(20.75);
    for (let k = 0; k < 7; k++) noteSend(cadence, 200);
    expect(horizonOf(cadence, 20, false)).toBe(10.75);
    expect(horizonOf(createCadence(), 20, false)).toBe(5);
  });

  it('is one tick until the second send', () => {
    expect(sendSeconds(createCadence(), 4)).toBe(0.25);
  });

  it('does not change with the tick rate of a server that sends by the clock', () => {
    const cadence = known();
    followTickRate(cadence, 20, 100);
    expect(sendSeconds(cadence, 100)).toBe(10);
    noteSend(cadence, 1000);
    expect(sendSeconds(cadence, 100)).toBe(10);
  });

  it('changes at the next send of a server that sends every n ticks', () => {
    const cadence = known();
    followTickRate(cadence, 20, 10);
    expect(sendSeconds(cadence, 10)).toBe(20);
    noteSend(cadence, 100);
    expect(sendSeconds(cadence, 10)).toBe(10);
  });

  it('keeps its value after a restart until the second send', () => {
    const cadence = known();
    forgetCadence(cadence);
    noteSend(cadence, 0);
    expect(horizonOf(cadence, 20, true)).toBe(30);
    noteSend(cadence, 20);
    expect(sendSeconds(cadence, 20)).toBe(1);
  });
});
