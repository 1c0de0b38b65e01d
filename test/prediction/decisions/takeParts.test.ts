import { expect, it } from 'vitest';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { receiveRest, takeShips } from '../../../src/prediction/snapshots/takeParts';
import { frameAt, STILL } from '../faults/restingShip';
import { RATE, sessionAt } from './sessionAt';

const TICK = 100;

it('takes at most 1,000 new ships of a frame at once, the rest later; the player’s and known ones always', () => {
  const { sim, receiver } = sessionAt(TICK);
  const bodies = boundaryAt(sim.bodies, sim.timeline, TICK);
  Object.assign(receiver.context, { tick: TICK, bodies, predictedBodies: bodies });
  const ids = [...Array.from({ length: 1001 }, (_, i) => `other ${i}`), 'own'];
  const frame = frameAt(TICK, RATE, { ships: ids.map((shipId) => ({ ...STILL, shipId })) });
  const left = () => receiver.rest?.frame.ships.map(({ shipId }) => shipId);
  takeShips(sim, receiver, frame);
  expect(left()).toEqual(['other 1000']);
  expect(sim.fleet.own?.shipId).toBe('own');
  expect(sim.fleet.tracks).toHaveLength(1001);
  receiveRest(sim, receiver);
  expect(left()).toBeUndefined();
  expect(sim.fleet.tracks).toHaveLength(1002);
  takeShips(sim, receiver, frame);
  expect(left()).toBeUndefined();
});
