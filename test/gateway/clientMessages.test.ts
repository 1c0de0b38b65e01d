/** Messages from clients, and how the gateway handles them. */
import { describe, expect, it } from 'vitest';
import { receive, receivePing } from '../../src/gateway/clients/receive';
import { readBytes, readText } from '../../src/gateway/clients/messages';
import { INPUT } from '../wire/messages';
import { excessOf, piloted, refusalOf, sendBytes, sendJson } from './fakeGateway';

describe('controls', () => {
  it('on /ws apply to the player’s ship at the next tick, with the gateway’s sequence numbers', () => {
    const { gateway, inputs, pilot } = piloted('json');
    sendJson(gateway, pilot, { type: 'control', thrust_level: 0.5 });
    sendJson(gateway, pilot, { type: 'control', controls: { thrust_level: 0.25 } });
    expect(inputs).toMatchObject([
      { shipId: 'ship of p1', playerId: 'p1', session: 'page', seq: 1, stamp: null },
      { seq: 2, controls: { thrustLevel: 0.25 } },
    ]);
    expect(inputs[0]!.controls.thrustLevel).toBe(0.5);
  });

  it('on /stream keep their own sequence number, tick and substep', () => {
    const { gateway, inputs, pilot } = piloted('stream');
    sendBytes(gateway, pilot, { kind: 'inputs', inputs: [INPUT, { ...INPUT, seq: 2, substep: 4 }] });
    expect(inputs).toMatchObject([
      { shipId: 'ship of p1', seq: 1, stamp: { tick: 42, substep: 3 }, controls: INPUT.controls },
      { seq: 2, stamp: { tick: 42, substep: 4 } },
    ]);
    // Controls without a sequence number are refused here.
    sendJson(gateway, pilot, { type: 'control', thrust_level: 0.5 });
    expect([inputs.length, excessOf(pilot), pilot.sent]).toEqual([2, 1, []]);
  });

  it('of a player without a ship are dropped', () => {
    const { gateway, inputs, signedIn } = piloted('json');
    sendJson(gateway, signedIn('p3', 'json'), { type: 'control', thrust_level: 0.5 });
    expect(inputs).toEqual([]);
  });
});

describe('a ping', () => {
  it('is answered; on /stream with the newest tick and the seconds since it was due', () => {
    const { gateway, pilot } = piloted('json');
    sendJson(gateway, pilot, { type: 'ping' });
    expect(pilot.sent).toEqual([{ type: 'pong' }]);
    const { gateway: other, state: world, pilot: streaming } = piloted('stream');
    world.now = 1000.5;
    sendBytes(other, streaming, { kind: 'ping', id: 9 });
    // Redis's clock is 0.25 s ahead of the gateway's.
    expect(streaming.sent).toEqual([{ kind: 'pong', id: 9, tick: 50, sinceTick: 0.75 }]);
    world.now = 3e9;
    sendBytes(other, streaming, { kind: 'ping', id: 10 });
    expect(streaming.sent[1]).toMatchObject({ sinceTick: 1e9 });
    world.newest = { ...world.newest!, due: 6e9 };
    sendBytes(other, streaming, { kind: 'ping', id: 11 });
    expect(streaming.sent[2]).toMatchObject({ sinceTick: -1e9 });
    world.newest = null;
    sendBytes(other, streaming, { kind: 'ping', id: 12 });
    expect(streaming.sent).toHaveLength(3);
  });
});

describe('a ping frame', () => {
  const ping = ({ gateway, pilot }: ReturnType<typeof piloted>, data = 'x') =>
    receivePing(gateway, pilot.client, Buffer.from(data));

  it('is answered with its data while the socket has room', () => {
    const made = piloted('stream');
    ping(made, 'a');
    made.pilot.socket.bufferedAmount = 256 * 1024;
    ping(made, 'b');
    made.pilot.socket.bufferedAmount += 1;
    ping(made, 'c');
    expect(made.pilot.pongs).toEqual(['a', 'b']);
    expect(excessOf(made.pilot)).toBe(0);
  });

  it('counts as a message, and gets no answer from a connection that is closing', () => {
    const made = piloted('stream');
    for (let i = 0; i < 122; i++) ping(made);
    expect([made.pilot.pongs.length, excessOf(made.pilot)]).toEqual([120, 2]);
    made.state.now += 60;
    made.pilot.client.isClosing = true;
    ping(made);
    expect(made.pilot.pongs).toHaveLength(120);
  });
});

describe('an invalid or excess message', () => {
  it('is refused on /ws with the field’s name and the game’s error code', () => {
    const { gateway, pilot } = piloted('json');
    sendJson(gateway, pilot, { type: 'fly' });
    expect(pilot.sent).toEqual([
      { type: 'error', error: { code: 'E001', message: 'type: expected auth, control or ping' } },
    ]);
    receive(gateway, pilot.client, Buffer.from([1, 2]), true);
    expect(refusalOf(pilot.sent[1])).toBe('message: expected text');
    sendJson(gateway, pilot, { type: 'auth', token: 'p9' });
    expect([pilot.sent.length, pilot.client.player!.playerId]).toEqual([2, 'p1']);
  });

  it('is counted; one per second is forgiven, and more than 200 close the connection', () => {
    const { gateway, state, pilot } = piloted('json');
    // 204 of them take 3.4 s.
    for (let i = 0; i < 204; i++) {
      expect(pilot.closed).toEqual([]);
      state.now += 1 / 60;
      sendJson(gateway, pilot, { type: 'fly' });
    }
    expect(pilot.sent).toHaveLength(203);
    expect(pilot.closed).toEqual([{ code: 4008, reason: 'Too many messages' }]);
  });

  it('is a message beyond a burst of 120 and 60 per second, which gets no answer', () => {
    const { gateway, state, pilot } = piloted('json');
    const ping = (count: number) => {
      for (let i = 0; i < count; i++) sendJson(gateway, pilot, { type: 'ping' });
      return [pilot.sent.length, excessOf(pilot)];
    };
    expect(ping(121)).toEqual([120, 1]);
    state.now += 0.5;
    // One of two is forgiven by half.
    expect(ping(31)).toEqual([150, 1.5]);
  });

  it('is an input beyond a burst of 1,024 and 120 per second', () => {
    const { gateway, state, inputs, pilot } = piloted('stream');
    const many = Array.from({ length: 128 }, () => INPUT);
    for (let i = 0; i < 9; i++) sendBytes(gateway, pilot, { kind: 'inputs', inputs: many });
    expect([inputs.length, excessOf(pilot)]).toEqual([1024, 1]);
    state.now += 0.5;
    for (let i = 0; i < 61; i++) sendBytes(gateway, pilot, { kind: 'inputs', inputs: [INPUT] });
    expect([inputs.length, excessOf(pilot)]).toEqual([1084, 1.5]);
  });
});

describe('a message', () => {
  it.each([
    [{ token: 't' }, { session: '', since: null }],
    [
      { token: 't', session: 'a-b_9', since: 0 },
      { session: 'a-b_9', since: 0 },
    ],
    [
      { token: 't', session: 'x'.repeat(49), since: -1 },
      { session: '', since: null },
    ],
    [
      { token: 't', session: 5, since: 1.5 },
      { session: '', since: null },
    ],
  ])('signs in and ignores an invalid session or tick: %o', (fields, read) => {
    expect(readText(JSON.stringify({ type: 'auth', ...fields }))).toEqual({
      kind: 'auth',
      token: 't',
      ...read,
    });
  });

  it('is refused if it is a sign-in without a token, a list, null, or not protobuf', () => {
    expect(readText('{"type":"auth","token":""}')).toEqual({
      kind: 'refused',
      reason: 'auth.token: expected a string',
    });
    expect(readText('[]')).toEqual({ kind: 'refused', reason: 'message: expected an object' });
    expect(readText('null')).toEqual({ kind: 'refused', reason: 'message: expected an object' });
    expect(readBytes(Uint8Array.of(255))).toMatchObject({ kind: 'refused' });
  });
});
