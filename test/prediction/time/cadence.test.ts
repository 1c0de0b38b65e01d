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

describe('how often a server sends', () => {
  it('is the median of the last sends: one that is missed does not count', () => {
    const cadence = known();
    noteSend(cadence, 400);
    expect(sendSeconds(cadence, 20)).toBe(10);
    expect(horizonOf(cadence, 20, true)).toBe(30);
  });

  it('bounds the prediction of a server that answers no pings by the longest of the last intervals', () => {
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

  it('stays at a faster tick rate, for a server that sends by the clock', () => {
    const cadence = known();
    followTickRate(cadence, 20, 100);
    expect(sendSeconds(cadence, 100)).toBe(10);
    noteSend(cadence, 1000);
    expect(sendSeconds(cadence, 100)).toBe(10);
  });

  it('is the next send’s after a change, for one that sends every so many ticks', () => {
    const cadence = known();
    followTickRate(cadence, 20, 10);
    expect(sendSeconds(cadence, 10)).toBe(20);
    noteSend(cadence, 100);
    expect(sendSeconds(cadence, 10)).toBe(10);
  });

  it('is the old one after a restart, until the second send', () => {
    const cadence = known();
    forgetCadence(cadence);
    noteSend(cadence, 0);
    expect(horizonOf(cadence, 20, true)).toBe(30);
    noteSend(cadence, 20);
    expect(sendSeconds(cadence, 20)).toBe(1);
  });
});
