import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  FUEL,
  GROUND_CONTACT_OFFSET,
  IMPACT_SPEED,
  POSITION,
  readControls,
  SHIP_STRIDE,
  THRUST_LEVEL,
  VELOCITY,
  WHEEL_MOMENTUM,
} from '../../../../src/dynamics';
import { keep } from '../../../../src/prediction/simulation/rings/history';
import { placeAsleep, sleepIfAtRest } from '../../../../src/prediction/simulation/sleep';
import { boundaryAt } from '../../../../src/prediction/snapshots/bodies/bodyTrack';
import { reconcile } from '../../../../src/prediction/snapshots/reconcile/reconcile';
import type { ShipState } from '../../../../src/wire';
import { STILL } from '../../faults/restingShip';
import { sessionAt, shipAt } from '../../decisions/sessionAt';

export const TICK = 100;
/** Substeps of a tick. */
export const SUBSTEPS = 10;

/** A ship that was predicted as the server has it at TICK, seen last at second 3; the frame arrives at second 5. */
export function predicted(state: '' | 'landed' = '', { own = true } = {}) {
  const { sim, receiver } = sessionAt(TICK);
  const track = shipAt(sim, own ? 'own' : 'other', state);
  track.own = own;
  track.serverTick = TICK - 1;
  track.seenAt = 3;
  // Of its present state, which began long ago.
  sim.front.tick = TICK + 2;
  const { world } = sim;
  const bodies = boundaryAt(sim.bodies, sim.timeline, TICK);
  const row = track.serverRow.slice();
  if (state === 'landed') {
    // At rest on the turning ground.
    sleepIfAtRest(sim, track, bodies);
    placeAsleep({ rows: row, at: 0, bodies }, sim, track, { tick: TICK, bodies });
    track.mode = 'stepping';
    track.serverRow.set(row);
  }
  row[THRUST_LEVEL] = own ? 0 : 0.5;
  sim.fleet.front.set(row, track.at);
  keep(track.history, TICK, row, 0);
  const context = Object.assign(receiver.context, { tick: TICK, now: 5, bodies, predictedBodies: bodies });
  const slot = (TICK % track.history.length) * SHIP_STRIDE;
  const kept = track.history.rows.subarray(slot, slot + SHIP_STRIDE);
  const part = (column: number, count: number) => [...row.subarray(column, column + count)];
  const sent = {
    ...STILL,
    ...readControls(row, 0),
    name: 'Eagle',
    playerId: 'neil',
    shipClass: world.shipClasses[0]!.name,
    referenceBody: world.bodies[0]!.name,
    landedBodyName: state === '' ? '' : world.bodies[0]!.name,
    surfaceContactState: state,
    relativePosition: part(POSITION, 3),
    relativeVelocity: part(VELOCITY, 3),
    attitude: part(ATTITUDE, 4),
    angularVelocity: part(ANGULAR_VELOCITY, 3),
    fuel: row[FUEL]!,
    wheelMomentum: part(WHEEL_MOMENTUM, 3),
    groundContactOffset: row[GROUND_CONTACT_OFFSET]!,
    contactImpactSpeed: row[IMPACT_SPEED]!,
  } as unknown as ShipState;
  const take = (more: Partial<ShipState> = {}) => reconcile(sim, track, { ...sent, ...more }, context);
  return { sim, track, sent, context, kept, take, counters: sim.counters };
}
export type Predicted = ReturnType<typeof predicted>;

export const corrected = ({ counters: c }: Predicted) => ({
  late: c.correctionsLateInput,
  lost: c.correctionsLostInput,
  other: c.correctionsOtherPilot,
  mismatch: c.correctionsMismatch,
});
export const NONE = { late: 0, lost: 0, other: 0, mismatch: 0 };
