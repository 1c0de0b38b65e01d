import { describe, expect, it } from 'vitest';
import { CRASHED, POSITION, SURFACE_STATE, SURFACE_STATES, VELOCITY } from '../../../src/dynamics';
import { fitGround } from '../../../src/prediction/ground/fit';
import { learnGround } from '../../../src/prediction/ground/learn';
import {
  beginReading,
  createLearnedGround,
  type GroundPlace,
} from '../../../src/prediction/ground/learnedGround';
import { keepState } from '../../../src/prediction/ground/lastState';
import { createObservation, observe } from '../../../src/prediction/ground/observe';
import { replayTo } from '../../../src/prediction/ground/trial';
import type { Simulation } from '../../../src/prediction/simulation/simulation';
import type { Track } from '../../../src/prediction/simulation/track';
import { boundaryAt } from '../../../src/prediction/snapshots/bodies/bodyTrack';
import { sessionAt, shipAt } from './sessionAt';

const TICK = 100;
/** Ticks of 0.1 s from the first state, 6 m above flat ground and sinking at 2.5 m/s, to one on the ground. */
const FALL = 22;

/** A ship, and the server's state of it `ticks` later on ground `rise` m above ours. */
function fallen(rise: number, ticks = FALL, shipId = 'own') {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, shipId, '');
  track.own = shipId === 'own';
  keepState(track.evidence, track.serverRow, TICK);
  const server = { ...sim, world: { ...sim.world, terrainHeight: () => rise } };
  const to = { from: track.serverRow, fromTick: TICK, toTick: TICK + ticks };
  const row = replayTo(server, track, to).slice();
  const learn = () => {
    learnState(sim, track, row, TICK + ticks);
    return track.ground.places;
  };
  return { sim, track, row, learn };
}

function learnState(sim: Simulation, track: Track, row: Float64Array, tick: number): void {
  const bodies = boundaryAt(sim.bodies, sim.timeline, tick);
  learnGround(sim, track, { row, tick, bodies, now: 5, hasImpact: true });
}

/** Lifts a row along its radius, m. */
function lift(row: Float64Array, metres: number): void {
  const distance = Math.hypot(row[POSITION]!, row[POSITION + 1]!, row[POSITION + 2]!);
  for (let k = 0; k < 3; k++) row[POSITION + k] = row[POSITION + k]! * (1 + metres / distance);
}

/** Height of its feet above our ground, m. */
function feetOf(sim: Simulation, row: Float64Array): number {
  const seen = createObservation();
  observe(seen, row, boundaryAt(sim.bodies, sim.timeline, TICK), sim.world);
  return seen.feet;
}

describe('the ground between two states', () => {
  it.each([0.4, -0.4, 1, -1])('%f m higher is found by the replay', (rise) => {
    const { row, learn } = fallen(rise);
    expect(SURFACE_STATES[row[SURFACE_STATE]!]).not.toBe('');
    const [place] = learn();
    expect(Math.abs(place!.offset - rise)).toBeLessThan(0.02);
    expect(place!.states).toBe(1);
  });

  it('is not learned if our ground explains them, nor from a crash', () => {
    expect(fallen(0).learn()).toEqual([]);
    const crashed = fallen(0.4);
    crashed.row[CRASHED] = 1;
    expect(crashed.learn()).toEqual([]);
  });

  it('is confirmed by each state that it explains', () => {
    const { sim, track, row, learn } = fallen(0.4);
    learn();
    keepState(track.evidence, row, TICK + FALL);
    const server = { ...sim, world: { ...sim.world, terrainHeight: () => 0.4 } };
    const bare = { ...track, ground: createLearnedGround() };
    const next = replayTo(server, bare, { from: row, fromTick: TICK + FALL, toTick: TICK + FALL + 10 });
    learnState(sim, track, next.slice(), TICK + FALL + 10);
    expect(track.ground.places.map(({ states }) => states)).toEqual([2]);
  });

  it('is fitted for other pilots’ ships within a frame’s budget', () => {
    const { sim, learn } = fallen(0.4, FALL, 'other');
    expect(learn()).toHaveLength(1);
    expect(sim.learning).toEqual({ tick: TICK + FALL, spent: 10 * FALL * 20 });
    sim.learning.spent = 7_900;
    const second = shipAt(sim, 'second', '');
    keepState(second.evidence, second.serverRow, TICK);
    const flying = second.serverRow.slice();
    learnState(sim, second, flying, TICK + FALL);
    expect(second.ground.places).toEqual([]);
    expect(sim.learning.spent).toBe(7_900);
  });
});

describe('a state alone', () => {
  function alone(state: 'landed' | 'contact' | '', feet: number, climb = 0) {
    const { sim, track } = fallen(0);
    track.evidence.tick = -1;
    const row = track.serverRow.slice();
    row[SURFACE_STATE] = SURFACE_STATES.indexOf(state);
    lift(row, feet - feetOf(sim, row));
    const bodies = boundaryAt(sim.bodies, sim.timeline, TICK);
    const seen = createObservation();
    observe(seen, row, bodies, sim.world);
    for (let k = 0; k < 3; k++)
      row[VELOCITY + k] =
        row[VELOCITY + k]! +
        ((climb - seen.climb) * row[POSITION + k]!) / Math.hypot(...row.slice(POSITION, POSITION + 3));
    learnState(sim, track, row, TICK);
    return track.ground.places.map(({ offset }) => offset);
  }

  it('landed: the ground is below its feet, by the static depth of its spring', () => {
    expect(alone('landed', 0.5)[0]).toBeCloseTo(0.5 + 1.62 / 100, 3);
    expect(alone('landed', 0.03)).toEqual([]);
  });

  it('in contact above our ground: the ground is there; in contact below it: nothing is learned', () => {
    expect(alone('contact', 0.5, -3)[0]).toBeCloseTo(0.5, 6);
    expect(alone('contact', -0.5, -3)).toEqual([]);
  });

  it('falling below our ground: the ground is lower; climbing it may be our timing', () => {
    expect(alone('', -0.5, -3)[0]).toBeCloseTo(-0.5, 6);
    expect(alone('', -0.5, 3)).toEqual([]);
    expect(alone('', 0.5, -3)).toEqual([]);
  });
});

describe('the fit', () => {
  function fit(rise: number, guess: number, scans: boolean) {
    const { sim, track, row } = fallen(rise);
    const seen = createObservation();
    observe(seen, row, boundaryAt(sim.bodies, sim.timeline, TICK + FALL), sim.world);
    beginReading(track.ground);
    const { name, radius } = sim.world.bodies[0]!;
    const place: GroundPlace = {
      bodyName: name,
      bodyRadius: radius,
      direction: seen.direction.slice(),
      slope: new Float64Array(3),
      offset: 0,
      states: 1,
      seenAt: 0,
      weight: 1,
    };
    const evidence = { from: track.evidence.row, fromTick: TICK, to: row, toTick: TICK + FALL };
    const task = { sim, track, evidence, seen, place };
    const cost = fitGround(task, track.ground, [{ offset: guess, slope: 0 }], scans);
    return { cost, offset: place.offset, left: track.ground.places.length };
  }

  it('refines the best guess, and leaves the ground as it was', () => {
    const { cost, offset, left } = fit(0.4, 0.3, false);
    expect(cost).toBeLessThan(0.1);
    expect(offset).toBeCloseTo(0.4, 2);
    expect(left).toBe(0);
  });

  it('scans other offsets if no guess is near', () => {
    const scanned = fit(1.1, -2, true);
    expect(scanned.cost).toBeLessThan(0.1);
    expect(scanned.offset).toBeCloseTo(1.1, 2);
    expect(fit(1.1, -2, false).cost).toBeGreaterThan(1);
  });
});
