import { BODY_STRIDE, err, loadControls, ok, readBodyMotion, type Result } from '../../dynamics';
import type { Hello, InputRecord, PartialFrame, ServerMessage } from '../../wire';
import { resend, store } from '../inputs/inputs';
import { describe } from '../checks/describe';
import { changeOwnShip, resetSession } from '../ownership';
import type { Session } from '../session';
import type { Policy } from '../simulation/track';
import { boundaryAt } from '../snapshots/bodies/bodyTrack';
import { receiveMessage } from '../snapshots/receiveMessage';
import { spanOf } from '../time/timeline';
import { changePolicy } from './policy';

/** The last messages of a predictor as plain data for JSON.stringify: enough to continue from in another page or worker. */
export interface PredictorSnapshot {
  readonly version: 1;
  /** '' for a spectator. */
  readonly ownShipId: string;
  /** null if the server has sent none. */
  readonly hello: Hello | null;
  /** The newest frame; null if none has arrived. */
  readonly frame: PartialFrame | null;
  /** Wall s since it arrived. */
  readonly age: number;
  /** Own inputs that the server has not acknowledged. */
  readonly inputs: readonly InputRecord[];
  /** Number of the next input. */
  readonly nextSeq: number;
  /** Ships that are not predicted, by id. */
  readonly policies?: Readonly<Record<string, Policy>>;
  /** False if the frame's bodies are assumed: game time that was not sent passed before it. */
  readonly bodiesKnown?: boolean;
}

/** The messages that make up a snapshot, kept as they arrive. */
export interface LatestMessages {
  hello: Hello | null;
  frame: PartialFrame | null;
  frameAt: number;
}

export function createLatestMessages(): LatestMessages {
  return { hello: null, frame: null, frameAt: Number.NaN };
}

/** Receives a message, and keeps it for a later snapshot unless it was refused or is not of the newest tick. */
export function receiveAndKeep(
  session: Session,
  kept: LatestMessages,
  message: ServerMessage | PartialFrame,
  now: number,
): void {
  const { counters } = session;
  const [refused, accepted] = [counters.framesRefused, counters.framesAccepted];
  receiveMessage(session, message, now);
  if (counters.framesRefused > refused) return;
  const kind: unknown = (message as { kind?: unknown } | null | undefined)?.kind;
  if (kind === 'hello') kept.hello = message as Hello;
  const frame = message as PartialFrame;
  const isNewest = counters.framesAccepted > accepted && frame.tick === session.sim.newestTick;
  if (kind !== 'frame' || !isNewest) return;
  kept.frame = kept.frame?.tick === frame.tick ? joined(kept.frame, frame) : frame;
  kept.frameAt = now;
}

/** Two messages of one tick are parts of one frame. */
function joined(before: PartialFrame, frame: PartialFrame): PartialFrame {
  const ships = shipsOf(frame);
  const ids = new Set(ships.map(({ shipId }) => shipId));
  const others = shipsOf(before).filter(({ shipId }) => !ids.has(shipId));
  return { ...before, ...frame, ships: [...others, ...ships] };
}

/** A JavaScript caller may pass anything as the list of ships. */
function shipsOf({ ships }: PartialFrame): PartialFrame['ships'] {
  const isShip = (ship: unknown): boolean => typeof ship === 'object' && ship !== null;
  return Array.isArray(ships) ? (ships as PartialFrame['ships']).filter(isShip) : [];
}

/** The snapshot at client wall second `now`. */
export function snapshotOf(session: Session, kept: LatestMessages, now: number): PredictorSnapshot {
  const { receiver, sim } = session;
  const { records, applied, nextSeq } = sim.inputs;
  const age = now - kept.frameAt;
  return {
    version: 1,
    ownShipId: receiver.ownShipId,
    hello: kept.hello,
    frame: kept.frame === null || sim.newestTick < 0 ? null : completed(session, kept.frame),
    age: kept.frame !== null && age > 0 ? age : 0,
    inputs: records.map(({ record }) => record).filter(({ seq }) => seq > applied),
    nextSeq,
    policies: Object.fromEntries(receiver.policies),
    bodiesKnown: sim.bodiesKnown,
  };
}

/** The frame, completed with the tempo and the bodies at its tick. */
function completed({ sim }: Session, frame: PartialFrame): PartialFrame {
  const { tickRate, timeScale, paused } = spanOf(sim.timeline, sim.newestTick);
  const rows = boundaryAt(sim.bodies, sim.timeline, sim.newestTick);
  const bodies = sim.world.bodies.map(({ name, mass, radius }, i) => ({
    name,
    mass,
    radius,
    ...readBodyMotion(rows, i * BODY_STRIDE),
  }));
  return { ...frame, tickRate, timeScale, paused, bodies };
}

/** Continues from a snapshot, which may be untrusted; returns an error that names the invalid field. */
export function restoreSnapshot(
  session: Session,
  kept: LatestMessages,
  given: unknown,
  now: number,
): Result<null> {
  if (Number.isNaN(now)) return err('now: expected finite wall s');
  const reason = faultOf(given);
  if (reason !== null) {
    session.warn('restore-refused', `snapshot.${reason}. Nothing was changed.`, { reason });
    return err(`snapshot.${reason}`);
  }
  const { hello, frame, age, ownShipId, inputs, nextSeq, policies, bodiesKnown } = given as PredictorSnapshot;
  resetSession(session);
  session.receiver.policies.clear();
  for (const [shipId, policy] of Object.entries(policies ?? {})) changePolicy(session, shipId, policy);
  for (const message of [hello, frame])
    if (message !== null) receiveAndKeep(session, kept, message, now - age);
  if (bodiesKnown === false) session.sim.bodiesKnown = false;
  changeOwnShip(session, ownShipId);
  const own = session.sim.inputs;
  for (const record of inputs) {
    const controls = loadControls(record.controls);
    if (!controls.ok) continue;
    own.nextSeq = record.seq;
    store(own, controls.value, record, now, session.clock.steer);
  }
  own.nextSeq = Math.max(own.nextSeq, nextSeq);
  resend(own);
  return ok(null);
}

function faultOf(given: unknown): string | null {
  if (typeof given !== 'object' || given === null)
    return `version: expected 1, got ${describe(given)}; parse a string with JSON.parse`;
  const { version, hello, frame, age, ownShipId, inputs, nextSeq, policies } =
    given as Partial<PredictorSnapshot>;
  if (version !== 1) return `version: expected 1, got ${String(version)}`;
  if (typeof ownShipId !== 'string') return 'ownShipId: expected a string';
  if (hello === undefined || frame === undefined) return 'hello, frame: expected a message or null';
  if (typeof age !== 'number' || !(age >= 0)) return 'age: expected a number ≥ 0';
  if (!Array.isArray(inputs) || !inputs.every(isInput)) return 'inputs: expected a list of inputs';
  if (!isCount(nextSeq)) return 'nextSeq: expected a whole number ≥ 1';
  if (policies !== undefined && (typeof policies !== 'object' || (policies as object | null) === null))
    return 'policies: expected predict, interpolate or hold for each ship id';
  return null;
}

function isInput(given: unknown): boolean {
  const record = given as InputRecord | null;
  if (typeof record !== 'object' || record === null) return false;
  const { seq, tick, substep, controls } = record;
  const isRecord = typeof controls === 'object' && (controls as object | null) !== null;
  return isCount(seq) && isCount(tick + 1) && isCount(substep + 1) && isRecord;
}

function isCount(value: unknown): boolean {
  return Number.isSafeInteger(value) && (value as number) >= 1;
}
