import { describe, expect, it } from 'vitest';
import {
  type ClientMessage,
  decodeClientMessage,
  decodeServerMessage,
  encodeClientMessage,
  encodeServerMessage,
  MAX_TEXT,
  type ServerMessage,
} from '../../src/wire';
import { galaxy } from '../../src/wire/generated/codec.js';
import { FRAME, HELLO, INPUTS } from './messages';

/** Makes each field of each message invalid in turn: the reason must begin with the path of that field. */

type Codec = typeof galaxy.stream.ServerMessage | typeof galaxy.stream.ClientMessage;
type Tree = Record<string, unknown>;

interface Place {
  readonly path: string;
  readonly parent: Tree;
  readonly name: string;
}

/** Every field below `node`, lists by their last item. */
function places(node: Tree, path: string): Place[] {
  return Object.keys(node).flatMap((name): Place[] => {
    const value = node[name];
    const here = { path: `${path}${path === '' ? '' : '.'}${name}`, parent: node, name };
    if (Array.isArray(value)) {
      const last = value.length - 1;
      return places(value[last] as Tree, `${here.path}[${last}]`);
    }
    if (typeof value !== 'object' || value === null || 'low' in value) return [here];
    return [here, ...places(value as Tree, here.path)];
  });
}

/** Names of the codec's fields that a message of `node`'s kind has and `node` does not set. */
function unset(node: object): string[] {
  const fields = Object.keys(Object.getPrototypeOf(node) as object);
  return fields.filter((name) => !Object.hasOwn(node, name) && !name.startsWith('_'));
}

/** An invalid value for the field, or undefined if none can be sent. */
function badValues({ parent, name }: Place): unknown[] {
  const value = parent[name];
  if (name === 'substep') return [1_000_000, 4294967295];
  if (typeof value === 'number') return [NaN, Infinity, -Infinity];
  if (typeof value === 'string') return ['x'.repeat(MAX_TEXT + 1)];
  if (typeof value === 'object' && value !== null && 'low' in value) return ['9007199254740992'];
  return [];
}

/** Optional submessages; all others are required. */
const OPTIONAL =
  /(translation_input|rotation_input|target_attitude|relative_position|relative_velocity|wheel_momentum|reaction_wheel_capacity|last_input)$/;

function suite(title: string, codec: Codec, bytes: Uint8Array, reasonOf: (bytes: Uint8Array) => string) {
  const message = codec.decode(bytes) as unknown as Tree;
  const [kind, content] = Object.entries(message)[0]!;
  const root = kind === 'inputs' ? '' : kind;
  const resent = () => reasonOf(codec.encode(message).finish());

  describe(title, () => {
    const all = places(content as Tree, root);
    it('is tried with every field', () => {
      expect(all.length).toBeGreaterThan(0);
      expect(reasonOf(bytes)).toBe('');
      for (const { path, parent } of all) expect(unset(parent), path).toEqual([]);
    });

    for (const place of all) {
      const { path, parent, name } = place;
      const value = parent[name];
      for (const bad of badValues(place)) {
        it(`refuses ${path} = ${String(bad).slice(0, 20)}`, () => {
          parent[name] = bad;
          const reason = resent();
          parent[name] = value;
          expect(reason.slice(0, path.length + 2)).toBe(`${path}: `);
        });
      }
      if (typeof value !== 'object' || value === null || 'low' in value) continue;
      it(`${OPTIONAL.test(path) ? 'accepts' : 'refuses'} a message without ${path}`, () => {
        parent[name] = null;
        const reason = resent();
        parent[name] = value;
        expect(reason).toBe(OPTIONAL.test(path) ? '' : `${path}: missing`);
      });
    }
  });
}

function serverReason(bytes: Uint8Array): string {
  const decoded = decodeServerMessage(bytes);
  return decoded.ok ? '' : decoded.reason;
}

function clientReason(bytes: Uint8Array): string {
  const decoded = decodeClientMessage(bytes);
  return decoded.ok ? '' : decoded.reason;
}

const server = (message: ServerMessage) => encodeServerMessage(message);
const client = (message: ClientMessage) => encodeClientMessage(message);
suite('a frame', galaxy.stream.ServerMessage, server(FRAME), serverReason);
suite('a hello', galaxy.stream.ServerMessage, server(HELLO), serverReason);
suite(
  'a pong',
  galaxy.stream.ServerMessage,
  server({ kind: 'pong', id: 1, tick: 2, sinceTick: 3 }),
  serverReason,
);
suite('inputs', galaxy.stream.ClientMessage, client(INPUTS), clientReason);
suite('a ping', galaxy.stream.ClientMessage, client({ kind: 'ping', id: 1 }), clientReason);
