import { describe, expect, it } from 'vitest';
import {
  EVENT_CONTACT,
  EVENT_DESTROYED,
  EVENT_LANDED,
  EVENT_RIGHTED,
  EVENT_TIPPED,
} from '../../../src/dynamics';
import { abandonReplay, startReplay } from '../../../src/prediction/simulation/replay';
import { confirmEvents, recordPredicted, settleEvents } from '../../../src/prediction/events/settleEvents';
import type { ServerFrame } from '../../../src/wire';
import { frameAt, STILL } from '../faults/restingShip';
import { RATE, sessionAt, shipAt } from './sessionAt';

/** Tick of the newest frame, and ticks that 50 substeps take. */
const TICK = 100;
const COVER = 5;
const contact = (tick: number, substep = 0) => ({ type: 'ship.contact', shipId: 'own', tick, substep });

/** A ship whose touch, or another event, is predicted at `tick`, in the pass that is simulated now. */
function touching(tick: number, event = EVENT_CONTACT) {
  const { sim, receiver } = sessionAt(TICK);
  const track = shipAt(sim, 'own', 'contact');
  receiver.sendsEvents = true;
  recordPredicted(sim, track, event, { tick, substep: 0 }, track.pass);
  sim.notices.length = 0;
  const settle = (more: Partial<ServerFrame> = {}, now = 7) => {
    settleEvents(sim, receiver, frameAt(TICK, RATE, more), now);
    return sim.notices.splice(0).map(({ kind }) => kind);
  };
  return { sim, receiver, track, settle };
}

describe('an event of the server', () => {
  it('confirms a predicted one once, however often it is sent', () => {
    const { settle } = touching(TICK - 2);
    const events = [contact(TICK - 2, 3)];
    expect(settle({ events })).toEqual(['confirmed']);
    expect(settle({ events })).toEqual([]);
  });

  it('is reported by itself if none was predicted', () => {
    const { settle } = touching(TICK + 50);
    expect(settle({ events: [contact(TICK - 3)] })).toEqual(['confirmed']);
  });

  it.each([
    ['of another ship', { ...contact(TICK - 2), shipId: 'gone' }],
    ['of an unknown type', { ...contact(TICK - 2), type: 'ship.docked' }],
    ['without a substep', { ...contact(TICK - 2), substep: null }],
    ['later than its frame', contact(TICK)],
    ['of the world before', contact(79)],
  ])('%s is ignored', (_, event) => {
    const { sim, receiver } = touching(TICK + 50);
    receiver.firstTick = 80;
    confirmEvents(sim, receiver, frameAt(TICK, RATE, { events: [event] }));
    expect(sim.notices).toEqual([]);
  });

  it('during an outage is reported back to the last frame before it, but not beyond the history', () => {
    const { sim, receiver } = touching(TICK + 50);
    sim.ringLength = 12;
    receiver.eventsTick = 20;
    const heard = (tick: number) => {
      confirmEvents(sim, receiver, frameAt(TICK, RATE, { events: [contact(tick)] }));
      return sim.notices.splice(0).length;
    };
    expect([heard(19), heard(20), heard(60)]).toEqual([0, 1, 1]);
  });
});

describe('a predicted event that the server does not send', () => {
  it('is retracted by the first frame that covers 50 substeps more, and shown as withdrawn for 2 s', () => {
    expect(touching(TICK - COVER + 1).settle()).toEqual([]);
    const { track, settle } = touching(TICK - COVER);
    expect(settle({}, 7)).toEqual(['retracted']);
    expect(track.picture.status).toMatchObject({
      withdrawn: 'contact',
      withdrawnUntil: 9,
    });
  });

  it.each([
    [EVENT_CONTACT, 'contact'],
    [EVENT_LANDED, 'landed'],
    [EVENT_TIPPED, 'tipped'],
    [EVENT_RIGHTED, 'righted'],
    [EVENT_DESTROYED, 'crashed'],
  ])('event %i is shown as %s', (event, word) => {
    const { track, settle } = touching(TICK - COVER, event);
    expect(settle()).toEqual(['retracted']);
    expect(track.picture.status.withdrawn).toBe(word);
  });

  it('is confirmed where the state agrees: the server sends no such events', () => {
    const { track, receiver, settle } = touching(TICK - COVER);
    track.agreedTick = TICK;
    expect(settle()).toEqual(['confirmed']);
    expect(receiver.sendsEvents).toBe(false);
  });

  it('is retracted if the state agrees with a later pass that lacks it', () => {
    const { track, settle } = touching(TICK - COVER);
    track.agreedTick = TICK;
    track.pass += 1;
    expect(settle()).toEqual(['retracted']);
  });

  it('is not confirmed by a state that agrees while a replay is not done', () => {
    const { track, settle } = touching(TICK - COVER);
    track.agreedTick = TICK;
    track.replaying = true;
    expect(settle()).toEqual(['retracted']);
  });

  it('from before the state at which the last replay began is not confirmed by agreement', () => {
    const { sim, track, receiver, settle } = touching(TICK - COVER);
    receiver.sendsEvents = false;
    startReplay(track, sim, TICK - 2, track.serverRow, 0);
    abandonReplay(track);
    track.pass = track.replayPass;
    track.agreedTick = TICK;
    expect(settle()).toEqual([]);
  });

  it('stays open for a ship that is missing from the frame', () => {
    const { track, settle } = touching(TICK - COVER);
    track.serverTick = TICK - 1;
    expect(settle()).toEqual([]);
  });
});

it('without events a state on the ground confirms a touch, one in flight leaves it open', () => {
  const { receiver, settle } = touching(TICK - COVER);
  receiver.sendsEvents = false;
  const ship = (surfaceContactState: string) => ({
    ships: [{ ...STILL, shipId: 'own', surfaceContactState, landedBodyName: '' } as never],
  });
  expect(settle(ship(''))).toEqual([]);
  expect(settle(ship('contact'))).toEqual(['confirmed']);
});
