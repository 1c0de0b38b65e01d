import {
  type Body,
  BODIES,
  type BodyMotion,
  err,
  DEFAULT_SETTINGS,
  loadTiming,
  type Result,
} from '../../dynamics';
import { frameFields, readAcknowledgement } from '../messages/frame';
import { FINITE, GAME_SECONDS, MAX_BODIES, MAX_EVENTS, MAX_SHIPS, MAX_TICK } from '../limits';
import {
  beginReading,
  endReading,
  type Fields,
  fieldsOf,
  flagIn,
  integerIn,
  messageIn,
  numberIn,
  type Reading,
  refuse,
  valueIn,
} from '../fields/reading';
import type { PartialFrame } from '../records';
import { refuseLoaded } from '../loaders';
import { readShipState } from '../fields/shipState';
import { readEvent } from '../fields/worldEvent';
import { type BodyDefaults, readBodyJson } from './bodyJson';
import { entriesIn, type JsonPass, partIn } from './entries';
import { notPlain, wrapped } from '../fields/sentObject';
import { gameTimeIn } from './gameTime';
import { SPIN_READER } from './spin';

/** A frame from JSON, and its refused parts. */
export interface DecodedFrame extends PartialFrame {
  /** Path and reason of each invalid ship, body, event or other part; the rest of the frame is valid. */
  readonly refusals: readonly string[];
}

export interface FrameJsonOptions {
  /** Bodies by name, for those sent without mass, radius, attitude or spin; by default the game's bodies. */
  readonly bodies?: readonly (Body & BodyMotion)[];
}

/**
 * A frame of a JSON server, without its envelope: `tick` and `ships` (a list, or an object by
 * ship_id); and optionally `tick_rate`, `time_scale`, `game_time` (s or ISO 8601), `paused`, `bodies` (a list,
 * or an object by name), `events` and `last_input`. Names in snake_case or camelCase; values as JSON values or strings, as in
 * Redis; vectors [x, y, z] or {x, y, z}, quaternions [w, x, y, z] or {w, x, y, z}. Unknown modes, classes,
 * states and events keep their names. Refused only without a tick or ships; other invalid parts are in
 * `refusals`. SI units, ICRF axes, quaternions of the record [x, y, z, w]. Never throws.
 *
 * @example
 * ```ts
 * const decoded = decodeFrameJson(JSON.parse(text)); // text of the socket's message
 * if (decoded.ok) predictor.receive(decoded.value, now);
 * else predictor.refused(decoded.reason); // 'tick: missing'
 * ```
 */
export function decodeFrameJson(value: unknown, options: FrameJsonOptions = {}): Result<DecodedFrame> {
  return decodeWith(value, { known: options.bodies ?? BODIES, spins: SPIN_READER, gameTimeIn, readNews });
}

/**
 * The same for a server whose bodies have mass, radius, attitude and angular_velocity, and whose `game_time` is in s: a page loads
 * neither the game's bodies nor the readers of `spin_axis`, `rotation_period` and ISO 8601. `events` and `last_input` are skipped: a
 * predictor with `surfaceEvents` or `inputAcknowledgements` needs decodeFrameJson.
 *
 * @example
 * ```ts
 * const decoded = decodeLeanFrameJson(JSON.parse(text));
 * if (decoded.ok) predictor.receive(decoded.value, now);
 * ```
 */
export function decodeLeanFrameJson(value: unknown, options: FrameJsonOptions = {}): Result<DecodedFrame> {
  return decodeWith(value, { known: options.bodies ?? [] });
}

/** Readers and defaults of a frame. */
interface Readers extends Pick<BodyDefaults, 'known' | 'spins'> {
  /** Reads game time that may be ISO 8601. */
  readonly gameTimeIn?: typeof gameTimeIn;
  /** Reads events and the acknowledgement of inputs. */
  readonly readNews?: typeof readNews;
}

function decodeWith(value: unknown, readers: Readers): Result<DecodedFrame> {
  const mistaken = notPlain(value);
  if (mistaken !== null) return err(`message: expected a parsed JSON object, got ${mistaken}`);
  const r = beginReading('json');
  const from = fieldsOf(r, value);
  if (r.reason === null && valueIn(r, from, 'tick') === undefined)
    refuse(r, 'tick', wrapped(value, ['tick', 'ships']) ?? 'missing');
  const tick = integerIn(r, from, 'tick', 0, MAX_TICK);
  if (r.reason === null && valueIn(r, from, 'ships') === undefined) refuse(r, 'ships', 'missing');
  if (r.reason !== null) return endReading<DecodedFrame>(r, { kind: 'frame', tick, ships: [], refusals: [] });

  const pass: JsonPass = { refusals: [] };
  const ships = entriesIn(pass, from, {
    name: 'ships',
    most: MAX_SHIPS,
    key: 'ship_id',
    read: readShipState,
  });
  if (ships === undefined) return err(pass.refusals[0] ?? 'ships: missing');
  const tempo = readTempo(pass, from, readers);
  const bodies = readBodies(pass, from, { ...readers, time: timeOf(tick, tempo) });
  const news = readers.readNews?.(pass, from, tick);
  return endReading(r, { kind: 'frame', tick, ...tempo, ships, ...bodies, ...news, refusals: pass.refusals });
}

type Tempo = Pick<PartialFrame, 'tickRate' | 'timeScale' | 'gameTime' | 'paused'>;

function readBodies(pass: JsonPass, from: Fields, defaults: BodyDefaults): Pick<PartialFrame, 'bodies'> {
  const bodies = entriesIn(pass, from, {
    name: 'bodies',
    most: MAX_BODIES,
    key: 'name',
    read: (r, body) => readBodyJson(r, body, defaults),
  });
  return bodies === undefined ? {} : { bodies };
}

function readTempo(pass: JsonPass, from: Fields, readers: Readers): Tempo {
  const tickRate = partIn(pass, from, 'tick_rate', (r) => timing(r, from, 'tick_rate'));
  const timeScale = partIn(pass, from, 'time_scale', (r) => timing(r, from, 'time_scale'));
  const gameTime = partIn(pass, from, 'game_time', (r) =>
    (readers.gameTimeIn ?? secondsIn)(r, from, 'game_time'),
  );
  const paused = partIn(pass, from, 'paused', (r) => flagIn(r, from, 'paused'));
  return {
    ...(tickRate !== undefined && { tickRate }),
    ...(timeScale !== undefined && { timeScale }),
    ...(gameTime !== undefined && { gameTime }),
    ...(paused !== undefined && { paused }),
  };
}

function secondsIn(r: Reading, from: Fields, name: string): number {
  return numberIn(r, from, name, GAME_SECONDS);
}

/** One of the two, by itself, within its range (DYNAMICS, Time). */
function timing(r: Reading, from: Fields, name: 'tick_rate' | 'time_scale'): number {
  const value = numberIn(r, from, name, FINITE);
  refuseLoaded(
    r,
    name === 'tick_rate' ? loadTiming(value, 1, DEFAULT_SETTINGS) : loadTiming(1, value, DEFAULT_SETTINGS),
    '',
  );
  return value;
}

/** Game time, s, for bodies given by axis and period; if not sent, as if it had run evenly since tick 0. */
function timeOf(tick: number, { gameTime, timeScale = 1, tickRate = 1 }: Tempo): number {
  return gameTime ?? (tick * timeScale) / tickRate;
}

type News = Pick<PartialFrame, 'events' | 'lastInput'>;

function readNews(pass: JsonPass, from: Fields, tick: number): News {
  const events = entriesIn(pass, from, {
    name: 'events',
    most: MAX_EVENTS,
    key: null,
    read(r, sent) {
      const event = readEvent(r, sent, tick);
      if (event.tick > tick) refuse(r, 'tick', `expected at most the frame's own, ${tick}`);
      return event;
    },
  });
  const lastInput =
    from['last_input'] === null || from['lastInput'] === null
      ? null
      : partIn(pass, from, 'last_input', (r) =>
          messageIn(r, from, 'last_input', (reading, value) => readAcknowledgement(reading, value, tick)),
        );
  return {
    ...(events !== undefined && { events }),
    ...(lastInput !== undefined && { lastInput }),
  };
}

/** A frame for JSON.stringify: all fields of protobuf, in snake_case; decodeFrameJson restores it, except for the sign of −0. */
export function encodeFrameJson(frame: PartialFrame): Readonly<Record<string, unknown>> {
  return { ...frameFields(frame), ...(frame.lastInput === null && { last_input: null }) };
}
