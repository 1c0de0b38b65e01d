import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createPredictor } from '../../../src/prediction';
import { frameAt, helloAt, STILL } from './restingShip';
import { OWN, thrust, named, feed, range } from './feed';

describe('messages that decode but are wrong', () => {
  it('keeps the current world when a hello has another major version, and accepts a newer minor one', () => {
    const predictor = createPredictor(OWN);
    feed(predictor, range(0, 3), 1, 0);
    const before = [...predictor.view(2).own!.position];
    predictor.receive(helloAt(3, 1, { protocolVersion: '2.0', shipId: 'other' }), 2);
    const { own, diagnosis } = predictor.view(2);
    expect(diagnosis.lastRefusal).toBe('hello.protocolVersion: expected 1.x, got 2.0');
    expect(diagnosis.helloReceived).toBe(false);
    expect([...own!.position]).toEqual(before);
    predictor.receive(helloAt(3, 1, { protocolVersion: '1.9' }), 2);
    expect(predictor.view(2).diagnosis).toMatchObject({ helloReceived: true, framesRefused: 1 });
  });

  it('never throws for any argument, and warns once per kind', () => {
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

  it('refuses an impossible pong or acknowledgement', () => {
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

  it('calls every listener even when one throws', () => {
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

  it('draws a ship at its states once its class is unknown, and predicts it again once it is known', () => {
    const predictor = createPredictor(OWN);
    const [x, y, z] = STILL.position;
    const at = (tick: number, shipClass: string, up: number) => {
      const position = [x, y + up, z] as const;
      const ship = named('ship-1', { shipClass, position, relativePosition: position });
      feed(predictor, [tick], 1, tick, { ships: [ship] });
      return [...predictor.view(tick).own!.position];
    };
    feed(predictor, range(0, 3), 1, 0);
    for (const tick of [3, 4]) expect(at(tick, 'unheard of', 5)).toEqual([x, y + 5, z]);
    expect(predictor.view(4).own).toMatchObject({ provenance: 'off', surfaceContactState: 'landed' });
    at(5, STILL.shipClass, 0);
    expect(Math.hypot(...at(6, STILL.shipClass, 0))).toBeCloseTo(y, 3);
  });

  it('starts bodies that are not sent at the first frame’s tick', () => {
    const moving = { ...helloAt(0, 1).bodies[0]!, velocity: [1000, 0, 0] as const };
    const predictor = createPredictor({ ...OWN, defaults: { bodies: [moving] } });
    const ships = [
      named('ship-1', { relativePosition: null, relativeVelocity: null, velocity: [1000, 0, 0] }),
    ];
    predictor.receive(frameAt(1000, 1, { bodies: [], ships }), 0);
    predictor.advance(null, 0);
    expect(predictor.view(0).own!.position[0]).toBeCloseTo(0, 6);
  });

  it('moves bodies by their velocity when a server sends outdated ones', () => {
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

  it('reports a wrong spin', () => {
    const predictor = createPredictor(OWN);
    const [body] = helloAt(0, 1).bodies;
    feed(predictor, range(0, 3), 1, 0, { bodies: [{ ...body!, angularVelocity: [0, 0.01, 0] }] });
    feed(predictor, [3], 1, 3);
    expect(predictor.view(3).diagnosis.correctionsBody).toBeGreaterThan(0);
    expect(predictor.view(3).diagnosis.errorBodySpin).toBeCloseTo(0.01, 9);
  });

  it('measures a time scale that is not sent from the first three frames: ten times as fast', () => {
    const predictor = createPredictor(OWN);
    const [body] = helloAt(0, 1).bodies;
    for (let tick = 0; tick < 3; tick++) {
      const position = [tick * 10 * 1000, 0, 0] as const;
      predictor.receive(frameAt(tick, 1, { bodies: [{ ...body!, position, velocity: [1000, 0, 0] }] }), tick);
      predictor.advance(null, tick);
    }
    expect(predictor.view(2).timeScale).toBeCloseTo(10, 6);
  });
});
