import { expect, it } from 'vitest';
import { matchVersion } from '../../src/protocol';
import {
  decodeHelloJson,
  decodeServerMessage,
  encodeHelloJson,
  encodeServerMessage,
  type Hello,
} from '../../src/wire';
import { HELLO } from './messages';

const viaBytes = (hello: Hello) => decodeServerMessage(encodeServerMessage(hello));

it.each([
  [undefined, 'same'],
  ['1', 'same'],
  ['1.0', 'same'],
  ['1.10', 'newer'],
  ['2.0', 'foreign'],
  ['0.9', 'foreign'],
  ['one', 'foreign'],
  [1, 'foreign'],
])('%s is %s', (version, match) => expect(matchVersion(version)).toBe(match));

it.each([
  ['3.4', 'same'],
  ['3.5', 'newer'],
  ['3.3', 'older'],
  ['3', 'older'],
  ['4.4', 'foreign'],
])('%s is %s to a client of 3.4', (version, match) => expect(matchVersion(version, '3.4')).toBe(match));

it('defaults to 1.0, in bytes and in JSON', () => {
  const json = { ...encodeHelloJson(HELLO), protocol_version: null };
  expect(decodeHelloJson(json)).toMatchObject({ ok: true, value: { protocolVersion: '1.0' } });
  expect(viaBytes({ ...HELLO, protocolVersion: '' })).toMatchObject({
    ok: true,
    value: { protocolVersion: '1.0' },
  });
});

it.each(['2.0', 'next'])('of another major refuses the hello before any other field: %s', (version) => {
  const hello = { ...HELLO, protocolVersion: version, terrain: '', tickRate: 0 };
  const reason = `protocol_version: expected 1.x, which this client speaks, got "${version}"`;
  expect(viaBytes(hello)).toEqual({ ok: false, reason: `hello.${reason}` });
  expect(decodeHelloJson(encodeHelloJson(hello))).toEqual({ ok: false, reason });
});
