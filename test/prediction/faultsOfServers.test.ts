import { describe, expect, it } from 'vitest';
import { type Controls, NEUTRAL_CONTROLS } from '../../src/dynamics';
import { createPredictor, type Predictor } from '../../src/prediction';
import { NETWORK_PRESETS } from '../../src/scenarios';
import { encodeServerMessage, pendingServerMessage, type ServerFrame, type ShipState } from '../../src/wire';
import { createFaultyLine, frameAt, helloAt, STILL } from './faultyLine';
import { createRig } from './rig';

const OWN = { ownShipId: 'ship-1' };
const thrust = (thrustLevel: number): Controls => ({ ...NEUTRAL_CONTROLS, thrustLevel });
const named = (shipId: string, more: Partial<ShipState> = {}): ShipState => ({ ...STILL, shipId, ...more });

/** Frames of these ticks, each when a server of `rate` Hz sends it, and a display frame after each. */
function feed(
  predictor: Predictor,
  ticks: Iterable<number>,
  rate: number,
  from: number,
  more: Partial<ServerFrame> = {},
) {
  let now = from;
  let first = Number.NaN;
  for (const tick of ticks) {
    if (Number.isNaN(first)) first = tick;
    now = from + (tick - first) / rate;
    predictor.receive(frameAt(tick, rate, more), now);
    predictor.advance(null, now);
  }
  return now;
}

const range = (from: number, to: number, step = 1) =>
  Array.from({ length: Math.ceil((to - from) / step) }, (_, i) => from + i * step);

describe('time that starts again', () => {
  it('takes the first frame of a new connection, whatever it counts from', () => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 1), 0);
    const now = feed(predictor, range(0, 9), 1, 0);
    predictor.receive(
      helloAt(0, 1, { settings: { ...helloAt(0, 1).settings, contactFrictionKinetic: 0.5 } }),
      now + 2,
    );
    predictor.receive(frameAt(0, 1, { ships: [named('ship-1', { fuel: 55 })] }), now + 2);
    predictor.advance(null, now + 2);
    expect(predictor.view(now + 2)).toMatchObject({ tick: 0, own: { fuel: 55 } });
    expect(predictor.view(now + 2).diagnosis.framesDuplicate).toBe(0);
  });

  it('takes the first frame of a restarted server of the same world', () => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 1), 0);
    const now = feed(predictor, range(0, 9), 1, 0);
    predictor.receive(helloAt(0, 1), now + 2);
    feed(predictor, range(0, 3), 1, now + 2);
    expect(predictor.view(now + 4).tick).toBeLessThan(4);
    expect(predictor.view(now + 4).diagnosis).toMatchObject({ framesDuplicate: 0, framesTooOld: 0 });
  });

  it.each([-199_000, 500_000])(
    'believes a counter that jumps by %i with the second frame, 50 Hz sent at 10 Hz',
    (by) => {
      const predictor = createPredictor(OWN);
      const now = feed(predictor, range(200_000, 200_500, 5), 50, 0);
      feed(predictor, range(200_500 + by, 200_511 + by, 5), 50, now + 0.1);
      expect(predictor.view(now + 0.3).tick).toBeGreaterThan(200_480 + by);
      expect(predictor.view(now + 0.3).tick).toBeLessThan(200_700 + by);
    },
  );

  it('believes a server without a hello that began anew with the second frame that goes on', () => {
    const predictor = createPredictor(OWN);
    const now = feed(predictor, range(0, 9), 1, 0);
    feed(predictor, range(0, 3), 1, now + 3);
    expect(predictor.view(now + 5).tick).toBeLessThan(4);
  });

  it('takes the frame after a late one at 0.25 Hz', () => {
    const predictor = createPredictor(OWN);
    const now = feed(predictor, range(0, 4), 0.25, 0);
    predictor.receive(frameAt(4, 0.25), now + 4 + 6);
    predictor.receive(frameAt(5, 0.25), now + 8 + 2.01);
    expect(predictor.view(now + 11).diagnosis).toMatchObject({ framesAccepted: 6, framesFromFuture: 0 });
  });

  it('refuses ticks that cannot be counted, and comes back from advance', () => {
    const predictor = createPredictor(OWN);
    feed(predictor, range(0, 3), 1, 0);
    for (const tick of [2 ** 53 - 1, 2 ** 52 + 1, 0.5, -1, Number.NaN])
      predictor.receive(frameAt(tick, 1), 3);
    feed(predictor, [2 ** 52 - 1, 2 ** 52], 1, 4);
    predictor.advance(null, 6);
    expect(predictor.view(6).diagnosis.framesRefused).toBe(5);
  });

  it('takes a frame overtaken after a new world as out of order, and none from before its hello', () => {
    const predictor = createPredictor();
    const heard: string[] = [];
    predictor.onEvent(({ kind, type, tick }) => heard.push(`${kind} ${type} ${tick}`));
    predictor.receive(helloAt(0, 1), 0);
    feed(predictor, range(0, 30), 1, 0);
    predictor.receive(helloAt(5, 1), 30);
    predictor.receive(frameAt(6, 1), 31);
    predictor.receive(frameAt(8, 1), 33);
    const events = [{ type: 'ship.contact', shipId: 'ship-1', tick: 6, substep: 50 }];
    predictor.receive(frameAt(7, 1, { events }), 33.1);
    predictor.receive(frameAt(4, 1, { events: [{ ...events[0]!, tick: 3 }] }), 33.2);
    expect(predictor.view(33.2).diagnosis).toMatchObject({ framesOutOfOrder: 1, framesTooOld: 1 });
    expect(heard).toEqual(['confirmed ship.contact 6']);
  });

  it('counts staleness and fading in sends, and takes one message a ship for parts of one snapshot', () => {
    const predictor = createPredictor(OWN);
    let stale = 0;
    let missing = 0;
    for (let i = 0; i < 100; i++) {
      const tick = i * 5;
      const ships = i % 10 === 9 ? [] : ['ship-1'];
      for (const id of [...ships, 'ship-2'])
        predictor.receive(frameAt(tick, 50, { ships: [named(id)] }), tick / 50);
      for (let k = 0; k < 6; k++) {
        const now = tick / 50 + k / 60;
        predictor.advance(null, now);
        const { ships: seen } = predictor.view(now);
        if (i < 3) continue;
        if (seen.length < 2) missing += 1;
        if (seen.some(({ provenance }) => provenance === 'stale')) stale += 1;
      }
    }
    expect(missing).toBe(0);
    expect(stale).toBe(0);
    expect(predictor.view(10).diagnosis.framesDuplicate).toBe(0);
  });

  it('keeps a ship that is sent every fourth tick at 20 Hz, and shows it stale', () => {
    const predictor = createPredictor(OWN);
    let left = 0;
    let stale = 0;
    for (let tick = 0; tick < 400; tick++) {
      const ships = tick % 4 === 0 ? [STILL, named('ship-2')] : [STILL];
      predictor.receive(frameAt(tick, 20, { ships }), tick / 20);
      predictor.advance(null, tick / 20);
      const other = predictor.view(tick / 20).ships.find(({ shipId }) => shipId === 'ship-2');
      if (other === undefined) left += 1;
      else if (other.provenance === 'stale') stale += 1;
    }
    expect(left).toBe(0);
    expect(stale).toBeGreaterThan(50);
  });

  it('counts staleness in sends at 50 Hz sent once a second', () => {
    const line = createFaultyLine({
      network: NETWORK_PRESETS.broadband,
      tickRate: 50,
      sendEvery: 50,
      seed: 1,
    });
    line.run(4);
    let stale = 0;
    line.run(10, ({ own }) => {
      if (own!.provenance === 'stale') stale += 1;
    });
    expect(stale).toBe(0);
  });
});

describe('who flies what', () => {
  const flown = (rig: ReturnType<typeof createRig>) => {
    rig.fly(3);
    for (let i = 0; i < 9; i++) rig.frame({ ...thrust(1), rotationInput: [0.5, 0, 0] });
    return rig;
  };

  it.each(['ship-2', ''])('drops the old ship’s inputs at a hello with ship "%s"', (shipId) => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 1), 0);
    feed(predictor, range(0, 3), 1, 0, { ships: [STILL, named('ship-2')] });
    predictor.advance(thrust(1), 2.1);
    predictor.advance(thrust(0.5), 2.2);
    predictor.receive(helloAt(2, 1, { shipId }), 2.3);
    const sent = predictor
      .takeOutgoing()
      .flatMap((message) => (message.kind === 'inputs' ? message.inputs : []));
    expect(sent).toEqual([]);
    predictor.advance(null, 2.4);
    predictor.advance(null, 2.5);
    const { own, ships } = predictor.view(2.5);
    expect(own?.shipId ?? '').toBe(shipId);
    for (const ship of ships) expect(ship.controls.thrustLevel).toBe(0);
  });

  it('takes the ship, its removal, a teleport and a reset from the caller', () => {
    const rig = flown(createRig({ scenario: 'bounce', others: 2 }));
    rig.predictor.setOwnShip('other-1');
    expect(rig.predictor.takeOutgoing().filter(({ kind }) => kind === 'inputs')).toEqual([]);
    rig.predictor.advance(null, rig.now + 1 / 60);
    expect(rig.predictor.view(rig.now + 1 / 60).own!.shipId).toBe('other-1');
    rig.predictor.removeShip('other-2', 'destroyed');
    rig.predictor.advance(null, rig.now + 2 / 60);
    expect(rig.predictor.view(rig.now + 2 / 60).ships.map(({ shipId }) => shipId)).not.toContain('other-2');
    expect(rig.notices.at(-1)).toMatchObject({
      kind: 'confirmed',
      shipId: 'other-2',
      type: 'ship.destroyed',
    });
    rig.predictor.setOwnShip(null);
    rig.predictor.advance(null, rig.now + 3 / 60);
    expect(rig.predictor.view(rig.now + 3 / 60).own).toBeNull();
    rig.predictor.reset();
    expect(rig.predictor.view(rig.now + 4 / 60)).toMatchObject({ ready: false, connection: 'waiting' });
  });

  it('goes on as ship-1 where a page that flew ship-2 meets a server that began anew', () => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 20, { shipId: 'ship-2' }), 0);
    const now = feed(predictor, range(0, 100), 20, 0, { ships: [STILL, named('ship-2')] });
    predictor.receive(helloAt(0, 20, { shipId: 'ship-1' }), now + 1);
    feed(predictor, range(0, 60), 20, now + 1);
    expect(predictor.view(now + 4)).toMatchObject({
      own: { shipId: 'ship-1', surfaceContactState: 'landed' },
    });
  });
});

describe('messages that are valid and still wrong', () => {
  it('throws at nothing that a plain caller hands in, and warns of each kind once', () => {
    const codes: string[] = [];
    const predictor = createPredictor({ ...OWN, onWarning: (code) => codes.push(code) });
    feed(predictor, range(0, 3), 1, 0);
    const anything = [
      undefined,
      null,
      1,
      'x',
      {},
      [],
      { kind: 'frame' },
      { kind: 'hello' },
      { kind: 'pong' },
      { kind: 'x' },
    ];
    for (const message of anything) predictor.receive(message as never, 3);
    for (const ships of [undefined, null, [undefined], [null], [{}], [{ ...STILL, position: undefined }]])
      predictor.receive({ kind: 'frame', tick: 3, ships } as never, 3);
    predictor.receive(
      { ...frameAt(4, 1), bodies: undefined, events: null, lastInput: undefined } as never,
      4,
    );
    predictor.receive({ ...frameAt(5, 1), bodies: [{ name: 'Moon', position: { x: 1 } }] } as never, 5);
    for (const now of [Number.NaN, Number.NEGATIVE_INFINITY, undefined]) {
      predictor.advance(null, now as never);
      predictor.receive(frameAt(6, 1), now as never);
      predictor.view(now as never);
    }
    for (const controls of [undefined, {}, { ...NEUTRAL_CONTROLS, rotationInput: null }, 7])
      predictor.advance(controls as never, 6);
    predictor.advance(null, 6.1);
    const { own, diagnosis } = predictor.view(6.1);
    expect(own!.position.every(Number.isFinite)).toBe(true);
    expect(diagnosis.framesRefused).toBeGreaterThan(8);
    expect(new Set(codes).size).toBe(codes.length);
    expect(codes).toContain('now-not-finite');
    expect(codes).toContain('message-kind');
  });

  it('refuses a pong and an acknowledgement that cannot be', () => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 1), 0);
    feed(predictor, range(0, 3), 1, 0);
    predictor.advance(thrust(0.3), 2.1);
    const sent = predictor.takeOutgoing().filter(({ kind }) => kind === 'ping');
    expect(sent.length).toBeGreaterThan(0);
    predictor.receive({ kind: 'pong', id: 1, tick: 2, sinceTick: Number.NaN }, 2.2);
    const lastInput = { seq: 1, tick: 3 + 1_000_000, substep: 4, margin: 0 };
    predictor.receive(frameAt(3, 1, { lastInput }), 3);
    predictor.advance(thrust(0.6), 3.1);
    predictor.advance(thrust(0.6), 3.2);
    const [inputs] = predictor.takeOutgoing().flatMap((m) => (m.kind === 'inputs' ? [m.inputs] : []));
    expect(inputs!.at(-1)!.tick).toBeLessThan(5);
    expect(predictor.view(3.2).diagnosis.acknowledgementsRefused).toBe(1);
  });

  it('tells every listener though one throws', () => {
    const heard: string[] = [];
    const predictor = createPredictor(OWN);
    predictor.onEvent(() => {
      throw new Error('mine');
    });
    predictor.onEvent(({ type }) => heard.push(type));
    feed(predictor, range(0, 3), 1, 0);
    const events = [{ type: 'ship.tipped', shipId: 'ship-1', tick: 2, substep: 3 }];
    predictor.receive(frameAt(3, 1, { events }), 3);
    expect(heard).toEqual(['ship.tipped']);
  });

  it('starts bodies that are not told at the first frame’s own tick', () => {
    const moving = { ...helloAt(0, 1).bodies[0]!, velocity: [1000, 0, 0] as const };
    const predictor = createPredictor({ ...OWN, defaults: { bodies: [moving] } });
    const ships = [
      named('ship-1', { relativePosition: null, relativeVelocity: null, velocity: [1000, 0, 0] }),
    ];
    predictor.receive(frameAt(1000, 1, { bodies: [], ships }), 0);
    predictor.advance(null, 0);
    expect(predictor.view(0).own!.position[0]).toBeCloseTo(0, 6);
  });

  it('carries bodies on by their velocity where a server sends old ones', () => {
    const body = { ...helloAt(0, 1).bodies[0]!, velocity: [1000, 0, 0] as const };
    const predictor = createPredictor(OWN);
    for (let tick = 0; tick < 8; tick++) {
      const ship = named('ship-1', {
        position: [1000 * tick, STILL.position[1], 0],
        velocity: [1000, 0, 0],
        relativePosition: null,
        relativeVelocity: null,
      });
      predictor.receive(frameAt(tick, 1, { bodies: [body], ships: [ship] }), tick);
      predictor.advance(null, tick);
    }
    expect(Math.abs(predictor.view(7).own!.position[0]!)).toBeLessThan(1e-3);
  });

  it('reports a spin that was told wrong', () => {
    const predictor = createPredictor(OWN);
    const [body] = helloAt(0, 1).bodies;
    feed(predictor, range(0, 3), 1, 0, { bodies: [{ ...body!, angularVelocity: [0, 0.01, 0] }] });
    feed(predictor, [3], 1, 3);
    expect(predictor.view(3).diagnosis.correctionsBody).toBeGreaterThan(0);
    expect(predictor.view(3).diagnosis.errorBodySpin).toBeCloseTo(0.01, 9);
  });

  it('measures game time that is not told: ten times as fast', () => {
    const predictor = createPredictor(OWN);
    const [body] = helloAt(0, 1).bodies;
    for (let tick = 0; tick < 6; tick++) {
      const position = [tick * 10 * 1000, 0, 0] as const;
      predictor.receive(frameAt(tick, 1, { bodies: [{ ...body!, position, velocity: [1000, 0, 0] }] }), tick);
      predictor.advance(null, tick);
    }
    expect(predictor.view(5).timeScale).toBeCloseTo(10, 6);
  });
});

describe('events of a server that does not tell them', () => {
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
  it('is tens of messages where a throttle is dragged for 13 s at a server of whole ticks', () => {
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

  it('does not queue for a host that never takes it', () => {
    const predictor = createPredictor(OWN);
    for (let i = 0; i < 4 * 3600; i++) {
      if (i % 10 === 0) predictor.receive(frameAt(i / 10, 0.1), i);
      predictor.advance({ ...NEUTRAL_CONTROLS, attitudeHold: i % 2 === 0 }, i);
    }
    const messages = predictor.takeOutgoing();
    expect(messages.length).toBeLessThan(8);
    expect(predictor.view(4 * 3600).diagnosis.pingsDropped).toBeGreaterThan(10_000);
  });

  it('is nothing more, and costs no substep, where advance is called twice in a frame', () => {
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

describe('the memory of many ships', () => {
  it('stays within its bound for 1,000 ships at 100 Hz, and is not made anew by turns of 1 and 100 Hz', () => {
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
  it('decodes the newest frames alone, and tells the events of all', () => {
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
});
