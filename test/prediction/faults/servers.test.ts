import { describe, expect, it } from 'vitest';
import { createPredictor } from '../../../src/prediction';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import { createFaultyLine } from './faultyLine';
import { frameAt, helloAt, STILL } from './restingShip';
import { createRig } from '../rig';
import { OWN, thrust, named, feed, range } from './feed';

describe('a server whose time starts again', () => {
  it('accepts the first frame of a new connection at any tick', () => {
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

  it('accepts the first frame of a restarted server of the same world', () => {
    const predictor = createPredictor();
    predictor.receive(helloAt(0, 1), 0);
    const now = feed(predictor, range(0, 9), 1, 0);
    predictor.receive(helloAt(0, 1), now + 2);
    feed(predictor, range(0, 3), 1, now + 2);
    expect(predictor.view(now + 4).tick).toBeLessThan(4);
    expect(predictor.view(now + 4).diagnosis).toMatchObject({ framesDuplicate: 0, framesTooOld: 0 });
  });

  it.each([-199_000, 500_000])(
    'accepts a tick that jumps by %i at the second frame, 50 Hz sent at 10 Hz',
    (by) => {
      const predictor = createPredictor(OWN);
      const now = feed(predictor, range(200_000, 200_500, 5), 50, 0);
      feed(predictor, range(200_500 + by, 200_511 + by, 5), 50, now + 0.1);
      expect(predictor.view(now + 0.3).tick).toBeGreaterThan(200_480 + by);
      expect(predictor.view(now + 0.3).tick).toBeLessThan(200_700 + by);
    },
  );

  it('accepts a restarted server without a hello at its second consecutive frame', () => {
    const predictor = createPredictor(OWN);
    const now = feed(predictor, range(0, 9), 1, 0);
    feed(predictor, range(0, 3), 1, now + 3);
    expect(predictor.view(now + 5).tick).toBeLessThan(4);
  });

  it('accepts the frame after a late one at 0.25 Hz', () => {
    const predictor = createPredictor(OWN);
    const now = feed(predictor, range(0, 4), 0.25, 0);
    predictor.receive(frameAt(4, 0.25), now + 4 + 6);
    predictor.receive(frameAt(5, 0.25), now + 8 + 2.01);
    expect(predictor.view(now + 11).diagnosis).toMatchObject({ framesAccepted: 6, framesFromFuture: 0 });
  });

  it('refuses ticks beyond the safe range, and advance returns', () => {
    const predictor = createPredictor(OWN);
    feed(predictor, range(0, 3), 1, 0);
    for (const tick of [2 ** 53 - 1, 2 ** 52 + 1, 0.5, -1, Number.NaN])
      predictor.receive(frameAt(tick, 1), 3);
    feed(predictor, [2 ** 52 - 1, 2 ** 52], 1, 4);
    predictor.advance(null, 6);
    expect(predictor.view(6).diagnosis.framesRefused).toBe(5);
  });

  it('counts a late frame of the new world as out of order, and refuses one from before its hello', () => {
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

  it('counts staleness and fading in sends, and merges per-ship messages into one snapshot', () => {
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

  it('keeps a ship that one send of a slow server leaves out, and removes it after three', () => {
    const predictor = createPredictor(OWN);
    const shown = (ticks: readonly number[], ships: readonly string[]) => {
      feed(predictor, ticks, 1, ticks[0]!, { ships: ships.map((id) => named(id)) });
      return predictor.view(ticks.at(-1)!).ships.length;
    };
    expect(shown(range(0, 6), ['ship-1', 'ship-2'])).toBe(2);
    expect(shown([6], ['ship-1'])).toBe(2);
    expect(shown([7], ['ship-1', 'ship-2'])).toBe(2);
    expect(shown([8, 9], ['ship-1'])).toBe(2);
    expect(shown([10], ['ship-1'])).toBe(1);
  });

  it('keeps a ship that is sent every fourth tick at 20 Hz, and marks it stale', () => {
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

describe('which ship the page flies', () => {
  const flown = (rig: ReturnType<typeof createRig>) => {
    rig.fly(3);
    for (let i = 0; i < 9; i++) rig.frame({ ...thrust(1), rotationInput: [0.5, 0, 0] });
    return rig;
  };

  it.each(['ship-2', ''])('drops the former ship’s inputs at a hello with ship "%s"', (shipId) => {
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

  it('follows the caller’s ship, removal, teleport and reset', () => {
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

  it('flies ship-1 when a page that flew ship-2 connects to a restarted server', () => {
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
