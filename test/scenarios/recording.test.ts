import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { readRecording, type Recording, writeRecording } from '../../src/scenarios';
import { fromBase64, toBase64 } from '../../src/scenarios/recordings/base64';
import { decodeFrameJson } from '../../src/wire';
import { valueOf } from '../authority/moon';
import { flown } from './recordedSession';

const LEAST_SHIP = {
  ship_id: 'a',
  position: [1, 2, 3],
  velocity: [0, 0, 0],
  attitude: [1, 0, 0, 0],
  angular_velocity: [0, 0, 0],
  fuel: 1,
};

describe('a recording', () => {
  it('survives a round trip through its file', () => {
    const recording = flown();
    const controls = { ...NEUTRAL_CONTROLS, thrustLevel: 0.1 };
    const entries = [
      ...recording.entries,
      { kind: 'advanced', at: 200, controls: null },
      { kind: 'advanced', at: 201, controls },
      { kind: 'advanced', at: 202, controls },
    ] as const;
    const text = writeRecording({ ...recording, entries });
    expect(valueOf(readRecording(text))).toEqual({ ...recording, entries });
    // Controls are written where they change.
    expect(text.trimEnd().split('\n').at(-1)).toBe('{"kind":"advanced","at":202}');
  });

  it('keeps what a JSON server left out', () => {
    const decoded = valueOf(
      decodeFrameJson({ tick: 3, ships: [{ ...LEAST_SHIP, attitude_mode: 'sideways' }], tick_rate: 10 }),
    );
    const recording: Recording = {
      header: { note: 'json', shipId: 'a' },
      entries: [{ kind: 'received', at: 1, message: decoded }],
    };
    expect(valueOf(readRecording(writeRecording(recording)))).toEqual(recording);
  });

  it('is refused by line and field', () => {
    const good = writeRecording(flown());
    const lines = good.split('\n');
    const withLine = (line: number, text: string) => lines.with(line - 1, text).join('\n');
    const reasonOf = (text: string) => {
      const read = readRecording(text);
      return read.ok ? '' : read.reason;
    };
    expect(reasonOf('')).toBe('line 1: not JSON');
    expect(reasonOf('{"kind":"header"}')).toContain('line 1: format: expected');
    expect(reasonOf(withLine(1, '{"kind":"header","format":"touchdown-recording","version":2}'))).toContain(
      'line 1: version',
    );
    expect(reasonOf(withLine(3, '{'))).toBe('line 3: not JSON');
    expect(reasonOf(withLine(3, '['.repeat(2_000_001)))).toBe(
      'line 3: expected at most 2000000 characters, got 2000001',
    );
    expect(reasonOf(withLine(3, '[]'))).toContain('line 3: line: expected an object');
    expect(reasonOf(withLine(3, '{"kind":"received","at":1e999,"bytes":""}'))).toContain(
      'line 3: at: expected a finite',
    );
    expect(reasonOf(withLine(3, '{"kind":"received","at":-1,"bytes":""}'))).toContain(
      'line 3: at: expected ascending times',
    );
    expect(reasonOf(withLine(3, '{"kind":"guessed","at":150}'))).toContain('line 3: kind: expected one of');
    expect(reasonOf(withLine(3, '{"kind":"received","at":150,"bytes":"?"}'))).toContain(
      'line 3: bytes: expected base64',
    );
    expect(reasonOf(withLine(3, '{"kind":"received","at":150,"bytes":"/////w=="}'))).toMatch(
      /^line 3: bytes: ./,
    );
    expect(reasonOf(withLine(3, '{"kind":"advanced","at":150}'))).toContain('line 3: controls: ');
    expect(reasonOf(withLine(3, '{"kind":"advanced","at":150,"controls":{"thrustLevel":"full"}}'))).toContain(
      'line 3: controls: thrustLevel',
    );
  });

  it('encodes any bytes as base64, and accepts only base64', () => {
    const bytes = Uint8Array.from({ length: 256 }, (_, i) => i);
    for (let length = 0; length < 256; length++)
      expect(fromBase64(toBase64(bytes.subarray(0, length)))).toEqual(bytes.slice(0, length));
    for (const text of [null, 3, 'a', 'ab=c', 'abc', '====', 'ab\n=', 'äbcd'])
      expect(fromBase64(text)).toBeNull();
  });
});
