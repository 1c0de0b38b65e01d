import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createPredictor } from '../../../src/prediction';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import { encodeServerMessage, pendingServerMessage } from '../../../src/wire';
import { createFaultyLine } from './faultyLine';
import { frameAt, helloAt } from './restingShip';
import { createRig } from '../rig';
import { OWN, thrust, named, feed, range } from './feed';

describe('events of a server that sends none', () => {
  it('are confirmed by its states, and none is withdrawn', () => {
    const rig = createRig({ scenario: 'bounce' });
    const { tamper } = rig;
    rig.tamper = (message) => tamper(message.kind === 'frame' ? { ...message, events: [] } : message);
    let withdrawn = 0;
    rig.fly(20, ({ own }) => {
      if ((own?.withdrawn ?? '') !== '') withdrawn += 1;
    });
    const kinds = new Set(rig.notices.map(({ kind }) => kind));
    expect(rig.notices.length).toBeGreaterThanOrEqual(4);
    expect(kinds).toEqual(new Set(['predicted', 'confirmed']));
    expect(withdrawn).toBe(0);
  });
});

describe('what is sent', () => {
  it('is tens of messages when a throttle is dragged for 13 s at a server with whole-tick inputs', () => {
    const line = createFaultyLine({ network: NETWORK_PRESETS.broadband, tickRate: 1, seed: 6 });
    line.run(3);
    for (let i = 0; i < 13 * 60; i++) {
      line.controls = { ...NEUTRAL_CONTROLS, targetAttitude: [0, 0, 0, 1], rotationInput: [0, i / 1000, 0] };
      line.run(1 / 60);
    }
    expect(line.inputs.length).toBeLessThan(100);
    const last = line.inputs.at(-1)!.record;
    line.run(1.5);
    expect(line.inputs.at(-1)!.record.controls.rotationInput[1]).toBe(0.779);
    expect(line.inputs.at(-1)!.record.tick).toBeGreaterThanOrEqual(last.tick);
  });

  it('does not queue up when the host never takes it', () => {
    const predictor = createPredictor(OWN);
    for (let i = 0; i < 4 * 3600; i++) {
      if (i % 10 === 0) predictor.receive(frameAt(i / 10, 0.1), i);
      predictor.advance({ ...NEUTRAL_CONTROLS, attitudeHold: i % 2 === 0 }, i);
    }
    const messages = predictor.takeOutgoing();
    expect(messages.length).toBeLessThan(8);
    expect(predictor.view(4 * 3600).diagnosis.pingsDropped).toBeGreaterThan(10_000);
  });

  it('is sent once and stepped once when advance is called twice per frame', () => {
    const line = createFaultyLine({ network: NETWORK_PRESETS.broadband, tickRate: 1, seed: 6, hello: true });
    line.run(3);
    line.predictor.takeOutgoing();
    line.predictor.advance(thrust(0.2), line.now + 0.02);
    const once = line.predictor.view(line.now + 0.02).diagnosis.steppedSubsteps;
    expect(line.predictor.takeOutgoing().filter(({ kind }) => kind === 'inputs')).toHaveLength(1);
    line.predictor.advance(thrust(0.2), line.now + 0.02);
    expect(line.predictor.takeOutgoing()).toEqual([]);
    expect(line.predictor.view(line.now + 0.02).diagnosis.steppedSubsteps).toBe(once);
  });

  it('holds a key at 0.9 frames a second', () => {
    const line = createFaultyLine({ network: NETWORK_PRESETS.lan, tickRate: 1, seed: 7, hello: true });
    line.run(3);
    let at = line.now;
    for (let i = 0; i < 6; i++) {
      at += 1 / 0.9;
      line.predictor.receive(frameAt(Math.floor(at), 1), at);
      line.predictor.advance({ ...NEUTRAL_CONTROLS, rotationInput: [0, 0.5, 0] }, at);
    }
    expect(line.predictor.view(at).own!.controls.rotationInput[1]).toBe(0.5);
  });
});

describe('history of many ships', () => {
  it('stays within its bound for 1,000 ships at 100 Hz, and is not reallocated between 1 and 100 Hz', () => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 100), 0);
    const ships = Array.from({ length: 1000 }, (_, i) => named(`ship-${i + 1}`));
    let now = 0;
    for (const [tick, rate] of [
      [0, 100],
      [1, 100],
      [2, 1],
      [3, 100],
      [4, 1],
    ] as const) {
      predictor.receive(frameAt(tick, rate, { ships }), now);
      predictor.advance(null, now);
      now += 1 / rate;
    }
    const { diagnosis } = predictor.view(now);
    expect(diagnosis.historyBytes).toBeGreaterThan(1e6);
    expect(diagnosis.historyBytes).toBeLessThan(64 * 2 ** 20);
  });
});

describe('a page that was hidden', () => {
  it('decodes the newest frames only, and reports the events of all', () => {
    const predictor = createPredictor(OWN);
    const heard: number[] = [];
    predictor.onEvent(({ tick }) => heard.push(tick));
    feed(predictor, range(0, 20), 20, 0);
    let decoded = 0;
    for (let tick = 20; tick < 200; tick++) {
      const events =
        tick === 30 || tick === 150
          ? [{ type: 'ship.contact', shipId: 'ship-1', tick: tick - 1, substep: 2 }]
          : [];
      const message = pendingServerMessage(encodeServerMessage(frameAt(tick, 20, { events })));
      const counted = {
        ...message,
        decode: () => {
          decoded += 1;
          return message.decode();
        },
      };
      predictor.receivePending(counted, tick / 20);
    }
    predictor.advance(null, 10);
    expect(decoded).toBe(4);
    expect(heard).toEqual([29, 149]);
    expect(predictor.view(10)).toMatchObject({
      connection: 'live',
      diagnosis: { framesSuperseded: 176, framesAccepted: 24 },
    });
  });

  it('reports each event once after an outage that is longer than the history', () => {
    const predictor = createPredictor(OWN);
    const heard: number[] = [];
    predictor.onEvent(({ tick }) => heard.push(tick));
    feed(predictor, range(0, 20), 20, 0);
    const contact = (tick: number) => ({ type: 'ship.contact', shipId: 'ship-1', tick, substep: 2 });
    for (let tick = 20; tick < 1200; tick++) {
      const events = tick === 30 || tick === 1000 ? [contact(tick - 1)] : [];
      const bytes = encodeServerMessage(frameAt(tick, 20, { events }));
      predictor.receivePending(pendingServerMessage(bytes), tick / 20);
    }
    predictor.advance(null, 60);
    predictor.receive(frameAt(1200, 20, { events: [contact(29), contact(999)] }), 60);
    predictor.advance(null, 60);
    expect(heard).toEqual([29, 999]);
  });

  it('reports the newest 1,000 events of an outage', () => {
    const predictor = createPredictor(OWN);
    const heard: number[] = [];
    predictor.onEvent(({ tick }) => heard.push(tick));
    feed(predictor, range(0, 20), 20, 0);
    for (let tick = 20; tick < 1220; tick++) {
      const events = [{ type: 'ship.contact', shipId: 'ship-1', tick: tick - 1, substep: 2 }];
      const bytes = encodeServerMessage(frameAt(tick, 20, { events }));
      predictor.receivePending(pendingServerMessage(bytes), tick / 20);
    }
    predictor.advance(null, 61);
    // Those of the four newest frames come with their frames.
    expect(heard).toEqual(range(215, 1219));
  });
});

describe('a frame of thousands of new ships', () => {
  const ships = Array.from({ length: 2500 }, (_, i) => named(`ship-${i + 1}`));
  const last = { shipId: 'ship-2500', tick: 4, substep: 2 };

  it('is taken over several calls, the player’s ship in the first, and each event is reported once', () => {
    const predictor = createPredictor({ ...OWN, ownShipId: 'ship-2400' });
    const heard: string[] = [];
    predictor.onEvent(({ shipId }) => heard.push(shipId));
    predictor.receive(frameAt(5, 1, { ships, events: [{ ...last, type: 'ship.contact' }] }), 0);
    const seen = range(0, 4).map((i) => {
      predictor.advance(null, i / 60);
      const { own, ships: shown } = predictor.view(i / 60);
      expect(own?.shipId).toBe('ship-2400');
      return shown.length;
    });
    expect(seen).toEqual([2001, 2500, 2500, 2500]);
    expect(heard).toEqual(['ship-2500']);
  });
});
