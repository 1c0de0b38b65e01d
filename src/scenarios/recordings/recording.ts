import { ok, type Result, type Controls, loadControls, NEUTRAL_CONTROLS, err } from '../../dynamics';
import {
  type ClientMessage,
  decodeClientMessage,
  decodeFrameJson,
  decodeServerMessage,
  encodeClientMessage,
  encodeFrameJson,
  encodeServerMessage,
  type PartialFrame,
  type ServerFrame,
  type ServerMessage,
} from '../../wire';
import { fromBase64, toBase64 } from './base64';
import { readCall, type RecordedCall } from './recordedCall';
import { createFields, type Fields, type JsonRecord } from '../fixtures/fields';
import type { ScheduledInput } from '../runTick';

/**
 * Everything a client received, sent and simulated, with times: a predictor fed with it reproduces the session (PREDICTION, Diagnosis). The
 * file consists of JSON lines, the header first; messages are the protocol's bytes in base64; controls are written only when they change.
 */
export interface Recording {
  readonly header: RecordingHeader;
  /** Ascending in time. */
  readonly entries: readonly RecordingEntry[];
}

export interface RecordingHeader {
  /** The recording's origin, for readers. */
  readonly note: string;
  /** The player's ship. */
  readonly shipId: string;
  /** Inputs scheduled in advance, which apply until the first one sent. */
  readonly plan?: readonly ScheduledInput[];
}

/** `at`: wall seconds of the client. */
export type RecordingEntry =
  | { readonly kind: 'received'; readonly at: number; readonly message: ServerMessage | PartialFrame }
  | { readonly kind: 'sent'; readonly at: number; readonly message: ClientMessage }
  /** A frame of the page, with the controls held then; null for a spectator. */
  | { readonly kind: 'advanced'; readonly at: number; readonly controls: Controls | null }
  /** A call that changed the prediction, for instance a change of the player's ship. */
  | { readonly kind: 'called'; readonly at: number; readonly call: RecordedCall };

const FORMAT = 'touchdown-recording';
const VERSION = 1;
/** Several hours at 60 Hz, with messages. */
const MAX_LINES = 1_000_000;
/** Characters of a frame of five thousand ships; a longer line of brackets would keep the parser busy for seconds. */
const MAX_LINE_LENGTH = 2_000_000;
const MAX_PLANNED = 10_000;

/** Writes a recording line by line: each call returns one line with its line feed. */
export interface RecordingWriter {
  readonly header: (header: RecordingHeader) => string;
  readonly entry: (entry: RecordingEntry) => string;
}

export function createRecordingWriter(): RecordingWriter {
  let controls = 'none yet';

  function advanced(entry: RecordingEntry & { kind: 'advanced' }): Record<string, unknown> {
    const now = JSON.stringify(entry.controls);
    if (now === controls) return { kind: entry.kind, at: entry.at };
    controls = now;
    return { kind: entry.kind, at: entry.at, controls: entry.controls };
  }

  function plain(entry: RecordingEntry): Record<string, unknown> {
    const { kind, at } = entry;
    if (kind === 'received') return { kind, at, ...received(entry.message) };
    if (kind === 'called') return { kind, at, call: entry.call };
    return kind === 'sent'
      ? { kind, at, bytes: toBase64(encodeClientMessage(entry.message)) }
      : advanced(entry);
  }

  return {
    header: ({ note, shipId, plan = [] }) => {
      const planned = plan.length === 0 ? {} : { plan };
      return line({ kind: 'header', format: FORMAT, version: VERSION, note, shipId, ...planned });
    },
    entry: (entry) => line(plain(entry)),
  };
}

export function writeRecording({ header, entries }: Recording): string {
  const writer = createRecordingWriter();
  return writer.header(header) + entries.map((entry) => writer.entry(entry)).join('');
}

/** The protocol's bytes; for a partial frame, the server's JSON. */
function received(message: ServerMessage | PartialFrame): Record<string, unknown> {
  return isWhole(message)
    ? { bytes: toBase64(encodeServerMessage(message)) }
    : { frame: encodeFrameJson(message) };
}

/** Whether a message has all fields of the protocol's bytes. */
export function isWhole(message: ServerMessage | PartialFrame): message is ServerMessage {
  if (message.kind !== 'frame') return true;
  const { tickRate, timeScale, paused, bodies, events, lastInput } = message as Partial<ServerFrame>;
  return [tickRate, timeScale, paused, bodies, events, lastInput].every((part) => part !== undefined);
}

/** A recording from its file's text, or a reason that names the line and the field. */
export function readRecording(text: string): Result<Recording> {
  const lines = text.split('\n');
  if (lines.at(-1) === '') lines.pop();
  if (lines.length > MAX_LINES) return err(`lines: expected at most ${MAX_LINES}, got ${lines.length}`);
  const first = readLine(lines[0] ?? '', readHeader);
  if (!first.ok) return err(`line 1: ${first.reason}`);
  const entries: RecordingEntry[] = [];
  const past: Past = { at: -Infinity, controls: undefined };
  for (let i = 1; i < lines.length; i++) {
    const entry = readLine(lines[i]!, (fields, given) => readEntry(fields, given, past));
    if (!entry.ok) return err(`line ${i + 1}: ${entry.reason}`);
    entries.push(entry.value);
  }
  return ok({ header: first.value, entries });
}

/** State of earlier lines that a line depends on. */
interface Past {
  at: number;
  controls: Controls | null | undefined;
}

function line(value: Record<string, unknown>): string {
  return `${JSON.stringify(value)}\n`;
}

function readLine<T>(text: string, read: (fields: Fields, given: JsonRecord) => T): Result<T> {
  if (text.length > MAX_LINE_LENGTH)
    return err(`expected at most ${MAX_LINE_LENGTH} characters, got ${text.length}`);
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return err('not JSON');
  }
  const fields = createFields();
  const value = read(fields, fields.record(json, 'line'));
  const reason = fields.reason();
  return reason === null ? ok(value) : err(reason);
}

function readHeader(fields: Fields, given: JsonRecord): RecordingHeader {
  fields.choice(given['kind'], 'kind', ['header']);
  fields.choice(given['format'], 'format', [FORMAT]);
  if (given['version'] !== VERSION) fields.fault('version', `expected ${VERSION}`);
  const note = fields.text(given['note'], 'note');
  const shipId = fields.text(given['shipId'], 'shipId');
  const plan = given['plan'] === undefined ? [] : readPlan(fields, given['plan']);
  return { note, shipId, ...(plan.length === 0 ? {} : { plan }) };
}

/** Reads a plan, which must ascend in time. */
function readPlan(fields: Fields, given: unknown): ScheduledInput[] {
  let before = { tick: 0, substep: 0 };
  return fields.list(given, 'plan', MAX_PLANNED).map(({ value, path }) => {
    const input = fields.record(value, path);
    const tick = fields.whole(input['tick'], `${path}.tick`, before.tick);
    const least = tick === before.tick ? before.substep : 0;
    const substep = fields.whole(input['substep'], `${path}.substep`, least);
    before = { tick, substep };
    const controls = loadControls(
      fields.record(input['controls'], `${path}.controls`) as unknown as Controls,
    );
    if (!controls.ok) fields.fault(path, `controls.${controls.reason}`);
    return { tick, substep, controls: controls.ok ? controls.value : NEUTRAL_CONTROLS };
  });
}

function readEntry(fields: Fields, given: JsonRecord, past: Past): RecordingEntry {
  const at = fields.number(given['at'], 'at');
  if (at < past.at) fields.fault('at', `expected ascending times, at least ${past.at}, got ${at}`);
  past.at = at;
  const kind = fields.choice(given['kind'], 'kind', ['advanced', 'received', 'sent', 'called']);
  if (kind === 'called') return { kind, at, call: readCall(fields, fields.record(given['call'], 'call')) };
  if (kind === 'advanced') return { kind, at, controls: readControls(fields, given, past) };
  if (kind === 'received' && given['frame'] !== undefined) return readPartialFrame(fields, given, at);
  const bytes = fromBase64(given['bytes']);
  if (bytes === null) fields.fault('bytes', 'expected base64');
  const message =
    kind === 'received' ? decodeServerMessage(bytes ?? EMPTY) : decodeClientMessage(bytes ?? EMPTY);
  if (!message.ok) {
    fields.fault('bytes', message.reason);
    return { kind: 'advanced', at, controls: null };
  }
  return { kind, at, message: message.value } as RecordingEntry;
}

function readPartialFrame(fields: Fields, given: JsonRecord, at: number): RecordingEntry {
  const decoded = decodeFrameJson(given['frame']);
  if (!decoded.ok || decoded.value.refusals.length > 0) {
    fields.fault('frame', decoded.ok ? decoded.value.refusals[0]! : decoded.reason);
    return { kind: 'advanced', at, controls: null };
  }
  return { kind: 'received', at, message: decoded.value };
}

const EMPTY = new Uint8Array(0);

function readControls(fields: Fields, given: JsonRecord, past: Past): Controls | null {
  if (given['controls'] === undefined && past.controls !== undefined) return past.controls;
  if (given['controls'] === null) return (past.controls = null);
  const checked = loadControls(fields.record(given['controls'], 'controls') as unknown as Controls);
  if (!checked.ok) {
    fields.fault('controls', checked.reason);
    return null;
  }
  return (past.controls = checked.value);
}
