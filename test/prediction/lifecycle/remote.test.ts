import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import {
  type Channel,
  connectPredictor,
  type FromWorker,
  servePredictor,
  type ToWorker,
} from '../../../src/prediction/lifecycle/remote';
import { frameAt, helloAt } from '../faults/restingShip';

/** One end of a channel: what was posted, and how to hand it a message. */
function channelEnd() {
  const posted: unknown[] = [];
  const channel: Channel = { postMessage: (message) => posted.push(message), onmessage: null };
  const hand = (data: unknown) =>
    (channel.onmessage as ((event: { data: unknown }) => void) | null)?.({ data });
  return { channel, posted, hand };
}

const advanced = (more: object = {}) => ({ kind: 'advanced', view: {}, outgoing: [], notices: [], ...more });

describe('the page’s end of a predictor in a worker', () => {
  const connected = () => {
    const { channel, hand, ...end } = channelEnd();
    const posted = end.posted as ToWorker[];
    const remote = connectPredictor(channel);
    const advances = () => posted.flatMap((one) => (one.kind === 'advance' ? [one.now] : []));
    return { remote, channel, posted, hand, advances };
  };

  it('sends one advance at a time, and after its answer only the newest one', () => {
    const { remote, hand, advances } = connected();
    for (const now of [1, 2, 3]) remote.advance(NEUTRAL_CONTROLS, now);
    expect(advances()).toEqual([1]);
    hand(advanced());
    expect(advances()).toEqual([1, 3]);
    remote.advance(null, 4);
    expect(advances()).toEqual([1, 3]);
    hand(advanced());
    hand(advanced());
    expect(advances()).toEqual([1, 3, 4]);
    remote.advance(null, 5);
    expect(advances()).toEqual([1, 3, 4, 5]);
  });

  it('returns the newest view, or null before the first', () => {
    const { remote, hand } = connected();
    expect(remote.view()).toBeNull();
    const view = { tick: 7 };
    hand(advanced({ view }));
    hand({ kind: 'snapshot', snapshot: {} });
    expect(remote.view()).toBe(view);
  });

  it('returns outgoing messages once, in order', () => {
    const { remote, hand } = connected();
    hand(advanced({ outgoing: ['a'] }));
    hand(advanced({ outgoing: ['b', 'c'] }));
    expect(remote.takeOutgoing()).toEqual(['a', 'b', 'c']);
    expect(remote.takeOutgoing()).toEqual([]);
  });

  it('notifies listeners until they unsubscribe', () => {
    const { remote, hand } = connected();
    const heard: unknown[] = [];
    const leave = remote.onEvent((notice) => heard.push(notice));
    hand(advanced({ notices: [1, 2] }));
    leave();
    hand(advanced({ notices: [3] }));
    expect(heard).toEqual([1, 2]);
  });

  it('resolves snapshots in the order of the requests', async () => {
    const { remote, hand, posted } = connected();
    const both = Promise.all([remote.snapshot(1), remote.snapshot(2)]);
    expect(posted).toEqual([1, 2].map((now) => ({ kind: 'snapshot', now })));
    for (const snapshot of ['first', 'second']) hand({ kind: 'snapshot', snapshot });
    expect(await both).toEqual(['first', 'second']);
    expect(() => hand({ kind: 'snapshot', snapshot: 'nobody asked for' })).not.toThrow();
  });

  it('forwards all other calls', () => {
    const { remote, posted } = connected();
    remote.receive(frameAt(1, 10), 5);
    remote.refused('why');
    remote.setOwnShip('own');
    remote.removeShip('own', 'docked');
    remote.teleported('own');
    remote.setPolicy('own', 'hold');
    remote.configure({ terrain: 'flat' });
    remote.restore({ version: 1 }, 6);
    remote.reset();
    expect(posted).toEqual([
      { kind: 'receive', message: frameAt(1, 10), now: 5 },
      { kind: 'refused', reason: 'why' },
      { kind: 'setOwnShip', shipId: 'own' },
      { kind: 'removeShip', shipId: 'own', reason: 'docked' },
      { kind: 'teleported', shipId: 'own' },
      { kind: 'setPolicy', shipId: 'own', policy: 'hold' },
      { kind: 'configure', changes: { terrain: 'flat' } },
      { kind: 'restore', snapshot: { version: 1 }, now: 6 },
      { kind: 'reset' },
    ]);
  });

  it('closes its channel and removes its listeners when disposed', () => {
    const { remote, channel, posted, hand } = connected();
    const heard: unknown[] = [];
    remote.onEvent((notice) => heard.push(notice));
    const { onmessage } = channel;
    remote.dispose();
    expect([posted, channel.onmessage]).toEqual([[{ kind: 'dispose' }], null]);
    channel.onmessage = onmessage;
    hand(advanced({ notices: [1] }));
    expect(heard).toEqual([]);
  });
});

describe('the worker’s end', () => {
  const serving = () => {
    const { channel, hand, ...end } = channelEnd();
    const posted = end.posted as FromWorker[];
    const predictor = servePredictor(channel, { ownShipId: 'ship-1' });
    return { predictor, channel, posted, hand };
  };

  it('answers each advance with the view, and nothing else', () => {
    const { posted, hand } = serving();
    hand({ kind: 'receive', message: helloAt(100, 10), now: 1 });
    hand({ kind: 'receive', message: frameAt(100, 10), now: 1 });
    expect(posted).toEqual([]);
    hand({ kind: 'advance', controls: null, now: 1.1 });
    expect(posted.map(({ kind }) => kind)).toEqual(['advanced']);
    expect(posted[0]).toMatchObject({ view: { ready: true, ships: [{ shipId: 'ship-1' }] }, notices: [] });
    hand({ kind: 'setPolicy', shipId: 'ship-1', policy: 'hold' });
    expect(posted).toHaveLength(1);
  });

  it('sends outgoing messages and each event once', () => {
    const { predictor, posted, hand } = serving();
    hand({ kind: 'receive', message: helloAt(100, 10), now: 1 });
    hand({ kind: 'receive', message: frameAt(100, 10), now: 1 });
    const events = [{ type: 'ship.contact', shipId: 'ship-1', tick: 100, substep: 1 }];
    hand({ kind: 'receive', message: frameAt(101, 10, { events }), now: 1.1 });
    for (const now of [1.2, 1.3]) hand({ kind: 'advance', controls: NEUTRAL_CONTROLS, now });
    const answers = posted as unknown as { outgoing: { kind: string }[]; notices: unknown[] }[];
    expect(answers.map(({ notices }) => notices.length)).toEqual([1, 0]);
    expect(answers[0]!.outgoing.some(({ kind }) => kind === 'ping')).toBe(true);
    expect(predictor.takeOutgoing()).toEqual([]);
  });

  it('returns a snapshot on request, and restores one', () => {
    const { posted, hand } = serving();
    hand({ kind: 'snapshot', now: 1 });
    expect(posted.map(({ kind }) => kind)).toEqual(['snapshot']);
  });

  it.each([
    ['restore', { kind: 'restore', snapshot: 7, now: 1 }],
    ['configure', { kind: 'configure', changes: { terrain: 'nowhere' } }],
    ['refused', { kind: 'refused', reason: 'broken' }],
  ])('counts a refused %s, with the reason', (_, message) => {
    const { predictor, hand } = serving();
    hand(message);
    const { framesRefused, lastRefusal } = predictor.view(1).diagnosis;
    expect([framesRefused, lastRefusal === '']).toEqual([1, false]);
  });

  it('closes its channel when disposed', () => {
    const { channel, hand } = serving();
    hand({ kind: 'reset' });
    expect(channel.onmessage).not.toBeNull();
    hand({ kind: 'dispose' });
    expect(channel.onmessage).toBeNull();
  });
});
