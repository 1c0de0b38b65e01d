import { describe, expect, it } from 'vitest';
import { createPredictor, type WorldView } from '../../../src/prediction';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import type { PartialFrame } from '../../../src/wire';
import { frameAt } from '../faults/restingShip';
import { OWN, thrust } from '../faults/feed';
import { CASES } from '../literalServer/cases';
import {
  createLiteralRig,
  type LiteralFlight,
  literalTruthAt,
  withoutTickRate,
} from '../literalServer/literalRig';
import { FIRST_TICK } from '../literalServer/literalServer';
import { SHIP } from '../rig';
import { distance } from '../samples';

const caseNamed = (name: string) => CASES.find((one) => one.name === name)!;

/** A flight of 20 s: drawn and true positions at the instant that the view names, once the rate is known. */
function fly(flight: Omit<LiteralFlight, 'scenario'>, knownAt = 1 + 2 / flight.sends) {
  const warnings: [code: string, details: Readonly<Record<string, unknown>>][] = [];
  const onWarning = (code: string, _: string, details: Readonly<Record<string, unknown>>) =>
    warnings.push([code, details]);
  const rig = createLiteralRig({ scenario: 'slide', ...flight, predictor: { onWarning } });
  const shown: { ticks: number; ahead: number; position: readonly number[]; state: string }[] = [];
  for (let i = 0; i < 60 * 20; i++) {
    const view = rig.frame();
    if (view.own === null || rig.now < knownAt) continue;
    const ticks = view.tick + view.sinceTick * flight.hz;
    const ahead = (ticks - FIRST_TICK) / flight.hz - rig.now;
    shown.push({
      ...{ ticks, ahead, position: [...view.own.easedPosition] },
      state: view.own.surfaceContactState,
    });
  }
  const errors: number[] = [];
  let wrong = 0;
  for (const { ticks, position, state } of shown) {
    const truth = literalTruthAt(rig.server, SHIP, ticks);
    if (truth === null) continue;
    errors.push(distance(position, truth.position));
    if (state !== truth.state) wrong += 1 / 60;
  }
  const ahead = Math.max(...shown.map((one) => one.ahead));
  return { worst: Math.max(...errors), wrong, ahead, warnings, rate: rig.predictor.view(rig.now).tickRate };
}

describe('a server that does not send its tick rate', () => {
  it.each([
    [20, 2],
    [50, 1],
    [50, 50],
    [1, 1],
    [20, 10],
  ])('of %d Hz, %d sends per second, is drawn as one that does', (hz, sends) => {
    const untold = fly({ hz, sends, difference: caseNamed('tick rate not sent') });
    const told = fly({ hz, sends, difference: caseNamed('as told') });
    expect(untold.rate).toBe(hz);
    expect(untold.worst).toBeLessThan(told.worst + 0.05);
    expect(untold.wrong).toBeLessThan(told.wrong + 0.1);
    expect(untold.ahead).toBeLessThan(told.ahead + 0.02);
    const measured = untold.warnings.filter(([code]) => code === 'tick-rate-measured');
    expect(measured).toEqual([['tick-rate-measured', { measured: hz }]]);
    expect(told.warnings.some(([code]) => code === 'tick-rate-measured')).toBe(false);
  });

  it.each([
    ['missing one send in five', { difference: caseNamed('tick rate not sent, sends missed 20 %') }, 3],
    ['on a line that delays and stalls', { network: NETWORK_PRESETS.broken }, 8],
  ])('%s, is drawn to the same instant', (_, more, knownAt) => {
    const flight = { hz: 20, sends: 4, difference: caseNamed('tick rate not sent'), ...more };
    const { rate, ahead } = fly(flight, knownAt);
    expect(Math.abs(rate - 20)).toBeLessThan(0.5);
    expect(ahead).toBeLessThan(0.3);
  });
});

/** Frames without a rate on a line of 20 ms, of which each was sent at `sent` wall s, and the views of each display frame. */
function watch(
  frames: readonly { tick: number; sent: number; more?: Partial<PartialFrame> }[],
  each: (view: WorldView, now: number, stamps: readonly number[]) => void,
) {
  const predictor = createPredictor(OWN);
  const waiting = [...frames];
  const until = frames.at(-1)!.sent + 1;
  for (let i = 0; i / 60 < until; i++) {
    const now = i / 60;
    while (waiting.length > 0 && waiting[0]!.sent + 0.02 <= now) {
      const { tick, more } = waiting.shift()!;
      predictor.receive({ ...withoutTickRate(frameAt(tick, 1)), ...more }, now);
    }
    // A control that changes each display frame makes an input with each stamp.
    predictor.advance(thrust((i % 10) / 1000), now);
    const stamps = predictor
      .takeOutgoing()
      .flatMap((message) => (message.kind === 'inputs' ? message.inputs.map(({ tick }) => tick) : []));
    each(predictor.view(now), now, stamps);
  }
  return predictor;
}

const sendsOf = (count: number, hz: number, every: number, from = { tick: 1000, sent: 0 }) =>
  Array.from({ length: count }, (_, i) => ({
    tick: from.tick + i * every,
    sent: from.sent + (i * every) / hz,
  }));

describe('the clock of a server that does not send its tick rate', () => {
  /** Input lead, s: half of an assumed round trip, slack and a display frame. */
  const LEAD = 0.1;

  it.each([
    [20, 10],
    [1, 1],
    [50, 50],
    [0.2, 1],
  ])(
    'of %d Hz, sent each %d ticks, is never ahead, and inputs are stamped for their arrival',
    (hz, every) => {
      const late: number[] = [];
      const sends = sendsOf(12, hz, every);
      watch(sends, (view, now, stamps) => {
        if (!view.ready) return;
        const heard = sends.filter(({ sent }) => sent + 0.02 <= now).length;
        // The first frames do not give the rate yet: no instant past the newest state and the time since then is drawn.
        const newest = sends[Math.max(0, heard - 1)]!;
        if (heard < 3)
          expect(view.tick - newest.tick + view.sinceTick).toBeLessThan(now - newest.sent + LEAD + 0.01);
        // Records made before are sent for a while.
        else if (now > sends[2]!.sent + 0.5) for (const tick of stamps) late.push((tick - 1000) / hz - now);
      });
      expect(late.length).toBeGreaterThan(20);
      expect(Math.min(...late)).toBeGreaterThan(-0.02 - 1 / hz);
      expect(Math.max(...late)).toBeLessThan(LEAD + 1 / hz);
    },
  );

  it('follows a rate that changes while it runs', () => {
    const before = sendsOf(20, 20, 10);
    const last = before.at(-1)!;
    const after = sendsOf(20, 10, 10, { tick: last.tick + 10, sent: last.sent + 1 });
    const ahead: number[] = [];
    const predictor = watch([...before, ...after], (view, now) => {
      if (now < last.sent + 5) return;
      const ticks = view.tick + view.sinceTick * view.tickRate;
      ahead.push(last.sent + (ticks - last.tick) / 10 - now);
    });
    expect(predictor.view(after.at(-1)!.sent + 1).tickRate).toBe(10);
    expect(Math.max(...ahead.map(Math.abs))).toBeLessThan(LEAD);
  });

  it('takes the rate that the server sends at last', () => {
    const told = sendsOf(30, 20, 10).map((one, i) => ({ ...one, more: i < 10 ? {} : { tickRate: 20 } }));
    const predictor = watch(told, () => undefined);
    expect(predictor.view(15).tickRate).toBe(20);
    expect(predictor.view(15).diagnosis).toMatchObject({ framesRefused: 0, framesFromFuture: 0 });
  });

  it('starts anew on a server that was restarted with another rate', () => {
    const restarted = sendsOf(20, 1, 1, { tick: 0, sent: 12 });
    const ahead: number[] = [];
    const predictor = watch([...sendsOf(20, 20, 10), ...restarted], (view, now) => {
      if (now > 18) ahead.push(view.tick + view.sinceTick - (now - 12));
    });
    expect(predictor.view(32).tickRate).toBe(1);
    expect(Math.max(...ahead.map(Math.abs))).toBeLessThan(LEAD);
  });
});
