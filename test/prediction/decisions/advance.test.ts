import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { placePresent } from '../../../src/prediction/drawn/worldView';
import { advanceFrame } from '../../../src/prediction/advance';
import { sampleDown } from '../../../src/prediction/time/clock';
import { setTempo } from '../../../src/prediction/time/timeline';
import { viewAt } from '../../../src/prediction/viewAt';
import { RATE, sessionAt, shipAt } from './sessionAt';

const TICK = 100;
/** Client wall s at which the frame of TICK arrived. */
const ARRIVED = 10;
const FRAME = 1 / 60;

/** A pilot whose page has drawn at 60 Hz for a second after a frame of TICK; frames go on arriving. */
function flying(hz = 60) {
  const session = sessionAt(TICK);
  const { sim, clock, receiver, pilot, counters } = session;
  session.granularity = 'substep';
  setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: false }, 0);
  const track = shipAt(sim, 'own', '');
  track.own = true;
  sim.fleet.own = track;
  pilot.last = NEUTRAL_CONTROLS;
  receiver.acceptedAt = ARRIVED;
  sampleDown(clock, 0, ARRIVED);
  let now = ARRIVED;
  const advance = (seconds: number, controls: unknown = null) => {
    now += seconds;
    // A frame for each tick until now.
    const tick = TICK + Math.max(0, Math.floor((now - ARRIVED) * RATE));
    sim.newestTick = tick;
    receiver.acceptedAt = now;
    sampleDown(clock, (tick - TICK) / RATE, ARRIVED + (tick - TICK) / RATE);
    advanceFrame(session, controls as never, now);
    return counters.resyncs;
  };
  for (let i = 0; i < Math.max(hz, 4); i++) advance(1 / hz);
  counters.resyncs = 0;
  return { session, sim, clock, pilot, counters, track, advance, at: () => now };
}

describe('a gap between two frames', () => {
  it('of more than a second is an absence, which causes one resynchronisation', () => {
    expect([flying().advance(0.9), flying().advance(1.1)]).toEqual([0, 1]);
  });

  it('is no absence on a page whose frames always take that long', () => {
    const slow = flying(1);
    expect(slow.session.usualGap).toBeCloseTo(1, 9);
    expect(slow.advance(2.9)).toBe(0);
    expect(flying(1).advance(3.1)).toBe(1);
  });

  it('is compared with a running mean, to which each gap adds a fifth', () => {
    const { session, advance } = flying();
    advance(0.5);
    expect(session.usualGap).toBeCloseTo(0.8 * FRAME + 0.2 * 0.5, 9);
    const before = session.usualGap;
    advance(0);
    expect(session.usualGap).toBe(before);
  });

  it('of more than two seconds releases held keys', () => {
    for (const [seconds, released] of [
      [1.9, null],
      [2.1, NEUTRAL_CONTROLS],
    ] as const) {
      const { pilot, advance } = flying();
      advance(seconds);
      expect(pilot.released).toBe(released);
    }
    const slow = flying(1);
    slow.advance(2.5);
    expect(slow.pilot.released).toBeNull();
  });
});

describe('a frame', () => {
  it('simulates up to the first substep boundary at or after the present', () => {
    const { sim, clock, advance } = flying();
    for (let i = 0; i < 5; i++) {
      advance(FRAME);
      const front = (sim.front.tick - TICK) / RATE + sim.front.substep / (RATE * 10);
      expect(front - clock.present).toBeGreaterThan(-1e-9);
      expect(front - clock.present).toBeLessThan(0.01);
      expect(sim.alpha).toBeCloseTo(1 - (front - clock.present) / 0.01, 6);
    }
  });

  it('samples controls for two substeps before the present', () => {
    const { sim, advance } = flying();
    advance(0.05, { ...NEUTRAL_CONTROLS, thrustLevel: 1 });
    const [input] = sim.inputs.records;
    const behind = (sim.front.tick - input!.tick) * 10 + sim.front.substep - input!.substep;
    expect(behind).toBe(2);
  });

  it.each([
    ['nothing', undefined],
    ['no record', 7],
    ['a record without lists', { ...NEUTRAL_CONTROLS, translationInput: undefined }],
  ])('ignores controls that are %s', (_, controls) => {
    const { sim, advance } = flying();
    advance(FRAME, controls);
    expect(sim.inputs.records).toEqual([]);
  });

  it('notifies listeners of its events', () => {
    const { session, sim, advance } = flying();
    const heard: unknown[] = [];
    session.listeners.add((notice) => heard.push(notice));
    const notice = { kind: 'predicted' } as never;
    sim.notices.push(notice);
    advance(FRAME);
    expect(heard).toContain(notice);
  });

  it('simulates no further than the history reaches', () => {
    const { session, sim } = flying();
    sim.ringLength = 12;
    session.clock.present = 1e6;
    session.clock.updatedAt = Number.NaN;
    advanceFrame(session, null, 1e6);
    expect(sim.front.tick).toBeLessThanOrEqual(sim.newestTick + 12 - 2);
  });
});

describe('the present', () => {
  it.each([
    [4, 0],
    [4.25, 0.25],
    [5, 1],
    [5.5, 1],
    [3.5, 0],
  ])('%f substeps after the tick is %f of the way to a front of 5', (substeps, alpha) => {
    const { sim } = sessionAt(TICK);
    Object.assign(sim.front, { tick: TICK, substep: 5 });
    placePresent(sim, { tick: TICK, substeps });
    expect(sim.alpha).toBeCloseTo(alpha, 9);
  });
});

describe('a view', () => {
  it('between two frames advances at the rate of the present', () => {
    const { session, clock, sim, at } = flying();
    clock.rate = 0.5;
    const present = ({ tick, sinceTick }: { tick: number; sinceTick: number }) =>
      (tick - TICK) / RATE + sinceTick;
    const from = clock.present;
    const later = viewAt(session, at() + 0.004);
    const most = (sim.front.tick - TICK) / RATE + sim.front.substep / (RATE * 10);
    expect(present(later)).toBeCloseTo(Math.min(from + 0.002, most), 6);
  });

  it('has the gauges of the clock', () => {
    const { session, clock, counters, at } = flying();
    Object.assign(clock, { roundTrip: 0.07, rate: 1.03 });
    session.setBack = 4;
    viewAt(session, at());
    expect(counters).toMatchObject({ roundTrip: 0.07, clockRate: 1.03, jitter: 0 });
    expect(counters.clockOffset).toBeCloseTo(clock.offset - 4, 9);
    expect(counters.lead).toBeCloseTo(clock.present - (at() - clock.offset), 9);
  });

  it('reports how long the server has been silent', () => {
    const { session, at } = flying();
    expect(viewAt(session, at() + 2).silence).toBeCloseTo(2, 9);
    expect(viewAt(session, at() - 2).silence).toBe(0);
  });
});
