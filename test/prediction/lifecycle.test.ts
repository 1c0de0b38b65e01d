/** A predictor that goes on elsewhere: from a snapshot, in a worker; and one that ends. */
import { MessageChannel } from 'node:worker_threads';
import { afterEach, describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import {
  type Channel,
  connectPredictor,
  createPredictor,
  type RemotePredictor,
  servePredictor,
  type WorldView,
} from '../../src/prediction';
import { createRig } from './rig';

const options = (rig: ReturnType<typeof createRig>) => ({
  terrains: { [rig.loaded.scenario.terrain]: rig.loaded.terrainHeight },
});

describe('a snapshot', () => {
  it('goes through JSON, and the landing goes on from it without a mismatch', () => {
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
    // A frame's way and what the clock has to learn anew: 100 ms at 40 m/s.
    expect(moved).toBeLessThan(4);
    rig.fly(25);
    const { own, diagnosis } = rig.view();
    expect([own!.shownState, own!.provenance]).toEqual(['landed', 'confirmed']);
    expect(diagnosis.correctionsMismatch).toBe(0);
    expect(diagnosis.framesRefused).toBe(0);
  });

  it('has the inputs that were not acknowledged, and they are sent again under their numbers', () => {
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
  ])('that cannot be is refused by its field: %j', (given, reason) => {
    const outcome = createPredictor().restore(given, 0);
    expect(outcome.ok).toBe(false);
    if (!outcome.ok) expect(outcome.reason).toContain(reason);
  });

  it('of anything does not throw', () => {
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
  it('does nothing any more', () => {
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

describe('a predictor in a worker', () => {
  const { port1, port2 } = new MessageChannel();
  afterEach(() => {
    port1.close();
    port2.close();
  });

  it('gives the views, events and messages that it would give in the page, an answer later', async () => {
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
});
