import { describe, expect, it } from 'vitest';
import { createAuthority } from '../../src/authority';
import { SHIP_CLASSES } from '../../src/dynamics';
import { agrees, compareRecording, type Recording, type RecordingEntry } from '../../src/scenarios';
import { input, MOON, shipOf, valueOf } from '../authority/moon';
import { type Client, flown, flownBy, listen, moonExchange, recordingOf } from './recordedSession';

/** Run second by second, since a server that wakes up late skips ticks. */
function bySeconds(client: Client, until: number): void {
  for (let now = 101.5; now <= until; now++) client.runTo(now);
}

describe('a recorded server', () => {
  it('that follows the law agrees with it, known inputs included', () => {
    const comparison = valueOf(compareRecording(flown()));
    expect(comparison).toMatchObject({
      ticks: 13,
      statesCompared: 12,
      unknownInputs: 0,
      withoutRelativeState: 0,
      outOfTolerance: null,
      disagreement: null,
    });
    // The state goes over the wire to the last bit, and the same code runs on both sides.
    expect(Math.max(...(Object.values(comparison.worst) as number[]))).toBe(0);
  });

  it('is compared where its inputs are known, and the other intervals are counted', () => {
    const recording = flown();
    const entries = recording.entries.filter(({ kind }) => kind === 'received');
    expect(valueOf(compareRecording({ ...recording, entries }))).toMatchObject({
      statesCompared: 9,
      unknownInputs: 3,
      disagreement: null,
    });
  });

  it('that pushes a ship is detected at that tick', () => {
    const pushed = flown((second, { authority }) => {
      if (second === 5) authority.kick('own', [0.001, 0, 0], [0, 0, 0]);
    });
    const comparison = valueOf(compareRecording(pushed));
    expect(comparison.outOfTolerance).toMatchObject({ tick: 6, field: 'relativePosition' });
    expect(agrees(comparison)).toBe(false);
  });

  it('with friction other than it sent is detected, in state or number', () => {
    const recording = flown();
    const entries = recording.entries.map((entry) =>
      entry.kind === 'received' && entry.message.kind === 'hello'
        ? {
            ...entry,
            message: {
              ...entry.message,
              settings: { ...entry.message.settings, contactFrictionKinetic: 0.45 },
            },
          }
        : entry,
    );
    expect(agrees(valueOf(compareRecording({ ...recording, entries })))).toBe(false);
  });

  /** Six seconds of the opening with one friction, then six more with another, on a server that continues or restarts. */
  function overNewSettings(friction: number, told: number, beginsAnew: boolean): Recording {
    const first = listen(moonExchange('opening', 'lan'));
    bySeconds(first, 106.5);
    const settings = { contactFrictionKinetic: friction };
    const second = listen(moonExchange('opening', 'lan', 1, false, settings));
    second.say({ kind: 'inputs', inputs: [input(1, 3, 40, { thrustLevel: 0.1 })] }, 100.5);
    bySeconds(second, 112.5);
    const after = beginsAnew ? 0 : 6;
    const later = second.entries.flatMap((entry): RecordingEntry[] => {
      if (entry.kind !== 'received') return [{ ...entry, at: entry.at + 10 }];
      const { message } = entry;
      if (message.kind === 'frame' && message.tick < after) return [];
      const hello =
        message.kind === 'hello'
          ? { ...message, settings: { ...message.settings, contactFrictionKinetic: told } }
          : message;
      return [{ ...entry, at: entry.at + 10, message: hello }];
    });
    return { header: { note: 'a test', shipId: 'own' }, entries: [...first.entries, ...later] };
  }

  it('is compared with the settings of the last hello before each frame', () => {
    for (const beginsAnew of [false, true]) {
      const comparison = valueOf(compareRecording(overNewSettings(0.3, 0.3, beginsAnew)));
      expect(comparison).toMatchObject({
        statesCompared: beginsAnew ? 6 + 12 : 6 + 6,
        unknownInputs: 0,
        outOfTolerance: null,
        disagreement: null,
      });
      expect(Math.max(...(Object.values(comparison.worst) as number[]))).toBe(0);
    }
  });

  it('that sends new friction but keeps the old, or the reverse, is detected', () => {
    expect(agrees(valueOf(compareRecording(overNewSettings(0.5, 0.3, true))))).toBe(false);
    expect(agrees(valueOf(compareRecording(overNewSettings(0.3, 0.5, true))))).toBe(false);
  });

  it('that restarts its tick count has no earlier inputs', () => {
    const exchange = moonExchange('opening', 'lan');
    const before = listen(exchange);
    before.say(
      { kind: 'inputs', inputs: [input(1, 3, 10, { thrustLevel: 0.3 }), input(2, 3, 60, {})] },
      100.5,
    );
    bySeconds(before, 105.5);
    const after = listen(moonExchange('opening', 'lan'));
    bySeconds(after, 105.5);
    const entries = [...before.entries, ...after.entries.map((entry) => ({ ...entry, at: entry.at + 10 }))];
    const comparison = valueOf(compareRecording({ header: { note: '', shipId: 'own' }, entries }));
    expect(comparison).toMatchObject({ statesCompared: 10, unknownInputs: 0, outOfTolerance: null });
  });

  it('that continues after a lost connection still has them', () => {
    const exchange = moonExchange('opening', 'lan');
    const client = listen(exchange);
    client.say(
      { kind: 'inputs', inputs: [input(1, 4, 10, { thrustLevel: 0.3 }), input(2, 4, 60, {})] },
      100.5,
    );
    client.runTo(102.5);
    exchange.drop('ann');
    exchange.reconnect('ann', 103.5);
    bySeconds(client, 108.5);
    const comparison = valueOf(compareRecording(recordingOf(client)));
    expect(comparison).toMatchObject({ statesCompared: 8, unknownInputs: 0, outOfTolerance: null });
    expect(Math.max(...(Object.values(comparison.worst) as number[]))).toBe(0);
  });

  it('is compared at the height of each ship’s centre, or at its class’s where none is sent', () => {
    const ship = shipOf('settle');
    const own = SHIP_CLASSES.find(({ name }) => name === ship.shipClass)!.groundContactOffset;
    const compared = (groundContactOffset: number, sent: number | null) => {
      const authority = valueOf(createAuthority(MOON));
      const client = listen(flownBy(authority, { ...ship, groundContactOffset }, 'lan', 1));
      bySeconds(client, 104.5);
      const entries = client.entries.map((entry): RecordingEntry => {
        if (entry.kind !== 'received' || entry.message.kind !== 'frame') return entry;
        const ships = entry.message.ships.map((state) => ({ ...state, groundContactOffset: sent }));
        return { ...entry, message: { ...entry.message, ships } };
      });
      return valueOf(compareRecording({ ...recordingOf(client), entries }));
    };
    for (const [flies, sent] of [
      [own + 0.2, own + 0.2],
      [own, null],
    ] as const)
      expect(compared(flies, sent)).toMatchObject({ statesCompared: 4, outOfTolerance: null });
    expect(compared(own + 0.2, null).outOfTolerance).not.toBeNull();
  });

  it('like today’s game is reported as not comparable', () => {
    const client = listen(moonExchange('opening', 'lan', 1, true));
    client.runTo(105);
    expect(compareRecording(recordingOf(client))).toEqual({
      ok: false,
      reason: 'no interval of any ship could be compared',
    });
  });
});
