/** A predictor that continues from a snapshot or in a worker, and one that is disposed. */
import { MessageChannel } from 'node:worker_threads';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import {
  type Channel,
  connectPredictor,
  createPredictor,
  type RemotePredictor,
  servePredictor,
  type WorldView,
} from '../../../src/prediction';
import type { Hello, ServerMessage } from '../../../src/wire';
import { createRig } from '../rig';

const options = (rig: ReturnType<typeof createRig>) => ({
  terrains: { [rig.loaded.scenario.terrain]: rig.loaded.terrainHeight },
});

describe('a snapshot', () => {
  it('survives JSON, and the landing continues from it without a mismatch', () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 5 });
    rig.fly(3.3);
    const before = rig.view().own!;
    const place = [...before.position];
    const text = JSON.stringify(rig.predictor.snapshot(rig.now));
    rig.predictor.dispose();
    rig.predictor = createPredictor(options(rig));
    expect(rig.predictor.restore(JSON.parse(text), rig.now)).toEqual({ ok: true, value: null });
    rig.frame();
    const after = rig.view().own!;
    const moved = Math.hypot(...place.map((x, i) => x - after.position[i]!));
    // Motion of a frame, and the new clock's uncertainty: 100 ms at 40 m/s.
    expect(moved).toBeLessThan(4);
    rig.fly(25);
    const { own, diagnosis } = rig.view();
    expect([own!.shownState, own!.provenance]).toEqual(['landed', 'confirmed']);
    expect(diagnosis.correctionsMismatch).toBe(0);
    expect(diagnosis.framesRefused).toBe(0);
  });

  it('keeps unacknowledged inputs, which are sent again under their numbers', () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 1, holdBack: () => Infinity });
    rig.fly(2);
    for (let i = 0; i < 5; i++) rig.frame({ ...NEUTRAL_CONTROLS, thrustLevel: i / 10 });
    const sent = rig.sentInputs.slice();
    expect(sent.length).toBeGreaterThan(2);
    const snapshot = rig.predictor.snapshot(rig.now);
    const next = createPredictor(options(rig));
    next.restore(JSON.parse(JSON.stringify(snapshot)), rig.now);
    const again = next.takeOutgoing().flatMap((message) => (message.kind === 'inputs' ? message.inputs : []));
    expect(again).toEqual(sent);
    const numbered = (nextSeq: number) => {
      next.restore({ ...snapshot, nextSeq }, rig.now);
      return next.snapshot(rig.now).nextSeq;
    };
    // Whichever is later: the snapshot's number, or the one after its last input.
    expect([numbered(900), numbered(1)]).toEqual([900, sent.at(-1)!.seq + 1]);
  });

  it('keeps the bodies and the time scale that the newest frame left out', () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 10, legacy: true });
    rig.tamper = (message) =>
      [
        message.kind === 'frame' && message.tick > 1
          ? { kind: 'frame', tick: message.tick, ships: message.ships, bodies: [] }
          : message,
      ] as ServerMessage[];
    rig.fly(3);
    const { bodies, tickRate } = rig.view();
    const snapshot = rig.predictor.snapshot(rig.now);
    rig.predictor = createPredictor({
      ...options(rig),
      ownShipId: 'ship-1',
      defaults: { terrain: rig.loaded.scenario.terrain },
    });
    expect(rig.predictor.restore(JSON.parse(JSON.stringify(snapshot)), rig.now).ok).toBe(true);
    rig.frame();
    const after = rig.view();
    expect([after.tickRate, after.bodies.length]).toEqual([tickRate, bodies.length]);
    // A body moves by up to 30 km in a second: two frames, and the new clock's uncertainty.
    const moved = Math.hypot(...bodies[0]!.position.map((x, i) => x - after.bodies[0]!.position[i]!));
    expect(moved).toBeLessThan(30_000 * 0.2);
    rig.fly(20);
    expect(rig.view().own!.shownState).toBe('landed');
  });

  it('holds no refused hello, and only the newest accepted frame', () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 5 });
    let hello: Hello | null = null;
    rig.tamper = (message) => {
      if (message.kind === 'hello') hello = message;
      return [message];
    };
    rig.fly(3);
    const before = rig.predictor.snapshot(rig.now);
    const { tick } = before.frame!;
    rig.predictor.receive({ ...hello!, terrain: 'none such' }, rig.now);
    rig.predictor.receive({ ...before.frame!, tick: tick + 100_000 }, rig.now);
    rig.predictor.receive({ ...before.frame!, tick: tick - 1, ships: [] }, rig.now);
    rig.predictor.receive({ ...before.frame!, tick: tick + 1, tickRate: -1 }, rig.now);
    const after = rig.predictor.snapshot(rig.now);
    expect(after.hello).toEqual(before.hello);
    expect(after.frame).toEqual(before.frame);
  });

  it.each([
    [null, 'snapshot.version'],
    [{}, 'snapshot.version: expected 1, got undefined'],
    [{ version: 2 }, 'snapshot.version: expected 1, got 2'],
    [{ version: 1, ownShipId: 7 }, 'snapshot.ownShipId'],
    [{ version: 1, ownShipId: '' }, 'snapshot.hello, frame'],
    [{ version: 1, ownShipId: '', hello: null, frame: null, age: -1 }, 'snapshot.age'],
    [{ version: 1, ownShipId: '', hello: null, frame: null, age: 0, inputs: [null] }, 'snapshot.inputs'],
    [
      { version: 1, ownShipId: '', hello: null, frame: null, age: 0, inputs: [], nextSeq: 0 },
      'snapshot.nextSeq',
    ],
  ])('is refused by field when invalid: %j', (given, reason) => {
    const outcome = createPredictor().restore(given, 0);
    expect(outcome.ok).toBe(false);
    if (!outcome.ok) expect(outcome.reason).toContain(reason);
  });

  it('never throws for any value', () => {
    const predictor = createPredictor();
    const odd = {
      version: 1,
      ownShipId: 'a',
      hello: 7,
      frame: { kind: 'frame' },
      age: 0,
      inputs: [],
      nextSeq: 1,
    };
    expect(predictor.restore(odd, 0).ok).toBe(true);
    predictor.advance(null, 1);
    expect(predictor.view(1).ready).toBe(false);
  });
});

describe('a disposed predictor', () => {
  it('does nothing', () => {
    const rig = createRig({ scenario: 'settle' });
    rig.fly(3);
    let heard = 0;
    rig.predictor.onEvent(() => (heard += 1));
    rig.predictor.dispose();
    rig.fly(5);
    expect(heard).toBe(0);
    expect(rig.view().ships).toEqual([]);
    expect(rig.predictor.takeOutgoing()).toEqual([]);
  });
});

it('disposing a remote predictor disposes the one in the worker', () => {
  const posted: unknown[] = [];
  const channel: Channel = { postMessage: (message) => posted.push(message), onmessage: null };
  const remote = connectPredictor(channel);
  remote.dispose();
  expect(posted.at(-1)).toEqual({ kind: 'dispose' });
  expect(channel.onmessage).toBeNull();
});

describe('a predictor in a worker', () => {
  let { port1, port2 } = new MessageChannel();
  beforeEach(() => ({ port1, port2 } = new MessageChannel()));
  afterEach(() => {
    port1.close();
    port2.close();
  });

  it('gives the same views, events and messages as in the page, one answer later', async () => {
    const rig = createRig({ scenario: 'settle', tickRate: 5 });
    servePredictor(port2 as unknown as Channel, options(rig));
    const remote: RemotePredictor = connectPredictor(port1 as unknown as Channel);
    const kinds: string[] = [];
    remote.onEvent(({ kind, type }) => kinds.push(`${kind} ${type}`));
    rig.tamper = (message) => {
      remote.receive(message, rig.now);
      return [message];
    };
    const sent: string[] = [];
    let own: WorldView['own'] = null;
    for (let i = 0; i < 600; i++) {
      rig.frame();
      remote.advance(NEUTRAL_CONTROLS, rig.now);
      await new Promise(setImmediate);
      sent.push(...remote.takeOutgoing().map(({ kind }) => kind));
      own = remote.view()?.own ?? own;
    }
    expect(own!.shownState).toBe(rig.view().own!.shownState);
    expect(own!.shownState).toBe('landed');
    expect(own!.meshPosition).toBeInstanceOf(Float64Array);
    expect(kinds).toContain('confirmed ship.landed');
    expect(sent).toContain('ping');
    remote.dispose();
    remote.advance(null, rig.now);
  });

  it('changes policy and settings there, and returns its snapshot', async () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 5 });
    servePredictor(port2 as unknown as Channel, options(rig));
    const remote = connectPredictor(port1 as unknown as Channel);
    rig.tamper = (message) => {
      remote.receive(message, rig.now);
      return [message];
    };
    remote.setPolicy('ship-1', 'hold');
    remote.configure({ settings: { contactCrashSpeed: 77 } });
    const fly = async (frames: number) => {
      for (let i = 0; i < frames; i++) {
        rig.frame();
        remote.advance(NEUTRAL_CONTROLS, rig.now);
        await new Promise(setImmediate);
      }
    };
    await fly(120);
    remote.configure({ settings: { contactCrashSpeed: 60 } });
    remote.configure({ settings: { contactCrashSpeed: -1 } });
    const snapshot = await remote.snapshot(rig.now);
    expect(snapshot.policies).toEqual({ 'ship-1': 'hold' });
    await fly(3);
    expect(remote.view()!.settings.contactCrashSpeed).toBe(60);
    expect(remote.view()!.diagnosis.lastRefusal).toContain('contactCrashSpeed');
    expect(remote.view()!.own!.provenance).toBe('confirmed');
    remote.restore({ ...snapshot, version: 2 }, rig.now);
    await fly(3);
    expect(remote.view()!.diagnosis.lastRefusal).toContain('snapshot.version');
    remote.dispose();
  });

  it('returns the controls alone, for a server with the game’s JSON', () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 5 });
    rig.fly(2);
    expect(rig.predictor.takeControls()).toBeNull();
    rig.predictor.advance({ ...NEUTRAL_CONTROLS, thrustLevel: 0.5 }, rig.now + 0.01);
    rig.predictor.advance({ ...NEUTRAL_CONTROLS, thrustLevel: 0.6 }, rig.now + 0.02);
    expect(rig.predictor.takeControls()).toMatchObject({ thrustLevel: expect.any(Number) as number });
    expect(rig.predictor.takeControls()?.thrustLevel ?? 0.6).toBe(0.6);
    expect(rig.predictor.takeOutgoing().filter(({ kind }) => kind === 'inputs')).toEqual([]);
  });
});
