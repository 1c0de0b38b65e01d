import { BODIES, err, type Result, SHIP_CLASSES } from '../../dynamics';
import { helloFields, readProtocolVersion, readTiming } from '../messages/hello';
import { MAX_BODIES, MAX_SHIP_CLASSES, MAX_TICK } from '../limits';
import {
  beginReading,
  choiceIn,
  endReading,
  type Fields,
  fieldsOf,
  integerIn,
  messageIn,
  textIn,
  valueIn,
} from '../fields/reading';
import type { Hello } from '../records';
import { readSettings } from '../fields/settings';
import { readShipClass } from '../fields/shipClass';
import { readBodyJson } from './bodyJson';
import { SPIN_READER } from './spin';
import { entriesIn, type JsonPass } from './entries';
import { notPlain } from '../fields/sentObject';

/** A hello from JSON, and its refused parts. */
export interface DecodedHello extends Hello {
  /** Path and reason of each invalid ship class and body; the rest of the hello is valid. */
  readonly refusals: readonly string[];
}

/** A hello has at least one of these. */
const HELLO_FIELDS = [
  'player_id',
  'ship_id',
  'settings',
  'ship_classes',
  'terrain',
  'bodies',
  'tick_rate',
  'protocol_version',
];

const DEFAULT_FIELDS: Fields = { settings: {}, tick_rate: 1, time_scale: 1, input_granularity: 'tick' };

/**
 * The hello of a JSON server: any of `player_id`, `ship_id`, `settings`, `ship_classes` and `bodies` (a
 * list, or an object by name), `terrain`, `tick`, `tick_rate`, `time_scale`, `input_granularity`, `protocol_version`. The defaults are
 * the design's: default settings, the game's classes and bodies, flat ground, 1 Hz, whole-tick inputs, protocol version 1.0. Spelling as in
 * decodeFrameJson. Refused with the path of the first invalid field that is not a class or a body. Never throws.
 *
 * @example
 * ```ts
 * const hello = decodeHelloJson({ ship_id: 'ship-1', settings: { contact_crash_speed: 12 }, tick_rate: 10 });
 * if (hello.ok) predictor.receive(hello.value, now);
 * ```
 */
export function decodeHelloJson(value: unknown): Result<DecodedHello> {
  const mistaken = notPlain(value);
  if (mistaken !== null) return err(`message: expected a parsed JSON object, got ${mistaken}`);
  const r = beginReading('json');
  const sent = fieldsOf(r, value);
  const isFrame = valueIn(r, sent, 'ships') !== undefined;
  if (r.reason === null && (isFrame || !HELLO_FIELDS.some((name) => valueIn(r, sent, name) !== undefined)))
    return err(
      `message: ${isFrame ? 'a frame: pass it to decodeFrameJson' : `expected at least one of ${HELLO_FIELDS.join(', ')}`}`,
    );
  const from = completed(sent);
  const protocolVersion = readProtocolVersion(r, from);
  const pass: JsonPass = { refusals: [] };
  const shipClasses = entriesIn(pass, from, {
    name: 'ship_classes',
    most: MAX_SHIP_CLASSES,
    key: 'name',
    read: readShipClass,
  });
  const defaults = { known: BODIES, time: 0, spins: SPIN_READER };
  const bodies = entriesIn(pass, from, {
    name: 'bodies',
    most: MAX_BODIES,
    key: 'name',
    read: (reading, body) => readBodyJson(reading, body, defaults),
  });
  const hello: DecodedHello = {
    kind: 'hello',
    protocolVersion,
    playerId: textIn(r, from, 'player_id'),
    shipId: textIn(r, from, 'ship_id'),
    settings: messageIn(r, from, 'settings', readSettings),
    shipClasses: shipClasses ?? SHIP_CLASSES,
    bodies: bodies ?? BODIES,
    terrain: textIn(r, from, 'terrain') || 'flat',
    tick: integerIn(r, from, 'tick', 0, MAX_TICK),
    ...readTiming(r, from),
    inputGranularity: choiceIn(r, from, 'input_granularity', ['substep', 'tick'], false),
    refusals: pass.refusals,
  };
  return endReading(r, hello);
}

/** A hello for JSON.stringify: all fields of protobuf, in snake_case. */
export function encodeHelloJson(hello: Hello): Readonly<Record<string, unknown>> {
  return { ...helloFields(hello) };
}

/** The sent fields; absent ones are taken from DEFAULT_FIELDS. */
function completed(sent: Fields): Fields {
  const r = beginReading('json');
  const fields: Record<string, unknown> = { ...sent };
  for (const [name, byDefault] of Object.entries(DEFAULT_FIELDS))
    fields[name] = valueIn(r, sent, name) ?? byDefault;
  return fields;
}
