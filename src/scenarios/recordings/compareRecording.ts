import {
  ok,
  beginTick,
  BODIES,
  BODY_STRIDE,
  type Result,
  type Controls,
  EVENT_NAMES,
  loadControls,
  loadWorld,
  NO_EVENT,
  readControls,
  readShip,
  type ShipInit,
  err,
  SHIP_CLASSES,
  SHIP_STRIDE,
  stepWorld,
  TERRAINS,
  timingOfTick,
  type Vec3,
  type World,
  writeBodyMotion,
  writeControls,
  writeShip,
} from '../../dynamics';
import type { ServerFrame, ShipState } from '../../wire';
import { type Compared, type Comparison, noDifferences, raise } from '../fixtures/compareFixture';
import { type RecordedSession, sessionsOf } from './recordedSessions';
import type { Recording } from './recording';
import type { ScheduledInput } from '../runTick';

/** How a server's states compare with the dynamics, interval by interval. */
export interface RecordingComparison extends Comparison {
  /** Intervals not compared: inputs that are not in the recording changed the ship's controls. */
  readonly unknownInputs: number;
  /** Intervals not compared: the state has no fields 33 and 34, so it is not exact. */
  readonly withoutRelativeState: number;
}

/**
 * Simulates one interval from each frame with a successor, and compares the result with it. Frames may be missing, doubled or out
 * of order; an interval needs both its ends under one hello. An interval across a new hello is not compared, since either config may
 * have been in force.
 * @returns a reason if nothing could be compared
 */
export function compareRecording(recording: Recording): Result<RecordingComparison> {
  const found: Found = {
    ticks: 0,
    statesCompared: 0,
    unknownInputs: 0,
    withoutRelativeState: 0,
    worst: noDifferences(),
    outOfTolerance: null,
    disagreement: null,
  };
  const sessions = sessionsOf(recording);
  if (sessions.every(({ frames }) => frames.size === 0)) return err('no frame');
  for (const session of sessions) {
    const reason = session.frames.size > 0 ? compareSession(found, session, recording.header.shipId) : null;
    if (reason !== null) return err(reason);
  }
  if (found.statesCompared === 0) return err('no interval of any ship could be compared');
  return ok(found);
}

type Found = { -readonly [Field in keyof RecordingComparison]: RecordingComparison[Field] };

/** Adds a session's intervals to `found`, or returns the reason why it cannot be compared. */
function compareSession(found: Found, session: RecordedSession, own: string): string | null {
  const { frames } = session;
  const world = worldOf(session);
  if (!world.ok) return world.reason;
  found.ticks += frames.size;
  for (const tick of [...frames.keys()].sort((a, b) => a - b)) {
    const [from, to] = [frames.get(tick)!, frames.get(tick + 1)];
    if (to === undefined) continue;
    for (const expected of to.ships) {
      const start = from.ships.find(({ shipId }) => shipId === expected.shipId);
      if (start === undefined) continue;
      if (start.relativePosition === null || expected.relativePosition === null) {
        found.withoutRelativeState += 1;
        continue;
      }
      const inputs = expected.shipId === own ? (session.inputs.get(tick) ?? []) : [];
      const outcome = runInterval(world.value, from, start, inputs);
      if (!outcome.ok) return `tick ${tick}: ship ${expected.shipId}: ${outcome.reason}`;
      if (!sameControls(outcome.value.controls, expected as Controls)) {
        found.unknownInputs += 1;
        continue;
      }
      found.statesCompared += 1;
      const deviation = raise(found.worst, outcome.value.ship, comparedOf(expected));
      if (deviation !== null) found.outOfTolerance ??= { tick: tick + 1, ...deviation };
      const how = otherOutcome(outcome.value, expected, to);
      if (how !== null) found.disagreement ??= { tick: tick + 1, how: `${expected.shipId}: ${how}` };
    }
  }
  return null;
}

interface Outcome {
  readonly ship: ReturnType<typeof readShip>;
  readonly controls: Controls;
  readonly events: readonly string[];
}

const reported = new Uint8Array(1);

function runInterval(
  world: World,
  frame: ServerFrame,
  start: ShipState,
  inputs: readonly ScheduledInput[],
): Result<Outcome> {
  const row = new Float64Array(SHIP_STRIDE);
  const bodies = new Float64Array(world.bodies.length * BODY_STRIDE);
  for (const [i, { name }] of world.bodies.entries()) {
    const motion = frame.bodies.find((body) => body.name === name);
    if (motion === undefined) return err(`bodies: no ${name} in the frame`);
    const reason = writeBodyMotion(bodies, i * BODY_STRIDE, motion);
    if (reason !== null) return err(`bodies.${name}.${reason}`);
  }
  const commanded = loadControls(start as Controls);
  if (!commanded.ok) return err(commanded.reason);
  const given = {
    ...start,
    ...comparedOf(start),
    groundContactOffset: start.groundContactOffset ?? undefined,
  };
  const reason = writeShip(row, 0, given as ShipInit, world);
  if (reason !== null) return err(reason);
  writeControls(row, 0, commanded.value);
  const { substeps, dt } = timingOfTick(
    frame.timeScale / frame.tickRate,
    world.settings.contactLongestSubstep,
  );
  const events: string[] = [];
  beginTick(row, bodies, world);
  for (let s = 0; s < substeps; s++) {
    for (const { substep, controls } of inputs) if (substep === s) writeControls(row, 0, controls);
    stepWorld(row, bodies, reported, world, dt);
    if (reported[0] !== NO_EVENT) events.push(EVENT_NAMES[reported[0]!]!);
  }
  return ok({ ship: readShip(row, 0, world), controls: readControls(row, 0), events });
}

/** The world of the session's hello; without one, the game's own classes and bodies, default settings and level ground. */
function worldOf({ hello, frames }: RecordedSession): Result<World> {
  const terrain = hello?.terrain ?? 'flat';
  if (!Object.hasOwn(TERRAINS, terrain)) return err(`terrain: no terrain named ${terrain}`);
  const [first] = frames.values();
  return loadWorld({
    settings: hello?.settings ?? {},
    shipClasses: hello?.shipClasses ?? SHIP_CLASSES,
    bodies: hello?.bodies ?? BODIES.filter(({ name }) => first?.bodies.some((body) => body.name === name)),
    terrainHeight: TERRAINS[terrain]!,
  });
}

const NO_MOMENTUM: Vec3 = [0, 0, 0];

function comparedOf(
  state: ShipState,
): Compared & { relativePosition: NonNullable<ShipState['relativePosition']> } {
  return {
    relativePosition: state.relativePosition!,
    relativeVelocity: state.relativeVelocity!,
    attitude: state.attitude,
    angularVelocity: state.angularVelocity,
    fuel: state.fuel,
    wheelMomentum: state.wheelMomentum ?? NO_MOMENTUM,
    contactImpactSpeed: state.contactImpactSpeed ?? 0,
  };
}

function otherOutcome({ ship, events }: Outcome, expected: ShipState, frame: ServerFrame): string | null {
  if (ship.crashed !== expected.crashed) return `crashed ${ship.crashed}, expected ${expected.crashed}`;
  if (ship.surfaceContactState !== expected.surfaceContactState)
    return `state '${ship.surfaceContactState}', expected '${expected.surfaceContactState}'`;
  const expectedEvents = frame.events
    .filter(({ shipId }) => shipId === expected.shipId)
    .map(({ type }) => type);
  return events.join() === expectedEvents.join()
    ? null
    : `events ${events.join(', ') || 'none'}, expected ${expectedEvents.join(', ') || 'none'}`;
}

function sameControls(a: Controls, b: Controls): boolean {
  const values = ({ thrustLevel, attitudeHold, attitudeMode, ...vectors }: Controls) =>
    JSON.stringify([
      thrustLevel,
      attitudeHold,
      attitudeMode,
      vectors.translationInput,
      vectors.rotationInput,
      vectors.targetAttitude,
    ]);
  return values(a) === values(b);
}
